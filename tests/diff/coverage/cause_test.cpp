// SPDX-License-Identifier: MIT
//
// The search for causes, held against trying every one and two alternatives by the rasterizer; and
// what a profile adds to it.
#include "diff/coverage/cause.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <set>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"
#include "tests/support/points.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

// The rules of the catalogue that have a say in the coverage of a kind of primitive in a target of
// one sample.
std::vector<std::string> rules_of(PrimitiveKind kind) {
  const std::string prefix = std::string(name_of(kind)) + ".";
  std::vector<std::string> ids;
  for (const Rule& rule : all_rules())
    if (std::string(name_of(rule.id)).starts_with(prefix) && rule.id != RuleId::line_multisampled &&
        !rule.alternatives.empty())
      ids.push_back(name_of(rule.id));
  return ids;
}

// A scene of one primitive, and what is asked about it.
struct Subject {
  Scene scene;

  ScenePrimitive primitive() const { return primitives_of(scene)[0]; }
  RuleChoices choice(const Choices& rules) const {
    return resolve(policy_of(rules), scene.target.surface);
  }
  std::vector<PixelPosition> drawn(const Choices& rules) const {
    return covered_pixels(primitive(), scene.target, choice(rules).of(primitive().kind));
  }
  std::vector<std::string> catalogued_causes(const std::vector<PixelPosition>& pixels) const {
    auto result = causes(pixels);
    std::erase(result, text_of(kInteriorGap));
    return result;
  }
  std::vector<std::string> causes(const std::vector<PixelPosition>& pixels,
                                  const Choices* profile = nullptr) const {
    const RuleChoices chosen = choice({});
    const RuleChoices known = choice(profile != nullptr ? *profile : Choices{});
    return texts_of(
        find_causes({primitive(), scene.target, chosen, profile != nullptr ? &known : nullptr},
                    {{drawn({})}, {pixels}}));
  }
};

Subject subject(Primitive kind, const std::vector<Point>& points, double size = 1) {
  Subject result{blank_scene(10, 10)};
  result.scene.draws = {make_draw(kind, points)};
  result.scene.draws[0].line_width = result.scene.draws[0].point_size = at(size, 0).x;
  return result;
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  // Coordinates are multiples of a half or of 1/2048.
  Point point() {
    const int parts = below(2) == 0 ? 2 : 2048;
    return at(1 + below(8 * parts) / static_cast<double>(parts),
              1 + below(8 * parts) / static_cast<double>(parts));
  }
  Subject next() {
    switch (below(4)) {
      case 0:
        return subject(Primitive::points, {point()}, 1 + below(2));
      case 1:
        return subject(Primitive::triangles, {point(), point(), point()});
      default:
        return subject(Primitive::lines, {point(), point()}, below(4) == 0 ? 3 : 1);
    }
  }
  // One alternative each of so many rules that have a say, none of them the standard.
  Choices alternatives(const Subject& subject, std::size_t count) {
    std::vector<std::string> ids = rules_of(subject.primitive().kind);
    std::shuffle(ids.begin(), ids.end(), engine_);
    Choices rules;
    for (std::size_t i = 0; i < std::min(count, ids.size()); ++i) {
      const Rule& rule = *find_rule(ids[i]);
      do {
        rules[ids[i]] = rule.alternatives[static_cast<std::size_t>(
                                              below(static_cast<int>(rule.alternatives.size())))]
                            .name;
      } while (rules[ids[i]] == rule.standard);
    }
    return rules;
  }

 private:
  std::mt19937_64 engine_;
};

Choices rules_of_cause(const std::string& cause) {
  Choices rules;
  for (const std::string& part : parts_of(cause))
    rules[part.substr(0, part.find('='))] = part.substr(part.find('=') + 1);
  return rules;
}

bool is_open(const Choices& rules) {
  return std::all_of(rules.begin(), rules.end(), [](const auto& choice) {
    return is_open_choice(choice.first + "=" + choice.second);
  });
}

