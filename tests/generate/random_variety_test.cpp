// SPDX-License-Identifier: MIT
//
// What random scenes tell apart: for every pair of alternatives of a rule, at least 20 of 20,000
// scenes that are drawn differently, so that two seeds see the same rule.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generate/random_scenes.h"
#include "raster/rasterizer.h"
#include "rules/coverage/point_ownership.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kScenes = 20'000;
constexpr std::size_t kLeast = 20;

struct NamedChoice {
  std::string name;
  CoverageChoice choice;
};

CoverageChoice standard_choice() {
  CoverageChoice choice;
  choice.ties = *find_tie_rule("left-bottom");
  choice.line.boundary = find_diamond_boundary("left-bottom");
  return choice;
}

std::vector<NamedChoice> snap_choices() {
  std::vector<NamedChoice> result;
  for (Snap snap : all_snaps()) {
    result.push_back({name_of(snap), standard_choice()});
    result.back().choice.snap = snap;
  }
  return result;
}

std::vector<NamedChoice> tie_choices(std::span<const TieRule> rules) {
  std::vector<NamedChoice> result;
  for (const TieRule& rule : rules) {
    result.push_back({std::string(rule.name), standard_choice()});
    result.back().choice.ties = rule;
  }
  return result;
}

std::vector<NamedChoice> boundary_choices() {
  std::vector<NamedChoice> result;
  for (const DiamondBoundary& boundary : all_diamond_boundaries()) {
    result.push_back({std::string(boundary.name), standard_choice()});
    result.back().choice.line.boundary = &boundary;
  }
  return result;
}

std::vector<NamedChoice> algorithm_choices() {
  std::vector<NamedChoice> result;
  for (LineAlgorithm algorithm : values_of<LineAlgorithm>()) {
    // Nothing lies at negative coordinates, where alone the two differ.
    if (algorithm == LineAlgorithm::bresenham_toward_zero) continue;
    result.push_back({name_of(algorithm), standard_choice()});
    result.back().choice.line.algorithm = algorithm;
  }
  return result;
}

std::vector<NamedChoice> wide_choices() {
  std::vector<NamedChoice> result;
  for (WideLine wide : {WideLine::replicate, WideLine::rectangle, WideLine::parallelogram}) {
    result.push_back({name_of(wide), standard_choice()});
    result.back().choice.line.wide = wide;
  }
  return result;
}

std::vector<NamedChoice> row_choices() {
  std::vector<NamedChoice> result;
  for (RowOrder rows : {RowOrder::bottom_up, RowOrder::top_down}) {
    result.push_back({name_of(rows), standard_choice()});
    result.back().choice.rows = rows;
  }
  return result;
}

// Two choices by their places in a list, the later one first.
using Pair = std::pair<std::size_t, std::size_t>;

// Two choices that can only draw alike: they differ in nothing but the snap, and the snap does not.
bool must_draw_alike(const ScenePrimitive& primitive, const CoverageChoice& a,
                     const CoverageChoice& b) {
  const bool same_rules = a.ties.name == b.ties.name && a.line.boundary == b.line.boundary &&
                          a.line.algorithm == b.line.algorithm && a.line.wide == b.line.wide &&
                          a.rows == b.rows;
  return same_rules && std::all_of(primitive.vertices.begin(),
                                   primitive.vertices.begin() + vertices_of(primitive.kind),
                                   [&](const Vertex* vertex) {
                                     return a.snap(vertex->position) == b.snap(vertex->position);
                                   });
}

// Which drawings of a scene are alike: a number for each choice, equal where drawings are.
std::vector<std::size_t> drawings_of(const Scene& scene, const std::vector<NamedChoice>& choices) {
  const ScenePrimitive primitive = primitives_of(scene)[0];
  std::vector<std::vector<PixelPosition>> distinct;
  std::vector<std::size_t> result;
  for (const NamedChoice& named : choices) {
    const auto before = std::find_if(
        choices.begin(), choices.begin() + static_cast<std::ptrdiff_t>(result.size()),
        [&](const NamedChoice& n) { return must_draw_alike(primitive, n.choice, named.choice); });
    if (const auto place = static_cast<std::size_t>(before - choices.begin());
        place < result.size()) {
      result.push_back(result[place]);
      continue;
    }
    auto drawn = covered_pixels(primitive, scene.target, named.choice);
    const auto same = std::find(distinct.begin(), distinct.end(), drawn);
    result.push_back(static_cast<std::size_t>(same - distinct.begin()));
    if (same == distinct.end()) distinct.push_back(std::move(drawn));
  }
  return result;
}

// Counts, for every pair of choices, the scenes that they draw differently.
template <class SceneOf>
std::map<Pair, std::size_t> count_differing(const std::vector<NamedChoice>& choices,
                                            SceneOf scene_of) {
  std::map<Pair, std::size_t> differing;
  for (std::uint64_t index = 0; index < kScenes; ++index) {
    if (!is_in_share(index)) continue;
    const std::vector<std::size_t> drawings = drawings_of(scene_of(index), choices);
    for (std::size_t i = 0; i < choices.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) differing[{i, j}] += drawings[i] != drawings[j] ? 1u : 0u;
  }
  return differing;
}

