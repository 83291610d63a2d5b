// SPDX-License-Identifier: MIT
#include "rules/coverage/triangle_fill.h"

#include <gtest/gtest.h>

namespace edgecase {
namespace {

using Positions = std::array<HomogeneousPoint, 3>;

constexpr CullMode kCullModes[] = {CullMode::none, CullMode::front, CullMode::back,
                                   CullMode::front_and_back};

// A primitive of one draw, with its state.
struct Drawn {
  Draw draw;
  ScenePrimitive primitive;
  Drawn(PrimitiveKind kind, FrontFace front, CullMode cull) {
    draw.front_face = front;
    draw.cull = cull;
    primitive.kind = kind;
    primitive.state = &draw;
  }
  Drawn(const Drawn&) = delete;
  Drawn& operator=(const Drawn&) = delete;
};

bool faces_front(const Positions& positions, FrontFace front, FacingMethod method) {
  const Drawn drawn(PrimitiveKind::triangle, front, CullMode::none);
  return is_front_facing(drawn.primitive, positions, method);
}

// Every triangle of a grid of 4 by 4 points, each with a w of its own; the oracle is the shoelace
// formula of 14.6.1.
template <class Visit>
void visit_triangles(Visit visit) {
  constexpr int kSide = 4;
  constexpr int kPoints = kSide * kSide;
  const auto point = [](int i, int w) { return HomogeneousPoint{i % kSide * w, i / kSide * w, w}; };
  for (int a = 0; a < kPoints; ++a)
    for (int b = 0; b < kPoints; ++b)
      for (int c = 0; c < kPoints; ++c) {
        const auto product = [](int i, int j) {
          return i % kSide * (j / kSide) - j % kSide * (i / kSide);
        };
        const int twice_area = product(a, b) + product(b, c) + product(c, a);
        visit(Positions{point(a, 1), point(b, 3), point(c, 1 << 16)}, twice_area);
      }
}

TEST(PolygonFacing, IsTheSignOfTheArea) {
  int degenerate = 0;
  visit_triangles([&](const Positions& positions, int twice_area) {
    EXPECT_EQ(faces_front(positions, FrontFace::ccw, FacingMethod::as_set), twice_area > 0);
    EXPECT_EQ(faces_front(positions, FrontFace::cw, FacingMethod::as_set), twice_area < 0);
    degenerate += twice_area == 0 ? 1 : 0;
  });
  EXPECT_GT(degenerate, 0);
}

TEST(PolygonFacing, AlternativesDiffer) {
  visit_triangles([&](const Positions& positions, int twice_area) {
    EXPECT_EQ(faces_front(positions, FrontFace::ccw, FacingMethod::reversed), twice_area < 0);
    EXPECT_EQ(faces_front(positions, FrontFace::cw, FacingMethod::reversed), twice_area > 0);
    EXPECT_EQ(faces_front(positions, FrontFace::ccw, FacingMethod::always_ccw), twice_area > 0);
    EXPECT_EQ(faces_front(positions, FrontFace::cw, FacingMethod::always_ccw), twice_area > 0);
    EXPECT_EQ(faces_front(positions, FrontFace::cw, FacingMethod::not_culled), twice_area < 0);
  });
}

// Cut, all vertices of both triangles are in (0, 0); rounded, those of the first are in (1, 1).
TEST(PolygonFacing, OfWholePixelsForgetsFractions) {
  constexpr std::int64_t kW = 8;
  const Positions within = {HomogeneousPoint{4, 4, kW}, {7, 4, kW}, {4, 7, kW}};
  const Positions across = {HomogeneousPoint{1, 1, kW}, {7, 1, kW}, {1, 7, kW}};
  const auto faces = [](const Positions& positions, FacingMethod method) {
    return faces_front(positions, FrontFace::ccw, method);
  };
  EXPECT_TRUE(faces(within, FacingMethod::as_set));
  EXPECT_FALSE(faces(within, FacingMethod::of_cut_vertices));
  EXPECT_FALSE(faces(within, FacingMethod::of_rounded_vertices));
  EXPECT_FALSE(faces(across, FacingMethod::of_cut_vertices));
  EXPECT_TRUE(faces(across, FacingMethod::of_rounded_vertices));
}

TEST(PolygonFacing, CullingDropsTheFacesOfItsName) {
  visit_triangles([&](const Positions& positions, int) {
    for (const FrontFace front : {FrontFace::ccw, FrontFace::cw})
      for (const FacingMethod method : values_of<FacingMethod>()) {
        const bool is_front = faces_front(positions, front, method);
        const bool culls = method != FacingMethod::not_culled;
        const bool dropped[] = {false, culls && is_front, culls && !is_front, culls};
        for (std::size_t i = 0; i < 4; ++i) {
          const Drawn drawn(PrimitiveKind::triangle, front, kCullModes[i]);
          EXPECT_EQ(is_culled(drawn.primitive, positions, method), dropped[i]);
        }
      }
  });
}

// The smallest areas that coordinates allow: 2^-32 of a pixel at 2^13 pixels, and less with w.
TEST(PolygonFacing, IsExactForSlivers) {
  constexpr std::int64_t kFar = std::int64_t{1} << 46;
  constexpr std::int64_t kW = std::int64_t{1} << 32;
  const HomogeneousPoint origin{0, 0, kW};
  const auto is_counter_clockwise = [](const Positions& positions) {
    return faces_front(positions, FrontFace::ccw, FacingMethod::as_set);
  };
  EXPECT_TRUE(is_counter_clockwise({origin, {kFar, kFar - 1, kW}, {kFar, kFar, kW}}));
  EXPECT_FALSE(is_counter_clockwise({origin, {kFar, kFar, kW}, {kFar, kFar - 1, kW}}));
  EXPECT_FALSE(is_counter_clockwise({origin, {kFar, kFar, kW}, {1, 1, kW}}));
  EXPECT_TRUE(is_counter_clockwise({origin, {kFar, kFar, kW}, {kFar - 1, kFar, kW}}));
}

TEST(PolygonFacing, PointsAndLinesFaceTheFrontAndStay) {
  const Positions clockwise = {HomogeneousPoint{0, 0, 1}, {0, 1, 1}, {1, 0, 1}};
  for (const PrimitiveKind kind : {PrimitiveKind::point, PrimitiveKind::line})
    for (const FrontFace front : {FrontFace::ccw, FrontFace::cw})
      for (const CullMode cull : kCullModes)
        for (const FacingMethod method : values_of<FacingMethod>()) {
          const Drawn drawn(kind, front, cull);
          EXPECT_TRUE(is_front_facing(drawn.primitive, clockwise, method));
          EXPECT_FALSE(is_culled(drawn.primitive, clockwise, method));
        }
}

}  // namespace
}  // namespace edgecase
