// SPDX-License-Identifier: MIT
//
// 20,000 random scenes of each kind: the same every time, exact on their way to OpenGL, of every
// size, and with ties enough.
#include "generate/random_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <set>
#include <vector>

#include "rules/coverage/triangle_fill.h"
#include "tests/generate/scene_checks.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kScenes = 20'000;
constexpr std::uint64_t kSeed = 7;
constexpr std::array kKinds{PrimitiveKind::point, PrimitiveKind::line, PrimitiveKind::triangle};

// The longer side of what holds all vertices, raw.
std::int64_t extent_of(const Scene& scene) {
  std::int64_t extent = 0;
  for (const Vertex& a : scene.draws[0].vertices)
    for (const Vertex& b : scene.draws[0].vertices)
      extent = std::max({extent, a.position.x.raw() - b.position.x.raw(),
                         a.position.y.raw() - b.position.y.raw()});
  return extent;
}

Triangle triangle_of(const Scene& scene, std::size_t number) {
  const std::vector<Vertex>& v = scene.draws[0].vertices;
  return {v[3 * number].position, v[3 * number + 1].position, v[3 * number + 2].position};
}

// Counts by octave of a size in pixels: below 1, below 2, below 4, …
class Octaves {
 public:
  void add(std::int64_t raw) {
    ++counts_[std::min<std::size_t>(
        static_cast<std::size_t>(std::bit_width(static_cast<std::uint64_t>(raw >> 16))),
        counts_.size() - 1)];
  }
  int at(std::size_t octave) const { return counts_[octave]; }
  void print(const char* what) const {
    std::printf("%s by octave:", what);
    for (int count : counts_) std::printf(" %d", count);
    std::printf("\n");
  }

 private:
  std::array<int, 9> counts_{};
};

