// SPDX-License-Identifier: MIT
//
// What primitives cover, sample by sample, against the literal oracles in rational arithmetic: the
// half planes of a triangle, the square of a point and the rectangle of a line, with the sample
// where it lies and moved by the tie rule. Vertices and samples lie on multiples of 1/16, coarse
// ones often, so that samples lie on vertices and edges.
#include <gtest/gtest.h>

#include <string>

#include "rules/coverage/tie_rule.h"
#include "tests/oracles/areas.h"
#include "tests/oracles/lines.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr int kSize = 3;

// Inside, on the boundary or outside.
int where_is(const ScenePrimitive& primitive, const oracle::Place& sample) {
  const auto vertex = [&](std::size_t i) { return oracle::spot(primitive.vertices[i]->position); };
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return oracle::where_in_square(vertex(0), oracle::Rational(primitive.state->point_size),
                                     sample);
    case PrimitiveKind::line:
      return oracle::where_in_rectangle({vertex(0), vertex(1)},
                                        oracle::Rational(primitive.state->line_width), sample);
    case PrimitiveKind::triangle:
      return oracle::where_by_half_planes({vertex(0), vertex(1), vertex(2)}, sample);
  }
  return -1;
}

struct Tally {
  long scenes = 0;
  long decisions = 0;
  long tied = 0;
};

// Compares every sample of the target; false with a failure where one of them differs.
bool agrees(const Scene& scene, const TieRule& rule, const SamplePositions& positions,
            Tally& tally) {
  const ScenePrimitive primitive = primitives_of(scene).at(0);
  CoverageChoice choice;
  choice.ties = rule;
  const SampleCoverage coverage = covered_samples(primitive, scene.target, choice, positions);
  const oracle::Ties ties = oracle::ties_named(rule.name);
  ++tally.scenes;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const std::uint32_t ours = mask_at(coverage, {x, y});
      for (std::size_t s = 0; s < positions.size(); ++s) {
        const oracle::Spot spot = oracle::spot(place_in({x, y}, positions[s]));
        const int where = where_is(primitive, oracle::moved(spot, ties.move));
        ++tally.decisions;
        if (where_is(primitive, oracle::moved(spot, {0, 0})) == 0) ++tally.tied;
        if (((ours >> s & 1) != 0) == ties.accept(where)) continue;
        ADD_FAILURE() << rule.name << " sample " << s << " of pixel " << x << ", " << y << " of "
                      << name_of(primitive.kind);
        return false;
      }
    }
  return true;
}

Scene random_scene(RandomPoints& random, Primitive primitive, int samples) {
  constexpr int kParts[] = {2, 4, 4, 8, 16, 256};
  const int parts = kParts[random.between(0, 5)];
  std::vector<Point> positions;
  for (int i = 0; i < vertices_of(kind_of(primitive)); ++i)
    positions.push_back(random.point(-1, kSize + 1, parts));
  Scene scene = multisampled_scene(kSize, samples, primitive, positions);
  const Fixed size = Fixed::from_raw(random.between(1, 16) * (Fixed::kOne / 4));
  scene.draws[0].point_size = size;
  scene.draws[0].line_width = random.between(0, 1) == 0 ? Fixed::from_integer(1) : size;
  return scene;
}

// This share of that many random scenes.
Tally compare(Primitive primitive, long all) {
  const long count = share_of(all, 300L);
  RandomPoints random(share_seed(static_cast<std::uint64_t>(primitive) + 1));
  Tally tally;
  const auto rules = all_tie_rules();
  while (tally.scenes < count) {
    constexpr int kCounts[] = {2, 4, 8, 16, 3};
    const int samples = kCounts[random.between(0, 4)];
    const Scene scene = random_scene(random, primitive, samples);
    const SamplePositions positions =
        random.between(0, 2) == 0 ? standard_pattern(samples) : random.positions(samples, 4);
    if (!agrees(scene, rules[static_cast<std::size_t>(tally.scenes) % rules.size()], positions,
                tally))
      break;
  }
  EXPECT_EQ(tally.scenes, count);
  return tally;
}

