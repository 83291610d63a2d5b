// SPDX-License-Identifier: MIT
//
// Rulings 1 to 3 clause by clause: what one unit, one fragment more or less and one gap allow, and
// what they do not.
#include "rules/coverage/segment.h"
#include "tests/diff/coverage/fragment_changes.h"

namespace edgecase {
namespace {

const std::vector<std::string> kLines = {"line x-major", "line y-major", "line 45 degrees",
                                         "line short",   "two lines",    "line smooth"};
const std::vector<std::string> kUpward = {"line y-major"};
const std::vector<std::string> kNotUpward = {"line x-major", "line 45 degrees", "line short",
                                             "two lines", "line smooth"};
const std::vector<std::string> kLong = {"line x-major", "line y-major", "line 45 degrees"};
// Moved as a whole, joints stay whole.
const std::vector<std::string> kMoved = {"line x-major",
                                         "line y-major",
                                         "line 45 degrees",
                                         "line short",
                                         "two lines",
                                         "line smooth",
                                         "strip x-major",
                                         "strip y-major",
                                         "strip leftward",
                                         "strip downward",
                                         "joined lines x-major",
                                         "joined lines y-major",
                                         "joined draws",
                                         "strip with an empty middle",
                                         "lines with an empty middle",
                                         "strip that turns back",
                                         "strip that turns upward",
                                         "lines from one point"};
const std::vector<std::string> kEmpty = {"line within a diamond"};

// Walks that draw both ends are in use, and the catalogue has them.
constexpr const char* kWholeWalk = "line.algorithm=walk-floor-to-floor";

Mutant line_mutant(Verdict verdict, const char* name, std::vector<std::string> scenes,
                   Mutation mutate, const char* cause = "") {
  return {name, std::move(scenes), std::move(mutate), verdict, "line.diamond-exit", cause};
}

template <class... Rest>
Mutant permitted(Rest... rest) {
  return line_mutant(Verdict::permitted, rest...);
}

template <class... Rest>
Mutant convention(Rest... rest) {
  return line_mutant(Verdict::convention, rest...);
}

template <class... Rest>
Mutant contested(Rest... rest) {
  return line_mutant(Verdict::contested, rest...);
}
template <class... Rest>
Mutant violation(Rest... rest) {
  return line_mutant(Verdict::violation, rest...);
}

void erase_first(const Scene& scene, Fragments& fragments) {
  fragments.erase(end_of(scene, fragments, 0, false));
}

void erase_last(const Scene& scene, Fragments& fragments) {
  fragments.erase(end_of(scene, fragments, 0, true));
}

// The pixel that holds the second vertex.
void draw_end_vertex(const Scene& scene, Fragments& fragments) {
  const Point end = scene.draws[0].vertices[1].position;
  draw(scene, fragments, static_cast<int>(end.x.floor()), static_cast<int>(end.y.floor()));
}

// One more before the first fragment, along x or y as the line runs.
void draw_before_first(const Scene& scene, Fragments& fragments) {
  const Fragment first = *end_of(scene, fragments, 0, false);
  const auto& v = scene.draws[0].vertices;
  const bool x_major = v[1].position.x - v[0].position.x >= v[1].position.y - v[0].position.y;
  draw(scene, fragments, first.x - (x_major ? 1 : 0), first.y - (x_major ? 0 : 1));
}

// Three fragments in the middle get a neighbour across the line's direction.
Mutation doubled(int dx, int dy) {
  return changed([=](const Scene& scene, Fragments& fragments) {
    const std::size_t middle = fragments.size() / 2;
    for (std::size_t i = middle - 1; i <= middle + 1; ++i)
      draw(scene, fragments, fragments[i].x + dx, fragments[i].y + dy);
  });
}

// One fragment gets a neighbour, and the first one goes: the count stays right.
Mutation one_doubled(int dx, int dy) {
  return changed([=](const Scene& scene, Fragments& fragments) {
    draw(scene, fragments, fragments[4].x + dx, fragments[4].y + dy);
    erase_first(scene, fragments);
  });
}

// Every other fragment moved across the line's direction, the others as far the other way.
Mutation zigzag(int there, int back) {
  return changed([=](const Scene& scene, Fragments& fragments) {
    const auto& v = scene.draws[0].vertices;
    const bool x_major = Segment{v[0].position, v[1].position}.x_major();
    for (Fragment& f : fragments) {
      const int across = (x_major ? f.x : f.y) % 2 == 0 ? there : -back;
      f = fragment_at(scene, 0, f.x + (x_major ? 0 : across), f.y + (x_major ? across : 0));
    }
  });
}

Mutation gap(std::ptrdiff_t length) {
  return changed(
      [=](const Scene&, Fragments& f) { f.erase(f.begin() + 4, f.begin() + 4 + length); });
}

Mutation drawn_at(std::vector<std::pair<int, int>> pixels) {
  return changed([=](const Scene& scene, Fragments& fragments) {
    for (const auto& [x, y] : pixels) draw(scene, fragments, x, y);
  });
}

Mutation both(void (*first)(const Scene&, Fragments&), void (*second)(const Scene&, Fragments&)) {
  return changed([=](const Scene& scene, Fragments& fragments) {
    first(scene, fragments);
    second(scene, fragments);
  });
}

void erase_two_inside(const Scene&, Fragments& f) {
  f.erase(f.begin() + 3, f.begin() + 5);
}

void draw_beyond_both_ends(const Scene& scene, Fragments& fragments) {
  draw_before_first(scene, fragments);
  draw_end_vertex(scene, fragments);
}

void draw_beside_the_fifth(const Scene& scene, Fragments& f) {
  const bool x_major = f[0].x != f[1].x;
  draw(scene, f, f[4].x + (x_major ? 0 : 1), f[4].y + (x_major ? 1 : 0));
}

void draw_far_away(const Scene& scene, Fragments& fragments) {
  draw(scene, fragments, 0, 15);
}

}  // namespace

std::vector<Mutant> line_mutants() {
  const Mutation nothing = changed([](const Scene&, Fragments& f) { f.clear(); });
  return {
      permitted("moved by 1 in x", kMoved, shifted(1, 0)),
      permitted("moved by 1 in y", kMoved, shifted(0, 1)),
      permitted("moved by 1 in x and y", kMoved, shifted(1, 1)),
      convention("last pixel drawn", kLines, changed(draw_end_vertex), kWholeWalk),
      permitted("first fragment missing", kNotUpward, changed(erase_first)),
      convention("first fragment missing, going up", kUpward, changed(erase_first), kTestedEnds),
      permitted("last fragment missing", kLines, changed(erase_last)),
      permitted("the only fragment missing", std::vector<std::string>{"line of one fragment"},
                nothing),
      violation("first two fragments missing", kLines, both(erase_first, erase_first)),
      violation("first and last fragment missing", kLong, both(erase_first, erase_last)),
      permitted("a stray within one unit", kLong, changed(draw_before_first)),
      violation("two strays within one unit", kLong, both(draw_before_first, draw_end_vertex)),
      permitted("one missing, a stray within one unit", kLong, both(erase_last, draw_before_first)),
      violation("one missing, a stray far away", kLines, both(erase_last, draw_far_away)),
      permitted("two missing inside, a stray at each end", kLong,
                both(erase_two_inside, draw_beyond_both_ends)),
      permitted("zigzag by 1", kLong, zigzag(1, 0)),
      permitted("zigzag by 1 to both sides", kLong, zigzag(1, 1)),
      // On a slope, the next fragment is near enough.
      violation("zigzag by 2", std::vector<std::string>{"line on a row's border"}, zigzag(2, 0)),
      violation("zigzag by 3", kLong, zigzag(3, 0)),
      violation("a stray beside the line", kLong, changed(draw_beside_the_fifth)),
      permitted("an interior gap", kLong, gap(1), "line.interior-gap"),
      violation("an interior gap of two", kLong, gap(2)),
      violation("double width for three columns",
                std::vector<std::string>{"line x-major", "line smooth"}, doubled(0, 1)),
      violation("double width for three rows", std::vector<std::string>{"line y-major"},
                doubled(1, 0)),
      violation("one column of two", std::vector<std::string>{"line x-major"}, one_doubled(0, 1)),
      violation("one row of two", std::vector<std::string>{"line y-major"}, one_doubled(1, 0)),
      convention("last pixel of an empty line", kEmpty, changed(draw_end_vertex), kWholeWalk),
      violation("two pixels of an empty line", kEmpty, drawn_at({{6, 9}, {7, 9}})),
      contested("a wrong pixel of an empty line", kEmpty, drawn_at({{7, 9}})),
      violation("a pixel two beside an empty line", kEmpty, drawn_at({{8, 9}})),
  };
}

}  // namespace edgecase