// All sets of one alternative, or without any of two, that draw `pixels`; and where none of them is
// open, those of two that are.
std::set<Choices> by_trying_all(const Subject& subject, const std::vector<PixelPosition>& pixels) {
  std::vector<Choices> singles;
  for (const std::string& id : rules_of(subject.primitive().kind))
    for (const Alternative& alternative : find_rule(id)->alternatives)
      if (alternative.name != find_rule(id)->standard) singles.push_back({{id, alternative.name}});
  std::set<Choices> found;
  for (const Choices& one : singles)
    if (subject.drawn(one) == pixels) found.insert(one);
  if (std::any_of(found.begin(), found.end(), is_open)) return found;
  const bool all = found.empty();
  for (std::size_t i = 0; i < singles.size(); ++i)
    for (std::size_t j = i + 1; j < singles.size(); ++j) {
      Choices both = singles[i];
      if (!both.insert(*singles[j].begin()).second || (!all && !is_open(both))) continue;
      if (subject.drawn(both) == pixels) found.insert(both);
    }
  return found;
}

TEST(Causes, AreAllThatTryingFinds) {
  Random random(share_seed(61));
  int differing = 0;
  int pairs = 0;
  int open_beside_illegal = 0;
  int unexplained = 0;
  while (differing < share_of(1000, 200)) {
    const Subject subject = random.next();
    auto pixels =
        subject.drawn(random.alternatives(subject, static_cast<std::size_t>(1 + random.below(3))));
    if (random.below(5) == 0 && !pixels.empty()) pixels.erase(pixels.begin());
    if (pixels == subject.drawn({})) continue;
    ++differing;
    std::set<Choices> found;
    for (const std::string& cause : subject.catalogued_causes(pixels))
      ASSERT_TRUE(found.insert(rules_of_cause(cause)).second) << cause << " stands twice";
    ASSERT_EQ(found, by_trying_all(subject, pixels)) << differing;
    const auto count = [&](std::size_t size) {
      return std::count_if(found.begin(), found.end(),
                           [&](const Choices& rules) { return rules.size() == size; });
    };
    pairs += count(1) == 0 && count(2) > 0 ? 1 : 0;
    open_beside_illegal += count(1) > 0 && count(2) > 0 ? 1 : 0;
    unexplained += found.empty() ? 1 : 0;
  }
  EXPECT_GT(pairs, least_of(10));
  EXPECT_GT(open_beside_illegal, least_of(5));
  EXPECT_GT(unexplained, least_of(5));
}

// What three alternatives draw is out of reach without a profile; it is found when the profile
// holds them, and named without those that it does not need.
TEST(CausesOnTopOfAProfile, OfThreeAlternatives) {
  Random random(62);
  int three = 0;
  while (three < 10) {
    const Subject subject = random.next();
    if (subject.primitive().kind != PrimitiveKind::line) continue;
    const Choices profile = random.alternatives(subject, 3);
    const auto pixels = subject.drawn(profile);
    if (pixels == subject.drawn({}) || !subject.catalogued_causes(pixels).empty()) continue;
    ++three;
    const auto causes = subject.causes(pixels, &profile);
    ASSERT_EQ(causes.size(), 1u);
    EXPECT_EQ(rules_of_cause(causes[0]), profile) << "all three are needed";
  }
}