TEST(MultisampleOracle, Triangles) {
  const Tally tally = compare(Primitive::triangles, 3000);
  EXPECT_GT(tally.tied, least_of(1500));
}

TEST(MultisampleOracle, Points) {
  const Tally tally = compare(Primitive::points, 3000);
  EXPECT_GT(tally.tied, least_of(3000));
}

TEST(MultisampleOracle, Lines) {
  const Tally tally = compare(Primitive::lines, 3000);
  EXPECT_GT(tally.tied, least_of(1000));
}

// Every triangle and every line with vertices on a grid of halves round one pixel whose four
// samples lie on that grid and off it.
TEST(MultisampleOracle, EveryTriangleAndLineOfASmallGrid) {
  const auto quarter = [](int x, int y) {
    return Point{Fixed::from_raw(x * Fixed::kOne / 4), Fixed::from_raw(y * Fixed::kOne / 4)};
  };
  const SamplePositions positions = {quarter(2, 2), quarter(0, 2), quarter(3, 1), quarter(2, 0)};
  std::vector<Point> grid;
  for (int y = 0; y <= 8; y += 2)
    for (int x = 0; x <= 8; x += 2) grid.push_back(quarter(x, y));
  Tally tally;
  const auto rules = all_tie_rules();
  const auto rule = [&]() -> const TieRule& {
    return rules[static_cast<std::size_t>(tally.scenes) % rules.size()];
  };
  for (Point a : grid)
    for (Point b : grid) {
      const Scene line = multisampled_scene(kSize, 4, Primitive::lines, {a, b});
      ASSERT_TRUE(agrees(line, rule(), positions, tally));
      for (std::size_t i = 0; i < grid.size(); i += 3) {
        const Scene scene = multisampled_scene(kSize, 4, Primitive::triangles, {a, b, grid[i]});
        ASSERT_TRUE(agrees(scene, rule(), positions, tally));
      }
    }
  EXPECT_GT(tally.tied, 5000);
}

// With one sample, at the centre, multisampled triangles and points are what they are without.
TEST(MultisampleOracle, OneSampleAtTheCentreIsThePixel) {
  RandomPoints random(7);
  const SamplePositions centres(2, centre_of_pixel());
  int covered = 0;
  for (int round = 0; round < 400; ++round)
    for (Primitive primitive : {Primitive::triangles, Primitive::points}) {
      const Scene scene = random_scene(random, primitive, 2);
      const ScenePrimitive given = primitives_of(scene).at(0);
      const CoverageChoice choice = resolve({}, Surface::fbo).of(given.kind);
      const auto pixels = covered_pixels(given, scene.target, choice);
      covered += static_cast<int>(pixels.size());
      EXPECT_EQ(covered_samples(given, scene.target, choice, centres),
                (SampleCoverage{pixels, pixels}));
      Target single = scene.target;
      single.samples = 1;
      EXPECT_EQ(covered_samples(given, single, choice, centres), SampleCoverage{pixels});
    }
  EXPECT_GT(covered, 1000);
}

// A target of one sample knows no samples, wherever somebody says that they lie, no masks and no
// lines that are areas.
TEST(MultisampleOracle, ATargetOfOneSampleIsNotMultisampled) {
  const Point low{Fixed::from_raw(1), Fixed::from_raw(1)};
  Scene scene = multisampled_scene(
      kSize, 1, Primitive::lines,
      {pixel_centre(0, 1), {Fixed::from_raw(Fixed::kOne * 11 / 4), Fixed::centre_of(1)}});
  scene.draws[0].multisampling.mask = 0;
  const ScenePrimitive line = primitives_of(scene).at(0);
  CoverageChoice choice = resolve({}, Surface::fbo).of(line.kind);
  choice.placement.kind = SamplePlacement::Kind::mirrored_x;
  EXPECT_EQ(positions_of(scene.target, choice, {low}), SamplePositions{centre_of_pixel()});
  const auto pixels = covered_pixels(line, scene.target, choice);
  EXPECT_EQ(pixels.size(), 2u);  // not the one in whose diamond the line ends
  EXPECT_EQ(covered_samples(line, scene.target, choice, {low}), SampleCoverage{pixels});
}

}  // namespace
}  // namespace edgecase
