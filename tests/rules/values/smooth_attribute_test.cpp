// SPDX-License-Identifier: MIT
#include "rules/values/attributes.h"

#include <gtest/gtest.h>

#include "rules/values/framebuffer.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

const Interpolant kRamp{
    PrimitiveKind::triangle, {vertex_at(0, 0), vertex_at(8, 0), vertex_at(0, 8)}, {0, 1, 0}};

TEST(SmoothAttribute, ExactIntervalIsNarrowAndHoldsTheValue) {
  const Interval value = interpolate_exact(kRamp, at(2.5, 1.5));
  EXPECT_TRUE(value.contains(2.5 / 8));
  EXPECT_LT(value.high - value.low, 1e-14);
}

TEST(SmoothAttribute, PermittedHoldsExactAndTheMovesOfTheVertices) {
  const Interval permitted = interpolate_permitted(kRamp, at(2.5, 1.5), reach_of(8));
  EXPECT_TRUE(permitted.contains(2.5 / 8));
  // A vertex moved by almost 1/256 changes the ramp by about 1/2048.
  EXPECT_TRUE(permitted.contains(2.5 / 8 + 0.9 / 2048));
  EXPECT_FALSE(permitted.contains(2.5 / 8 + 0.01));
  EXPECT_LT(permitted.high - permitted.low, 0.01);
}

TEST(SmoothAttribute, ASliverPermitsMuchAndAnEmptyTriangleEverything) {
  const Interpolant sliver{PrimitiveKind::triangle,
                           {vertex_at(0, 0), vertex_at(8, 0), vertex_at(0, 1.0 / 512)},
                           {0, 0, 1}};
  EXPECT_TRUE(interpolate_permitted(sliver, at(2.5, 0.5), reach_of(8)).contains(1e6));
}

TEST(SmoothAttribute, ConstantsStayConstantToTheBit) {
  const double value = 0.1f;
  for (PrimitiveKind kind : {PrimitiveKind::point, PrimitiveKind::line, PrimitiveKind::triangle}) {
    const Interpolant f{
        kind, {vertex_at(0.25, 0.5), vertex_at(7, 3), vertex_at(2, 6)}, {value, value, value}};
    const Interval exact = interpolate_exact(f, at(2.5, 2.5));
    EXPECT_EQ(exact.low, value);
    EXPECT_EQ(exact.high, value);
  }
}

TEST(SmoothAttribute, LinesInterpolateByProjection) {
  const Interpolant f{PrimitiveKind::line, {vertex_at(0, 0), vertex_at(4, 4), {}}, {0, 1, 0}};
  EXPECT_TRUE(interpolate_exact(f, at(2.5, 1.5)).contains(0.5));
}

TEST(SmoothAttribute, NamesOfChoicesReadAndNoOthersDo) {
  const std::pair<const char*, PerspectiveChoice> kPerspective[] = {
      {"as-set", PerspectiveChoice::as_set},
      {"always", PerspectiveChoice::always},
      {"never", PerspectiveChoice::never},
      {"w-of-centre", PerspectiveChoice::w_of_centre}};
  for (const auto& [name, choice] : kPerspective) {
    // Another one before, so that the name alone can have set it.
    PerspectiveChoice read =
        choice == PerspectiveChoice::never ? PerspectiveChoice::always : PerspectiveChoice::never;
    EXPECT_TRUE(parse_name(name, read)) << name;
    EXPECT_EQ(read, choice) << name;
  }
  const std::pair<const char*, AttributePositions> kPositions[] = {
      {"unsnapped", AttributePositions::unsnapped}, {"snapped", AttributePositions::snapped}};
  for (const auto& [name, choice] : kPositions) {
    AttributePositions read = choice == AttributePositions::snapped ? AttributePositions::unsnapped
                                                                    : AttributePositions::snapped;
    EXPECT_TRUE(parse_name(name, read)) << name;
    EXPECT_EQ(read, choice) << name;
  }
  PerspectiveChoice perspective = PerspectiveChoice::always;
  EXPECT_FALSE(parse_name("sometimes", perspective));
  EXPECT_EQ(perspective, PerspectiveChoice::always);
  AttributePositions positions = AttributePositions::snapped;
  EXPECT_FALSE(parse_name("anywhere", positions));
  EXPECT_EQ(positions, AttributePositions::snapped);
}

TEST(Framebuffer, EitherNeighbourOfAnIntermediateValue) {
  const Unorm8Range exact = unorm8_permitted(Interval(1.0));
  EXPECT_EQ(exact.low, 255);
  EXPECT_EQ(exact.high, 255);
  const Unorm8Range between = unorm8_permitted(Interval(100.25 / 255));
  EXPECT_EQ(between.low, 100);
  EXPECT_EQ(between.high, 101);
  const Unorm8Range clamped = unorm8_permitted(Interval(-3, 7));
  EXPECT_EQ(clamped.low, 0);
  EXPECT_EQ(clamped.high, 255);
  const Unorm8Range below = unorm8_permitted(Interval(-3, -2));
  EXPECT_EQ(below.low, 0);
  EXPECT_EQ(below.high, 0);
  const Unorm8Range above = unorm8_permitted(Interval(2, 3));
  EXPECT_EQ(above.low, 255);
  EXPECT_EQ(above.high, 255);
}

}  // namespace
}  // namespace edgecase
