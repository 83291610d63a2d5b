// SPDX-License-Identifier: MIT
//
// The triangles of a triangulation share out the samples: each sample of the area goes to exactly
// one of them, whatever the tie rule, the number of samples and where they lie. Triangulations are
// random, with vertices on multiples of 1/16 or of 1/4, so that samples lie on vertices and edges.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "rules/coverage/tie_rule.h"
#include "rules/coverage/triangle_fill.h"
#include "tests/raster/multisampled_scenes.h"

namespace edgecase {
namespace {

constexpr int kSize = 3;

// Is the point in the triangle or on its boundary?
bool holds(const Triangle& t, Point p) {
  return cross(t[0], t[1], p) >= 0 && cross(t[1], t[2], p) >= 0 && cross(t[2], t[0], p) >= 0;
}

// A square that holds the target, cut by points inside it: each splits the triangles that hold it,
// on an edge both of its sides.
std::vector<Triangle> random_triangulation(RandomPoints& random, int parts) {
  const auto corner = [](int x, int y) {
    return Point{Fixed::from_integer(x), Fixed::from_integer(y)};
  };
  const Point low = corner(-1, -1), right = corner(kSize + 1, -1);
  const Point high = corner(kSize + 1, kSize + 1), left = corner(-1, kSize + 1);
  std::vector<Triangle> triangles = {{low, right, high}, {low, high, left}};
  for (int i = 0; i < 7; ++i) {
    const Point p = random.point(-1, kSize + 1, parts);
    std::vector<Triangle> next;
    for (const Triangle& t : triangles) {
      if (!holds(t, p)) {
        next.push_back(t);
        continue;
      }
      for (std::size_t e = 0; e < 3; ++e)
        if (const Triangle piece{t[e], t[(e + 1) % 3], p}; doubled_area(piece) != 0)
          next.push_back(piece);
    }
    triangles = next;
  }
  return triangles;
}

// How many samples lie on an edge or a vertex of the triangulation.
int samples_on_edges(const std::vector<Triangle>& triangles, const SamplePositions& positions) {
  int count = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      for (Point within : positions) {
        const Point sample = place_in({x, y}, within);
        bool is_on = false;
        for (const Triangle& t : triangles)
          for (std::size_t e = 0; e < 3; ++e)
            is_on = is_on || (holds(t, sample) && cross(t[e], t[(e + 1) % 3], sample) == 0);
        count += is_on ? 1 : 0;
      }
  return count;
}

class Partition : public testing::TestWithParam<int> {};

TEST_P(Partition, EachSampleGoesToOneTriangle) {
  const int samples = GetParam();
  RandomPoints random(static_cast<std::uint64_t>(samples));
  int on_edges = 0;
  for (int round = 0; round < 60; ++round) {
    const auto triangles = random_triangulation(random, round % 2 == 0 ? 4 : 16);
    std::vector<Point> vertices;
    for (const Triangle& t : triangles)
      // Of either winding.
      vertices.insert(vertices.end(), {t[0], random.between(0, 1) == 0 ? t[1] : t[2], {}});
    for (std::size_t i = 0; i < triangles.size(); ++i)
      vertices[3 * i + 2] =
          vertices[3 * i + 1] == triangles[i][1] ? triangles[i][2] : triangles[i][1];
    const Scene scene = multisampled_scene(kSize, samples, Primitive::triangles, vertices);
    const SamplePositions positions =
        round % 4 < 2 || samples == 1 ? standard_pattern(samples) : random.positions(samples);
    on_edges += samples_on_edges(triangles, positions);
    for (const std::string& tie : perturbed_ties()) {
      CoverageChoice choice;
      choice.ties = *find_tie_rule(tie);
      std::vector<int> hits(static_cast<std::size_t>(kSize * kSize * samples));
      for (const ScenePrimitive& primitive : primitives_of(scene)) {
        const auto coverage = covered_samples(primitive, scene.target, choice, positions);
        for (std::size_t s = 0; s < coverage.size(); ++s)
          for (PixelPosition p : coverage[s])
            ++hits[s * kSize * kSize + static_cast<std::size_t>(p.y * kSize + p.x)];
      }
      EXPECT_EQ(hits, std::vector<int>(hits.size(), 1)) << tie << " " << round;
    }
  }
  EXPECT_GT(on_edges, 40);
}

INSTANTIATE_TEST_SUITE_P(Counts, Partition, testing::Values(1, 2, 4, 8, 16));

}  // namespace
}  // namespace edgecase
