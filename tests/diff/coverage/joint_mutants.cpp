// SPDX-License-Identifier: MIT
//
// Ruling 14: what two lines that go on in one direction may not do together, though each of them
// holds rulings 1 and 2.
#include <algorithm>

#include "rules/coverage/segment.h"
#include "tests/diff/coverage/fragment_changes.h"

namespace edgecase {
namespace {

// The lines of a joint: the first two that draw something.
struct Pair {
  int first = 0;
  int second = 0;
  bool x_major = true;
};

Pair pair_of(const Scene& scene, const Fragments& fragments) {
  Pair pair;
  const auto primitives = primitives_of(scene);
  pair.x_major =
      Segment{primitives[0].vertices[0]->position, primitives[0].vertices[1]->position}.x_major();
  const auto draws = [&](int primitive) {
    return std::any_of(fragments.begin(), fragments.end(),
                       [&](const Fragment& f) { return f.primitive == primitive; });
  };
  pair.second = 1;
  while (!draws(pair.second)) ++pair.second;
  return pair;
}

Fragment last_of_first(const Scene& scene, Fragments& f) {
  return *end_of(scene, f, pair_of(scene, f).first, true);
}

Fragment first_of_second(const Scene& scene, Fragments& f) {
  return *end_of(scene, f, pair_of(scene, f).second, false);
}

void draw_of(int primitive, const Scene& scene, int x, int y, Fragments& fragments) {
  fragments.push_back(fragment_at(scene, primitive, x, y));
}

void draw_last(const Scene& scene, Fragments& f) {
  const Fragment at = first_of_second(scene, f);
  draw_of(pair_of(scene, f).first, scene, at.x, at.y, f);
}

void draw_one_back(const Scene& scene, Fragments& f) {
  const Fragment at = last_of_first(scene, f);
  draw_of(pair_of(scene, f).second, scene, at.x, at.y, f);
}

void leave_first_out(const Scene& scene, Fragments& f) {
  f.erase(end_of(scene, f, pair_of(scene, f).second, false));
}

void leave_last_out(const Scene& scene, Fragments& f) {
  f.erase(end_of(scene, f, pair_of(scene, f).first, true));
}

// The first line goes on into the second one's first column, a pixel beside it.
void share_a_column(const Scene& scene, Fragments& f) {
  const Pair pair = pair_of(scene, f);
  const Fragment at = first_of_second(scene, f);
  draw_of(pair.first, scene, at.x + (pair.x_major ? 0 : 1), at.y + (pair.x_major ? 1 : 0), f);
}

// The two lines a pixel each away from one another, across their direction.
void move_apart(const Scene& scene, Fragments& fragments) {
  const Pair pair = pair_of(scene, fragments);
  const Fragment before = last_of_first(scene, fragments);
  const Fragment after = first_of_second(scene, fragments);
  const int rise = pair.x_major ? after.y - before.y : after.x - before.x;
  const int sign = rise < 0 ? -1 : 1;
  for (Fragment& f : fragments) {
    const int by = f.primitive == pair.first ? -sign : sign;
    f = fragment_at(scene, f.primitive, f.x + (pair.x_major ? 0 : by),
                    f.y + (pair.x_major ? by : 0));
  }
}

// The pixel at the joint changes hands: nothing is doubled and nothing missing.
void hand_over_one_later(const Scene& scene, Fragments& f) {
  draw_last(scene, f);
  leave_first_out(scene, f);
}

void hand_over_one_earlier(const Scene& scene, Fragments& f) {
  draw_one_back(scene, f);
  leave_last_out(scene, f);
}

// The first line also draws the pixel that holds the vertex, though the second turns away there.
void draw_vertex_of_turn(const Scene& scene, Fragments& f) {
  const Point end = scene.draws[0].vertices[1].position;
  draw_of(0, scene, static_cast<int>(end.x.floor()), static_cast<int>(end.y.floor()), f);
}

const std::vector<std::string> kStraight = {
    "strip x-major",        "strip y-major",        "strip leftward", "strip downward",
    "joined lines x-major", "joined lines y-major", "joined draws"};
const std::vector<std::string> kUpward = {"strip y-major", "joined lines y-major"};
const std::vector<std::string> kNotUpward = {"strip x-major", "strip leftward", "strip downward",
                                             "joined lines x-major", "joined draws"};
const std::vector<std::string> kMiddles = {"strip with an empty middle",
                                           "lines with an empty middle"};
// Exact itself draws a pixel of the first twice.
const std::vector<std::string> kTurnsBack = {"strip that turns back"};
const std::vector<std::string> kTurnsUpward = {"strip that turns upward"};
const std::vector<std::string> kTurns = {"strip that turns back", "strip that turns upward"};
// Exact itself draws the first pixel twice.
const std::vector<std::string> kFromOnePoint = {"lines from one point"};

constexpr const char* kWholeWalk = "line.algorithm=walk-floor-to-floor";
constexpr const char* kHalfOpenWalk = "line.algorithm=walk-half-open-direction";

}  // namespace

std::vector<Mutant> joint_mutants() {
  const auto violation = [](const char* name, auto change, const char* cause = "",
                            const char* cause_of_middles = "", const char* cause_upward = "") {
    std::vector<std::string> scenes = kStraight;
    scenes.insert(scenes.end(), kMiddles.begin(), kMiddles.end());
    Mutant mutant{name, scenes, changed(change), Verdict::violation, "line.joint", cause};
    for (const std::string& scene : kMiddles) mutant.cause_in[scene] = cause_of_middles;
    for (const std::string& scene : kUpward) mutant.cause_in[scene] = cause_upward;
    return mutant;
  };
  const auto allowed = [](Verdict verdict, const char* name, std::vector<std::string> scenes,
                          auto change, const std::string& cause = "") {
    return Mutant{name, std::move(scenes), changed(change), verdict, "line.diamond-exit", cause};
  };
  const std::string one_later = std::string(kWholeWalk) + " | ";
  const std::string one_later_upward = std::string(kWholeWalk) + " | " + kTestedEnds;
  const std::string one_later_past_a_middle = std::string(kWholeWalk) + " | " + kHalfOpenWalk;
  constexpr auto kPermitted = Verdict::permitted;
  constexpr auto kConvention = Verdict::convention;
  return {
      violation("last pixel drawn at a joint", draw_last, kWholeWalk, kWholeWalk, kWholeWalk),
      violation("one pixel before the joint drawn again", draw_one_back),
      violation("first missing at a joint", leave_first_out, "", kHalfOpenWalk, kTestedEnds),
      violation("last missing at a joint", leave_last_out),
      violation("the sides of a joint moved apart", move_apart),
      allowed(kPermitted, "a joint handed over one later", kNotUpward, hand_over_one_later,
              one_later),
      allowed(kConvention, "a joint handed over one later, going up", kUpward, hand_over_one_later,
              one_later_upward),
      allowed(kConvention, "a joint handed over one later, past a middle", kMiddles,
              hand_over_one_later, one_later_past_a_middle),
      allowed(kPermitted, "a joint handed over one earlier", kStraight, hand_over_one_earlier),
      allowed(kPermitted, "a joint handed over one earlier, before a middle", kMiddles,
              hand_over_one_earlier),
      allowed(kPermitted, "two pixels in the column of a joint, side by side", kStraight,
              share_a_column),
      allowed(kPermitted, "two pixels in the column of a joint, beyond a middle", kMiddles,
              share_a_column),
      allowed(kConvention, "last pixel drawn at a turn", kTurns, draw_vertex_of_turn, kWholeWalk),
      allowed(kPermitted, "first missing at a turn", kTurnsBack, leave_first_out),
      allowed(kConvention, "first missing at a turn upward", kTurnsUpward, leave_first_out,
              kTestedEnds),
      allowed(kPermitted, "first missing of two lines from one point", kFromOnePoint,
              leave_first_out),
  };
}

}  // namespace edgecase