TEST(PrimitiveScenes, AreAFunctionOfSeedKindAndIndex) {
  std::set<std::uint64_t> seen;
  for (PrimitiveKind kind : kKinds)
    for (std::uint64_t index = 0; index < 500; ++index) {
      const PrimitiveScenes of{kSeed, kind, Surface::fbo};
      const std::uint64_t print = fingerprint_of(random_scene(of, index));
      ASSERT_EQ(print, fingerprint_of(random_scene(of, index)));
      ASSERT_NE(print, fingerprint_of(random_scene({kSeed + 1, kind, Surface::fbo}, index)));
      Scene on_window = random_scene({kSeed, kind, Surface::window}, index);
      ASSERT_EQ(on_window.target.surface, Surface::window);
      on_window.target.surface = Surface::fbo;
      ASSERT_EQ(print, fingerprint_of(on_window));
      seen.insert(print);
    }
  // Points of size 1 in the smallest targets come more than once.
  EXPECT_GT(seen.size(), 1'450u);
}

// One number for many scenes of each kind and generator.
std::uint64_t fingerprint_of_all() {
  std::uint64_t sum = 0;
  for (std::uint64_t index = 0; index < 2'000; ++index) {
    for (PrimitiveKind kind : kKinds)
      sum = sum * 31 + fingerprint_of(random_scene({kSeed, kind, Surface::fbo}, index));
    sum = sum * 31 + fingerprint_of(random_wide_line(kSeed, Surface::fbo, index));
    sum = sum * 31 + fingerprint_of(shared_edge_scene(kSeed, Surface::fbo, index));
  }
  return sum;
}

// Counter-examples are named by seed and index: these scenes change on purpose or not at all, and
// compilers agree on them.
TEST(PrimitiveScenes, AreTheSameOnEveryMachine) {
  EXPECT_EQ(fingerprint_of_all(), 15701094226826227543u);
}

TEST(PrimitiveScenes, HoldOnePrimitiveThatReachesOpenGlExactly) {
  for (PrimitiveKind kind : kKinds)
    for (std::uint64_t index = 0; index < kScenes; ++index) {
      const Scene scene = random_scene({kSeed, kind, Surface::fbo}, index);
      ASSERT_EQ(fault_of(scene), "") << name_of(kind) << " " << index;
      ASSERT_EQ(scene.draws.size(), 1u);
      ASSERT_EQ(kind_of(scene.draws[0].primitive), kind);
      ASSERT_EQ(scene.draws[0].vertices.size(), static_cast<std::size_t>(vertices_of(kind)));
      ASSERT_EQ(scene.draws[0].line_width, Fixed::from_integer(1));
      for (const Vertex& vertex : scene.draws[0].vertices) ASSERT_EQ(vertex.z, Fixed());
      const Fixed size = scene.draws[0].point_size;
      ASSERT_TRUE(size >= Fixed::from_integer(1) && size <= Fixed::from_integer(64));
      ASSERT_EQ(size.raw() % 4096, 0);
    }
}

TEST(PrimitiveScenes, AThirdOfThemHoldsATie) {
  for (PrimitiveKind kind : kKinds) {
    std::uint64_t ties = 0;
    for (std::uint64_t index = 0; index < kScenes; ++index)
      if (has_tie(random_scene({kSeed, kind, Surface::fbo}, index))) ++ties;
    std::printf("%s: %.1f %% hold a tie\n", name_of(kind),
                100.0 * static_cast<double>(ties) / static_cast<double>(kScenes));
    EXPECT_GE(3 * ties, kScenes) << name_of(kind);
  }
}

TEST(PrimitiveScenes, AreOfEverySizeFrom1To256) {
  for (PrimitiveKind kind : kKinds) {
    Octaves targets;
    Octaves extents;
    Octaves sizes;
    std::int64_t largest = 0;
    for (std::uint64_t index = 0; index < kScenes; ++index) {
      const Scene scene = random_scene({kSeed, kind, Surface::fbo}, index);
      targets.add(Fixed::from_integer(scene.target.width - 1).raw());
      extents.add(extent_of(scene));
      sizes.add(scene.draws[0].point_size.raw());
      largest = std::max(largest, extent_of(scene));
    }
    targets.print("targets");
    extents.print("extents");
    if (kind == PrimitiveKind::point) sizes.print("point sizes");
    // Targets of 4 hold extents of two octaves.
    for (std::size_t octave = 2; octave <= 8; ++octave)
      EXPECT_GT(targets.at(octave), static_cast<int>(kScenes) / 10) << octave;
    if (kind == PrimitiveKind::point) {
      EXPECT_GT(sizes.at(1), static_cast<int>(kScenes) / 2);
      for (std::size_t octave = 2; octave <= 6; ++octave) EXPECT_GT(sizes.at(octave), 200);
      continue;
    }
    for (std::size_t octave = 1; octave <= 8; ++octave)
      EXPECT_GT(extents.at(octave), static_cast<int>(kScenes) / 15) << octave;
    EXPECT_GT(largest, Fixed::from_integer(254).raw());
  }
}

TEST(PrimitiveScenes, FewHaveNoLengthOrArea) {
  int points = 0;
  int flat = 0;
  for (std::uint64_t index = 0; index < kScenes; ++index) {
    const Scene line = random_scene({kSeed, PrimitiveKind::line, Surface::fbo}, index);
    if (line.draws[0].vertices[0].position == line.draws[0].vertices[1].position) ++points;
    const Scene triangle = random_scene({kSeed, PrimitiveKind::triangle, Surface::fbo}, index);
    if (doubled_area(triangle_of(triangle, 0)) == 0) ++flat;
  }
  std::printf("%d lines without length, %d triangles without area\n", points, flat);
  EXPECT_GT(points, 20);
  EXPECT_LT(points, static_cast<int>(kScenes) / 20);
  EXPECT_GT(flat, 20);
  EXPECT_LT(flat, static_cast<int>(kScenes) / 20);
}

TEST(RandomWideLines, AreFromFiveQuartersTo16Wide) {
  std::set<std::int64_t> widths;
  std::uint64_t asked = 0, ties = 0;
  for (std::uint64_t index = 0; index < kScenes; ++index) {
    if (!is_in_share(index)) continue;
    ++asked;
    const Scene scene = random_wide_line(kSeed, Surface::fbo, index);
    ASSERT_EQ(fault_of(scene), "");
    widths.insert(scene.draws[0].line_width.raw());
    if (has_tie(scene)) ++ties;
  }
  std::printf("wide lines: %.1f %% hold a tie\n",
              100.0 * static_cast<double>(ties) / static_cast<double>(asked));
  EXPECT_EQ(widths.size(), 60u);
  EXPECT_EQ(*widths.begin(), Fixed::from_integer(5).raw() / 4);
  EXPECT_EQ(*widths.rbegin(), Fixed::from_integer(16).raw());
}

TEST(SharedEdgeScenes, HoldTwoTrianglesOnOppositeSidesOfOneEdge) {
  std::uint64_t through_samples = 0;
  for (std::uint64_t index = 0; index < kScenes; ++index) {
    const Scene scene = shared_edge_scene(kSeed, Surface::window, index);
    ASSERT_EQ(fault_of(scene), "");
    ASSERT_EQ(scene.target.surface, Surface::window);
    ASSERT_EQ(scene.draws[0].vertices.size(), 6u);
    const auto edge = shared_edge(triangle_of(scene, 0), triangle_of(scene, 1));
    ASSERT_TRUE(edge) << index;
    bool through = false;
    for (int y = 0; y < scene.target.height && !through; ++y)
      for (int x = 0; x < scene.target.width && !through; ++x) {
        const Point p = pixel_centre(x, y);
        const auto [left, right] = std::minmax({edge->a.x, edge->b.x});
        const auto [low, high] = std::minmax({edge->a.y, edge->b.y});
        through = cross(edge->a, edge->b, p) == 0 && p.x >= left && p.x <= right && p.y >= low &&
                  p.y <= high;
      }
    if (through) ++through_samples;
  }
  std::printf("shared edges: %.1f %% pass through a sample\n",
              100.0 * static_cast<double>(through_samples) / static_cast<double>(kScenes));
  EXPECT_GE(2 * through_samples, kScenes);
}

}  // namespace
}  // namespace edgecase