TEST(CausesOnTopOfAProfile, OneMore) {
  Random random(63);
  int found = 0;
  int named = 0;
  while (found < 10) {
    const Subject subject = random.next();
    if (subject.primitive().kind != PrimitiveKind::line) continue;
    Choices all = random.alternatives(subject, 4);
    const auto pixels = subject.drawn(all);
    Choices profile = all;
    const auto more = std::next(profile.begin(), random.below(static_cast<int>(profile.size())));
    const std::string one_more = more->first + "=" + more->second;
    profile.erase(more);
    const bool by_profile = subject.drawn(profile) == pixels;
    if (by_profile || pixels == subject.drawn({}) || !subject.catalogued_causes(pixels).empty())
      continue;
    ++found;
    const auto causes = subject.causes(pixels, &profile);
    ASSERT_FALSE(causes.empty());
    for (const std::string& cause : causes) {
      EXPECT_EQ(subject.drawn(rules_of_cause(cause)), pixels) << cause;
      EXPECT_GE(parts_of(cause).size(), 3u);
    }
    named += std::any_of(causes.begin(), causes.end(),
                         [&](const std::string& cause) {
                           const auto parts = parts_of(cause);
                           return std::find(parts.begin(), parts.end(), one_more) != parts.end();
                         })
                 ? 1
                 : 0;
  }
  EXPECT_EQ(named, found) << "what was added is among what is named";
}

// Several alternatives draw the same; those that the profile holds come alone.
TEST(CausesOnTopOfAProfile, PreferWhatTheRendererDoesElsewhere) {
  const Subject top = subject(Primitive::triangles, {at(2.5, 2.5), at(7.5, 2.5), at(2.5, 7.5)});
  const auto pixels = top.drawn({{"triangle.fill-rule", "bottom-left"}});
  const auto any = top.causes(pixels);
  for (const char* order : {"triangle.fill-rule=left-bottom", "triangle.fill-rule=bottom-left"})
    EXPECT_EQ(std::count(any.begin(), any.end(), order), 1);
  const Choices own = {{"triangle.fill-rule", "bottom-left"}, {"triangle.snap", "8-half-even"}};
  EXPECT_EQ(top.causes(pixels, &own), std::vector<std::string>{"triangle.fill-rule=bottom-left"});
  const Choices other = {{"triangle.fill-rule", "right-top"}};
  EXPECT_EQ(top.causes(pixels, &other), any) << "a profile that holds none of them changes nothing";
}

TEST(CausesOnTopOfAProfile, OfTheSpecificationItselfChangeNothing) {
  Random random(64);
  const Choices standard;
  for (int i = 0; i < 100; ++i) {
    const Subject subject = random.next();
    const auto pixels = subject.drawn(random.alternatives(subject, 3));
    if (pixels == subject.drawn({})) continue;
    EXPECT_EQ(subject.causes(pixels, &standard), subject.causes(pixels));
  }
}

// Through compare(): a line off the grid, on a row's border, seen upside down.
TEST(CausesOnTopOfAProfile, ReachTheDisagreements) {
  Random random(65);
  for (;;) {
    const Subject subject = random.next();
    if (subject.primitive().kind != PrimitiveKind::line) continue;
    Policy profile = policy_of(random.alternatives(subject, 3));
    const Rendering rendered = rasterize(subject.scene, profile);
    const auto pixels = subject.drawn(profile.rules);
    if (pixels == subject.drawn({}) || !subject.catalogued_causes(pixels).empty()) continue;
    const Rendering exact = rasterize(subject.scene, {});
    const ResolvedPolicy known_profile = profile;
    const Result known = compare(subject.scene, {}, exact, rendered, {8, &known_profile});
    ASSERT_EQ(known.evidence.size(), 1u);
    ASSERT_EQ(known.evidence[0].causes.size(), 1u);
    EXPECT_EQ(rules_of_cause(text_of(known.evidence[0].causes[0])), profile.rules);
    // A profile of the other surface says nothing here.
    Policy window;
    window.surfaces[Surface::window] = profile.rules;
    const ResolvedPolicy elsewhere = window;
    const Result unknown = compare(subject.scene, {}, exact, rendered, {8, &elsewhere});
    for (const Cause& cause : unknown.evidence[0].causes) EXPECT_EQ(cause, Cause(kInteriorGap));
    break;
  }
}

}  // namespace
}  // namespace edgecase
