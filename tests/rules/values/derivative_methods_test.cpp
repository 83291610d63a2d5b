// SPDX-License-Identifier: MIT
//
// Derivatives of lines and points, of what is the same everywhere and of what has no extent; where
// quads begin; names.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "rules/values/derivative.h"
#include "tests/rules/values/interpolants.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

constexpr double kReach = 1.0 / 256;
constexpr Axis kAxes[] = {Axis::x, Axis::y};

// ------------------------------------------------------------------------------------------ lines

// Of (0 or 1 at the ends) the share is (p - a).(b - a) / |b - a|^2, or (p - a)/(b - a) on the axis.
TEST(DerivativeOfLines, ByEitherParameter) {
  Interpolant f{PrimitiveKind::line, {vertex_at(1, 1), vertex_at(9, 5), {}}, {0, 1, 0}};
  for (const bool steep : {false, true}) {
    if (steep) f.positions[1] = vertex_at(5, 9);
    const Axis major = steep ? Axis::y : Axis::x, minor = steep ? Axis::x : Axis::y;
    f.line_parameter = LineParameter::projection;
    const auto expect = [&](Axis axis, Wide slope) {
      EXPECT_TRUE(holds(differentiate_exact(f, at(3.5, 3.5), axis), slope));
      const Interval inexact = differentiate_inexact(f, at(3.5, 3.5), axis);
      EXPECT_TRUE(holds(inexact, slope));
      EXPECT_LT(width_of(inexact), 3e-5);
      const Interval permitted = differentiate_permitted(f, at(3.5, 3.5), axis, kReach);
      EXPECT_TRUE(holds(permitted, inexact));
      EXPECT_LT(width_of(permitted), 2e-3);
    };
    expect(major, static_cast<Wide>(8) / 80);
    expect(minor, static_cast<Wide>(4) / 80);
    f.line_parameter = LineParameter::major_axis;
    expect(major, static_cast<Wide>(1) / 8);
    const Interval across = differentiate_exact(f, at(3.5, 3.5), minor);
    EXPECT_TRUE(across.contains(0));
    EXPECT_LT(width_of(across), 1e-14);
    EXPECT_LT(differentiate_permitted(f, at(3.5, 3.5), minor, kReach).high, 1e-300);
  }
}

TEST(DerivativeOfPoints, IsNone) {
  const Interpolant f{PrimitiveKind::point, {vertex_at(1, 1), {}, {}}, {3, 4, 5}};
  const QuadPixel at{{1, 1}, {0, 0}};
  for (const Interval value : {derivative_exact(f, at, Axis::x, DerivativeMethod::fine),
                               differentiate_exact(f, edgecase::at(1, 1), Axis::x),
                               differentiate_inexact(f, edgecase::at(1, 1), Axis::x),
                               differentiate_permitted(f, edgecase::at(1, 1), Axis::x, kReach)}) {
    EXPECT_EQ(value.low, 0);
    EXPECT_EQ(value.high, 0);
  }
}

// Only what is the same at all vertices, at both ends, has no derivative for sure.
TEST(Derivative, AllVerticesCountForAConstant) {
  using Values = std::array<Interval, 3>;
  const Interval wide(0, 1), low(0, 0.5), high(0.5, 1);
  for (const Values& values :
       {Values{1, 1, 9}, Values{1, 9, 1}, Values{9, 1, 1}, Values{9, 1, 1}, Values{wide, low, low},
        Values{wide, high, high}, Values{low, wide, wide}, Values{high, wide, wide}}) {
    const Interpolant f{
        PrimitiveKind::triangle, {vertex_at(0, 0), vertex_at(8, 1), vertex_at(1, 8)}, values};
    for (const Axis axis : kAxes)
      EXPECT_GT(derivative_exact(f, {{2, 2}, {2, 2}}, axis, DerivativeMethod::fine).magnitude(),
                0.01);
  }
}

TEST(Derivative, WithoutExtentNothingIsKnown) {
  for (const PrimitiveKind kind : {PrimitiveKind::line, PrimitiveKind::triangle}) {
    const Interpolant f{kind, {vertex_at(1, 1), vertex_at(1, 1), vertex_at(3, 3)}, {3, 4, 5}};
    for (const DerivativeMethod method : values_of<DerivativeMethod>())
      EXPECT_TRUE(is_everything(derivative_exact(f, {{2, 2}, {2, 2}}, Axis::y, method)));
    EXPECT_TRUE(is_everything(PermittedDerivatives(f, kReach).at({2, 2}, Derivative::y_fine)));
  }
}

// ------------------------------------------------------------------------------------------ quads

TEST(Quads, BeginAtEvenColumnsAndRowsCountedFromEitherSide) {
  struct Row {
    int y, height;
    bool top_down;
    int quad;
  };
  for (const Row& row : {Row{0, 6, false, 0}, Row{1, 6, false, 0}, Row{2, 6, false, 2},
                         Row{0, 5, false, 0}, Row{1, 5, false, 0}, Row{4, 5, false, 4},
                         // From the top, an even height is the same.
                         Row{0, 6, true, 0}, Row{1, 6, true, 0}, Row{5, 6, true, 4},
                         // Rows 4 and 3, 2 and 1, and 0 with none below it.
                         Row{4, 5, true, 3}, Row{3, 5, true, 3}, Row{2, 5, true, 1},
                         Row{1, 5, true, 1}, Row{0, 5, true, -1}})
    for (const int x : {0, 1, 6, 7}) {
      const QuadPixel at =
          in_quad({x, row.y}, row.top_down ? RowOrder::top_down : RowOrder::bottom_up, row.height);
      EXPECT_EQ(at.pixel.x, x);
      EXPECT_EQ(at.pixel.y, row.y);
      EXPECT_EQ(at.quad.x, x < 2 ? 0 : 6);
      EXPECT_EQ(at.quad.y, row.quad) << row.y << " of " << row.height;
    }
}

// ------------------------------------------------------------------------------------------ names

TEST(DerivativeNames, AreParsedAsTheyAreWritten) {
  std::set<std::string> names;
  for (const DerivativeMethod method : values_of<DerivativeMethod>()) {
    DerivativeMethod parsed{};
    EXPECT_TRUE(parse_name(name_of(method), parsed));
    EXPECT_EQ(parsed, method);
    names.insert(name_of(method));
  }
  EXPECT_EQ(names.size(), 9u);
  DerivativeMethod untouched = DerivativeMethod::forward;
  EXPECT_FALSE(parse_name("backward", untouched));
  EXPECT_EQ(untouched, DerivativeMethod::forward);
}

TEST(DerivativeNames, FormsAndAxes) {
  const char* const names[] = {"dFdx", "dFdy", "dFdxFine", "dFdyFine", "dFdxCoarse", "dFdyCoarse"};
  const char* const rules[] = {"derivative.plain", "derivative.fine", "derivative.coarse"};
  for (std::size_t i = 0; i < kDerivatives; ++i) {
    const auto derivative = static_cast<Derivative>(i);
    EXPECT_STREQ(name_of(derivative), names[i]);
    EXPECT_EQ(derivative_rule_of(derivative), rules[i / 2]);
    EXPECT_EQ(axis_of(derivative), i % 2 == 0 ? Axis::x : Axis::y);
  }
  EXPECT_EQ(derivative_rule().id, rules[0]);
  EXPECT_EQ(fine_derivative_rule().id, rules[1]);
  EXPECT_EQ(coarse_derivative_rule().id, rules[2]);
}

}  // namespace
}  // namespace edgecase
