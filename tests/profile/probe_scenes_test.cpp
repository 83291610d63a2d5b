// SPDX-License-Identifier: MIT
//
// Probes of single primitives: each asks what it says it asks, and nothing else.
#include "profile/coverage/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <tuple>

#include "generate/grids.h"
#include "generate/random_scenes.h"
#include "generate/random_shapes.h"
#include "raster/rasterizer.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/triangle_fill.h"
#include "tests/generate/scene_checks.h"

namespace edgecase {
namespace {

Segment segment_of(const Scene& scene) {
  return {scene.draws[0].vertices[0].position, scene.draws[0].vertices[1].position};
}

Triangle triangle_of(const Scene& scene) {
  const std::vector<Vertex>& v = scene.draws[0].vertices;
  return {v[0].position, v[1].position, v[2].position};
}

// Where the point lies by the definition of the diamond's parts, written out from its distances.
bool lies_at(DiamondPlace place, Point p, PixelPosition pixel) {
  const std::int64_t half = Fixed::kOne / 2;
  const Point c = pixel_centre(pixel.x, pixel.y);
  const std::int64_t x = p.x.raw() - c.x.raw();
  const std::int64_t y = p.y.raw() - c.y.raw();
  const bool within = -half < x && x < half && -half < y && y < half;
  switch (place) {
    case DiamondPlace::left_corner:
      return x == -half && y == 0;
    case DiamondPlace::right_corner:
      return x == half && y == 0;
    case DiamondPlace::bottom_corner:
      return x == 0 && y == -half;
    case DiamondPlace::top_corner:
      return x == 0 && y == half;
    case DiamondPlace::lower_left_edge:
      return x < 0 && y < 0 && -x - y == half;
    case DiamondPlace::lower_right_edge:
      return x > 0 && y < 0 && x - y == half;
    case DiamondPlace::upper_left_edge:
      return x < 0 && y > 0 && -x + y == half;
    case DiamondPlace::upper_right_edge:
      return x > 0 && y > 0 && x + y == half;
    case DiamondPlace::inside:
      return x + y < half && x - y < half && -x + y < half && -x - y < half;
    case DiamondPlace::lower_left_outside:
      return within && -x - y > half;
    case DiamondPlace::lower_right_outside:
      return within && x - y > half;
    case DiamondPlace::upper_left_outside:
      return within && -x + y > half;
    case DiamondPlace::upper_right_outside:
      return within && x + y > half;
  }
  return false;
}

TEST(LineDirections, AreNamedByTheirSlopes) {
  const auto name = [](int dx, int dy) {
    const Point a = in_sixteenths(99, 98);
    return std::string(name_of(direction_of({a, a + RawVector{dx, dy}})));
  };
  EXPECT_EQ(name(3, 0), "right");
  EXPECT_EQ(name(3, 1), "x-major right, rising");
  EXPECT_EQ(name(3, 3), "diagonal right, rising");
  EXPECT_EQ(name(1, 3), "y-major right, rising");
  EXPECT_EQ(name(0, 3), "up");
  EXPECT_EQ(name(-1, 3), "y-major left, rising");
  EXPECT_EQ(name(-3, 3), "diagonal left, rising");
  EXPECT_EQ(name(-3, 1), "x-major left, rising");
  EXPECT_EQ(name(-3, 0), "left");
  EXPECT_EQ(name(-3, -1), "x-major left, falling");
  EXPECT_EQ(name(-3, -3), "diagonal left, falling");
  EXPECT_EQ(name(-1, -3), "y-major left, falling");
  EXPECT_EQ(name(0, -3), "down");
  EXPECT_EQ(name(1, -3), "y-major right, falling");
  EXPECT_EQ(name(3, -3), "diagonal right, falling");
  EXPECT_EQ(name(3, -1), "x-major right, falling");
}

// Every point of a pixel has at most one place, and it is the one that it has by definition.
TEST(DiamondPlaces, DivideThePixel) {
  for (int y = 0; y <= 32; ++y)
    for (int x = 0; x <= 32; ++x) {
      const Point p{Fixed::from_raw(x * 2048), Fixed::from_raw(y * 2048)};
      const auto found = place_in_pixel(p, {0, 0});
      for (int place = 0; place < kDiamondPlaces; ++place)
        ASSERT_EQ(lies_at(static_cast<DiamondPlace>(place), p, {0, 0}),
                  found == static_cast<DiamondPlace>(place))
            << x << " " << y << " " << name_of(static_cast<DiamondPlace>(place));
    }
}

// The lines that run along boundaries from an end at such a place, whatever their length.
bool must_be_tied(LineDirection direction, DiamondPlace place) {
  using enum DiamondPlace;
  switch (static_cast<int>(direction)) {
    case 0:
    case 8:
      return place == bottom_corner || place == top_corner;
    case 4:
    case 12:
      return place == left_corner || place == right_corner;
    case 2:
    case 10:
      return place <= top_corner || place == lower_right_edge || place == upper_left_edge;
    case 6:
    case 14:
      return place <= top_corner || place == lower_left_edge || place == upper_right_edge;
    default:
      return false;
  }
}

TEST(DiamondProbes, HaveTheirEndAtTheirPlaceAndNoOtherTie) {
  const std::vector<DiamondProbe> probes = diamond_probes(Surface::fbo);
  std::map<std::tuple<LineDirection, bool, DiamondPlace>, std::set<std::uint64_t>> combinations;
  int tied = 0;
  for (const DiamondProbe& probe : probes) {
    ASSERT_EQ(fault_of(probe.scene), "");
    const Segment segment = segment_of(probe.scene);
    const std::string what = std::string(name_of(probe.direction)) + " " + name_of(probe.place);
    ASSERT_EQ(direction_of(segment), probe.direction) << what;
    const Point near = probe.at_start ? segment.a : segment.b;
    const Point far = probe.at_start ? segment.b : segment.a;
    ASSERT_TRUE(lies_at(probe.place, near, probe.pixel)) << what;
    ASSERT_EQ(probe.tied_elsewhere, must_be_tied(probe.direction, probe.place)) << what;
    combinations[{probe.direction, probe.at_start, probe.place}].insert(
        fingerprint_of(probe.scene));
    if (probe.tied_elsewhere) {
      ++tied;
      continue;
    }
    const PixelPosition pixel{static_cast<int>(far.x.floor()), static_cast<int>(far.y.floor())};
    ASSERT_TRUE(lies_at(DiamondPlace::inside, far, pixel)) << what;
    ASSERT_GT(std::max(std::abs(pixel.x - probe.pixel.x), std::abs(pixel.y - probe.pixel.y)), 1);
    for (int y = 0; y < probe.scene.target.height; ++y)
      for (int x = 0; x < probe.scene.target.width; ++x) {
        const auto place = place_in_pixel(near, {x, y});
        const bool has_the_end = place && *place < DiamondPlace::inside;
        ASSERT_TRUE(has_the_end || !is_tied(segment, {x, y})) << what << " " << x << " " << y;
      }
  }
  EXPECT_EQ(combinations.size(), 16u * 2 * 13);
  for (const auto& [key, scenes] : combinations) EXPECT_EQ(scenes.size(), 4u);
  std::printf("%zu diamond probes, %d of them along boundaries\n", probes.size(), tied);
}

// The outside of a side, seen from the sample: only the sides that are left of it, and so on.
TEST(EdgeProbes, HaveOneSampleOnTheirEdgeOrCorner) {
  std::map<EdgeSide, int> sides;
  std::set<std::pair<EdgeSide, EdgeSide>> corners;
  const TieRule& open = *find_tie_rule("open");
  const TieRule& closed = *find_tie_rule("closed");
  const std::vector<EdgeProbe> probes = edge_probes(Surface::fbo);
  for (const EdgeProbe& probe : probes) {
    ASSERT_EQ(fault_of(probe.scene), "");
    const Triangle triangle = counter_clockwise(triangle_of(probe.scene));
    for (Point p : triangle) ASSERT_EQ(p.x.raw() % 4096 + p.y.raw() % 4096, 0);
    const Point sample = pixel_centre(probe.pixel.x, probe.pixel.y);
    const bool at_corner = std::find(triangle.begin(), triangle.end(), sample) != triangle.end();
    ASSERT_EQ(at_corner, probe.corner_with.has_value());
    bool found = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = triangle[i];
      const Point b = triangle[(i + 1) % 3];
      if (cross(a, b, sample) != 0 || side_of(a, b) != probe.side) continue;
      if (at_corner) {
        found = found || (b == sample && side_of(b, triangle[(i + 2) % 3]) == *probe.corner_with);
      } else {
        found = true;
      }
    }
    ASSERT_TRUE(found) << name_of(probe.side);
    for (int y = 0; y < probe.scene.target.height; ++y)
      for (int x = 0; x < probe.scene.target.width; ++x)
        ASSERT_EQ(triangle_covers(triangle, x, y, open) != triangle_covers(triangle, x, y, closed),
                  (PixelPosition{x, y} == probe.pixel));
    if (at_corner) {
      corners.insert({probe.side, *probe.corner_with});
    } else {
      ++sides[probe.side];
    }
  }
  EXPECT_EQ(sides.size(), values_of<EdgeSide>().size());
  for (const auto& [side, count] : sides) EXPECT_GE(count, 8) << name_of(side);
  std::printf("%zu edge probes, %zu kinds of corner\n", probes.size(), corners.size());
  EXPECT_GE(corners.size(), 30u);
}

// A tie rule that owns a side: by the definition of its move, not by the predicate.
TEST(EdgeProbes, TellAllTieRulesApart) {
  const std::vector<EdgeProbe> probes = edge_probes(Surface::fbo);
  std::set<std::vector<bool>> on_edges;
  std::set<std::vector<bool>> at_corners;
  for (const TieRule& rule : all_tie_rules()) {
    std::vector<bool> edges;
    std::vector<bool> corners;
    for (const EdgeProbe& probe : probes)
      (probe.corner_with ? corners : edges)
          .push_back(triangle_covers(triangle_of(probe.scene), probe.pixel.x, probe.pixel.y, rule));
    on_edges.insert(edges);
    at_corners.insert(corners);
  }
  EXPECT_EQ(on_edges.size(), all_tie_rules().size());
  EXPECT_EQ(at_corners.size(), all_tie_rules().size());
}

TEST(ProvokingProbes, GiveEveryVertexAColourAndEveryPrimitivePixels) {
  CoverageChoice choice;
  choice.ties = *find_tie_rule("left-top");
  choice.line.boundary = find_diamond_boundary("left-bottom");
  std::map<std::pair<Primitive, ProvokingVertex>, std::size_t> most;
  const std::vector<Scene> probes = provoking_probes(Surface::window);
  for (const Scene& scene : probes) {
    ASSERT_EQ(fault_of(scene), "");
    ASSERT_FALSE(has_tie(scene)) << name_of(scene.draws[0].primitive);
    const Draw& draw = scene.draws[0];
    ASSERT_EQ(draw.interpolation, Interpolation::flat);
    std::set<Color> colors{scene.target.clear};
    for (const Vertex& vertex : draw.vertices) colors.insert(vertex.color);
    ASSERT_EQ(colors.size(), draw.vertices.size() + 1);
    const auto primitives = primitives_of(scene);
    std::map<PixelPosition, int> hits;
    for (const ScenePrimitive& primitive : primitives)
      for (PixelPosition p : covered_pixels(primitive, scene.target, choice)) ++hits[p];
    for (const ScenePrimitive& primitive : primitives) {
      const auto pixels = covered_pixels(primitive, scene.target, choice);
      ASSERT_TRUE(
          std::any_of(pixels.begin(), pixels.end(), [&](PixelPosition p) { return hits[p] == 1; }))
          << name_of(draw.primitive) << " " << primitive.index << " of " << primitives.size();
    }
    auto& count = most[{draw.primitive, draw.provoking_vertex}];
    count = std::max(count, primitives.size());
  }
  EXPECT_EQ(most.size(), 14u);
  for (const auto& [key, count] : most) EXPECT_EQ(count, 4u) << name_of(key.first);
  std::printf("%zu provoking probes\n", probes.size());
}

TEST(ClipProbes, ReachBeyondTheirSidesWithExactClipCoordinates) {
  std::map<std::pair<PrimitiveKind, unsigned>, int> counts;
  const std::vector<ClipProbe> probes = clip_probes(Surface::fbo);
  std::size_t unseen = 0;
  for (const ClipProbe& probe : probes) {
    ASSERT_EQ(rounding_of(probe.scene), "");
    ASSERT_EQ(rounding_of(probe.unclipped), "");
    const int size = probe.scene.target.width;
    ASSERT_EQ(probe.scene.viewport.width, size);
    unsigned sides = 0;
    for (const Vertex& vertex : probe.scene.draws[0].vertices) {
      const double x = vertex.position.x.to_double();
      const double y = vertex.position.y.to_double();
      ASSERT_TRUE(x > -3 * size && x < 4 * size && y > -3 * size && y < 4 * size);
      sides |= (x < 0 ? 1u : 0u) | (x > size ? 2u : 0u) | (y < 0 ? 4u : 0u) | (y > size ? 8u : 0u);
      const Viewport& large = probe.unclipped.viewport;
      ASSERT_TRUE(x > large.x && x < large.x + large.width && y > large.y &&
                  y < large.y + large.height);
    }
    ASSERT_EQ(sides, probe.sides);
    ASSERT_NE(sides, 0u);
    Scene same = probe.unclipped;
    same.viewport = probe.scene.viewport;
    ASSERT_EQ(fingerprint_of(same), fingerprint_of(probe.scene));
    ++counts[{kind_of(probe.scene.draws[0].primitive), sides}];
    if (rasterize(probe.scene, Policy()).fragments.empty()) ++unseen;
  }
  for (const PrimitiveKind kind :
       {PrimitiveKind::point, PrimitiveKind::line, PrimitiveKind::triangle})
    for (const unsigned sides : {1u, 2u, 4u, 8u, 5u, 6u, 9u, 10u})
      EXPECT_GE((counts[{kind, sides}]), 12) << name_of(kind) << " " << sides;
  std::printf("%zu clip probes, %zu of them without a fragment\n", probes.size(), unseen);
  EXPECT_LT(unseen, probes.size() / 4);
}

}  // namespace
}  // namespace edgecase