// Expects every pair of choices to be told apart, but for pairs that are said to be the same.
template <class SceneOf>
void expect_told_apart(const char* what, const std::vector<NamedChoice>& choices, SceneOf scene_of,
                       const std::set<Pair>& same = {}) {
  std::size_t least = kScenes;
  std::string least_pair;
  std::size_t pairs = 0, alike = 0;
  for (const auto& [pair, count] : count_differing(choices, scene_of)) {
    const std::string names = choices[pair.first].name + " and " + choices[pair.second].name;
    if (same.contains(pair)) {
      EXPECT_EQ(count, 0u) << what << ": " << names;
      continue;
    }
    EXPECT_GE(count, least_of(kLeast)) << what << ": " << names;
    ++pairs;
    if (count == 0) ++alike;
    if (count >= least) continue;
    least = count;
    least_pair = names;
  }
  EXPECT_LE(alike, pairs / 10) << what << ": a share tells nine pairs of ten apart";
  std::printf("%s: %zu alternatives, least told apart %s, by %zu scenes\n", what, choices.size(),
              least_pair.c_str(), least);
}

// The snaps that no point tells apart whose size is a multiple of 1/16, so that its vertex lies at
// a multiple T of 1/32 where a side meets a sample. If right and top sides are owned, what counts
// is whether the snapped vertex is at least T: that holds from T on if the vertex is truncated, and
// from half a step below it if it is rounded, for T is an even step of 2^-6 or finer. If left and
// bottom sides are owned, the snapped vertex must be at most T: that holds for every vertex below
// T + 2^-(b+1), whether it is rounded half up to 2^-b or truncated to 2^-(b+1).
bool same_for_points(Snap fine, Snap coarse, bool right_top) {
  using Rounding = Snap::Rounding;
  const auto truncates = [](Snap snap) {
    return snap.is_none() || (snap.rounding == Rounding::truncate && snap.bits >= 5);
  };
  if (right_top)
    return (truncates(fine) && truncates(coarse)) ||
           (fine.bits == coarse.bits && fine.bits >= 6 && fine.rounding != Rounding::truncate &&
            coarse.rounding != Rounding::truncate);
  return !fine.is_none() && fine.rounding == Rounding::truncate &&
         coarse.rounding == Rounding::half_up && coarse.bits == fine.bits - 1 && coarse.bits >= 5;
}

std::set<Pair> same_for_points(const std::vector<NamedChoice>& choices, bool right_top) {
  std::set<Pair> result;
  for (std::size_t i = 0; i < choices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (same_for_points(choices[j].choice.snap, choices[i].choice.snap, right_top))
        result.insert({i, j});
  return result;
}

auto scenes_of(PrimitiveKind kind) {
  return [kind](std::uint64_t index) { return random_scene({3, kind, Surface::fbo}, index); };
}

TEST(RandomVariety, TellsSnapsOfPointsApart) {
  for (const bool right_top : {false, true}) {
    std::vector<NamedChoice> choices = snap_choices();
    if (right_top)
      for (NamedChoice& named : choices) named.choice.ties = *find_tie_rule("right-top");
    expect_told_apart(right_top ? "point.snap, right-top" : "point.snap, left-bottom", choices,
                      scenes_of(PrimitiveKind::point), same_for_points(choices, right_top));
  }
}

TEST(RandomVariety, TellsSnapsOfLinesApart) {
  expect_told_apart("line.snap", snap_choices(), scenes_of(PrimitiveKind::line));
}

TEST(RandomVariety, TellsSnapsOfTrianglesApart) {
  expect_told_apart("triangle.snap", snap_choices(), scenes_of(PrimitiveKind::triangle));
}

TEST(RandomVariety, TellsTieRulesApart) {
  expect_told_apart("point.ownership", tie_choices(point_tie_rules()),
                    scenes_of(PrimitiveKind::point));
  expect_told_apart("triangle.fill-rule", tie_choices(all_tie_rules()),
                    scenes_of(PrimitiveKind::triangle));
}

TEST(RandomVariety, TellsLinesApart) {
  expect_told_apart("line.diamond-exit", boundary_choices(), scenes_of(PrimitiveKind::line));
  expect_told_apart("line.algorithm", algorithm_choices(), scenes_of(PrimitiveKind::line));
  expect_told_apart("line.row-order", row_choices(), scenes_of(PrimitiveKind::line));
}

TEST(RandomVariety, TellsWideLinesApart) {
  expect_told_apart("line.width", wide_choices(),
                    [](std::uint64_t index) { return random_wide_line(3, Surface::fbo, index); });
}

}  // namespace
}  // namespace edgecase
