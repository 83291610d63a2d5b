// SPDX-License-Identifier: MIT
//
// The depth test on the OpenGL side, the depth range and polygon offsets: which fragments pass, and
// what is stored.
#include <gmock/gmock.h>

#include <cmath>
#include <utility>

#include "tests/reference/operation_scenes.h"

namespace edgecase {
namespace {

using ::testing::Each;

constexpr DepthFormat kFormats[] = {DepthFormat::depth16, DepthFormat::depth24,
                                    DepthFormat::depth32f};

// Of a nearer, an equal and a farther fragment, those that pass.
constexpr std::pair<CompareFunction, const char*> kPassing[] = {
    {CompareFunction::never, "..."},   {CompareFunction::less, "#.."},
    {CompareFunction::equal, ".#."},   {CompareFunction::lequal, "##."},
    {CompareFunction::greater, "..#"}, {CompareFunction::notequal, "#.#"},
    {CompareFunction::gequal, ".##"},  {CompareFunction::always, "###"},
};
constexpr double kDepths[] = {-0.5, 0, 0.5};

class DepthOperationsTest : public OperationsTest {
 protected:
  // Three red pixels at depth 0.5, and green fragments before, at and behind it.
  Scene three_comparisons(DepthFormat format, DepthTest test) const {
    Scene scene = row(3, format, StencilFormat::none);
    for (int x = 0; x < 3; ++x) scene.draws.push_back(point_at(x, 0, {1, 0, 0, 1}));
    for (int x = 0; x < 3; ++x) {
      scene.draws.push_back(point_at(x, kDepths[x], {0, 1, 0, 1}));
      scene.draws.back().operations.depth = test;
    }
    return scene;
  }
};

TEST_P(DepthOperationsTest, FunctionsPassWhatTheyAreNamedAfter) {
  for (DepthFormat format : kFormats) {
    for (const auto& [function, passing] : kPassing) {
      for (bool write : {true, false}) {
        SCOPED_TRACE(std::string(name_of(format)) + ' ' + name_of(function));
        const auto rendering = drawn(three_comparisons(format, {function, write}));
        if (!rendering) continue;
        EXPECT_EQ(hits_beyond(*rendering, 1), passing);
        EXPECT_EQ(rendering->fragments.size(), 6u);
        for (int x = 0; x < 3; ++x) {
          const bool passes = passing[x] == '#';
          EXPECT_THAT(pixel(*rendering, x, 0),
                      testing::ElementsAre(passes ? 0 : 255, passes ? 255 : 0, 0, 255));
          const double expected = passes && write ? (kDepths[x] + 1) / 2 : 0.5;
          EXPECT_NEAR(rendering->depths[static_cast<std::size_t>(x)], expected, 1.0 / 65535);
        }
      }
    }
  }
}

TEST_P(DepthOperationsTest, WithoutABufferEveryTestPasses) {
  Scene scene = three_comparisons(DepthFormat::none, {CompareFunction::never, true});
  const auto rendering = drawn(scene);
  ASSERT_TRUE(rendering.has_value());
  EXPECT_EQ(hits_beyond(*rendering, 1), "###");
  EXPECT_TRUE(rendering->depths.empty());
}

TEST_P(DepthOperationsTest, ClearedDepthsAreThoseOfTheTarget) {
  for (DepthFormat format : kFormats) {
    for (float cleared : {0.0f, 0.25f, 0.75f, 1.0f}) {
      Scene scene = row(3, format, StencilFormat::none);
      scene.target.clear_depth = cleared;
      scene.draws = {point_at(0, -0.25), point_at(1, 0.25), point_at(2, 0.75)};
      for (Draw& draw : scene.draws) draw.operations.depth = {CompareFunction::less, false};
      const auto rendering = drawn(scene);
      if (!rendering) continue;
      const std::string passing = cleared < 0.5f ? "..." : cleared < 1 ? "##." : "###";
      EXPECT_EQ(hits_beyond(*rendering, 0), passing) << cleared;
      for (double depth : rendering->depths)
        EXPECT_NEAR(depth, static_cast<double>(cleared), 1.0 / 65535);
      EXPECT_EQ(rendering->fragments.size(), 3u);
    }
  }
}

TEST_P(DepthOperationsTest, TheDepthRangeMapsNearAndFar) {
  constexpr DepthRange kRanges[] = {{1, 0}, {0.25f, 0.5f}, {0.75f, 0.125f}, {0.5f, 0.5f}, {0, 1}};
  for (DepthFormat format : kFormats) {
    for (const DepthRange& range : kRanges) {
      Scene scene = row(5, format, StencilFormat::none);
      scene.depth_range = range;
      for (int x = 0; x < 5; ++x) scene.draws.push_back(point_at(x, (x - 2) * 0.5));
      const auto rendering = drawn(scene);
      if (!rendering) continue;
      ASSERT_EQ(rendering->fragments.size(), 5u);
      for (std::size_t x = 0; x < 5; ++x) {
        const auto near = static_cast<double>(range.near);
        const auto far = static_cast<double>(range.far);
        const double expected = near + (far - near) * static_cast<double>(x) / 4;
        EXPECT_NEAR(rendering->fragments[x].depth, expected, 1e-7);
        EXPECT_NEAR(rendering->depths[x], expected, 1.0 / 65535);
      }
    }
  }
}

// A plane that rises by 1/16 of the depth range with each pixel to the right.
Draw slope(int width) {
  Draw draw = rectangle(0, 0, width * 256, 256);
  for (Vertex& vertex : draw.vertices)
    vertex.z =
        Fixed::from_raw(vertex.position.x.raw() > 0 ? (width - 8) * Fixed::kOne / 8 : -Fixed::kOne);
  return draw;
}

class PolygonOffsetTest : public OperationsTest {
 protected:
  // By how much an offset moves the depths of a draw's fragments, in a target of this format: all
  // that are not clamped alike, or the test fails.
  std::optional<double> shift_of(const Draw& draw, PolygonOffset offset, DepthFormat format,
                                 double tolerated) {
    Scene scene = row(8, format, StencilFormat::none);
    scene.draws = {draw};
    const auto before = drawn(scene);
    scene.draws[0].polygon_offset = offset;
    const auto after = drawn(scene);
    if (!before || !after) return std::nullopt;
    EXPECT_EQ(before->fragments.size(), after->fragments.size());
    EXPECT_FALSE(before->fragments.empty());
    const double shift = after->fragments[0].depth - before->fragments[0].depth;
    for (std::size_t i = 0; i < before->fragments.size(); ++i) {
      EXPECT_NEAR(after->fragments[i].depth - before->fragments[i].depth, shift, tolerated);
      EXPECT_NEAR(after->depths[i] - before->depths[i], shift, tolerated + 2.0 / 65535);
    }
    return shift;
  }
};

// True for llvmpipe of Mesa 26, whose unit in a buffer of n bits is one step and not two, and which
// rounds the offset to a step.
bool offsets_by_steps(const std::string& name, DepthFormat format) {
  return name == "egl:llvmpipe" && is_mesa("26.") && format != DepthFormat::depth32f;
}

// By how much one unit moves a depth of 0.5: two steps of 2^-n in a buffer of n bits, and half a
// unit in the last place of a float's 24. zink hands on twice the units that it is given, and
// SwiftShader makes 1.01 steps of each.
double known_unit(const std::string& name, DepthFormat format) {
  const double step = format == DepthFormat::depth16 ? 0x1p-16 : 0x1p-24;
  if (offsets_by_steps(name, format)) return step;
  const bool is_zink = name.starts_with("egl:zink");
  if (format == DepthFormat::depth32f) return is_zink ? 0x1p-23 : 0x1p-24;
  if (name == "egl:zink-swiftshader") return 2 * 1.01 / 65535;
  return (is_zink ? 4 : 2) * step;
}

TEST_P(PolygonOffsetTest, UnitsAreStepsOfTheBuffer) {
  for (DepthFormat format : kFormats) {
    for (double units : {1.0, 4096.0, -4096.0}) {
      const auto shift =
          shift_of(flat_rectangle(0, 0, 8, 1, 0), {0, static_cast<float>(units), 0}, format, 1e-7);
      if (!shift) continue;
      EXPECT_GT(*shift / units, 0) << name_of(format);
      if (name().starts_with("egl:device")) continue;
      const double unit = known_unit(name(), format);
      const double rounding = offsets_by_steps(name(), format) ? unit : 0;
      EXPECT_NEAR(*shift, units * unit, std::fabs(units * unit) * 1e-3 + rounding)
          << name_of(format);
    }
  }
}

TEST_P(PolygonOffsetTest, FactorsAreMultiplesOfTheSlope) {
  for (DepthFormat format : kFormats) {
    for (float factor : {1.0f, 1.5f}) {
      const auto shift = shift_of(slope(8), {factor, 0, 0}, format, 1e-6);
      if (!shift) continue;
      EXPECT_NEAR(*shift, static_cast<double>(factor) / 16, 1e-6) << name_of(format);
    }
  }
  // A plane without a slope is not moved.
  const auto shift = shift_of(flat_rectangle(0, 0, 8, 1, 0), {2, 0, 0}, DepthFormat::depth32f, 0);
  EXPECT_EQ(shift.value_or(0), 0);
}

TEST_P(PolygonOffsetTest, IsClampedWhereItIsAskedTo) {
  Scene scene = row(8, DepthFormat::depth32f, StencilFormat::none);
  scene.draws = {slope(8)};
  scene.draws[0].polygon_offset = PolygonOffset{1, 0, 0.03125f};
  if (refusal_of(scene) ==
      "polygon offsets cannot be clamped on this driver: it lacks GL_ARB_polygon_offset_clamp") {
    EXPECT_THAT(name(), testing::HasSubstr("softpipe"));
    return;
  }
  const auto up = shift_of(slope(8), {1, 0, 0.03125f}, DepthFormat::depth32f, 1e-6);
  if (!up) return;
  EXPECT_NEAR(*up, 0.03125, 1e-6);
  // A negative clamp is the least offset; a clamp that is not reached does nothing.
  EXPECT_NEAR(
      *shift_of(flat_rectangle(0, 0, 8, 1, 0), {0, -0x1p22f, -0.125f}, DepthFormat::depth32f, 1e-6),
      -0.125, 1e-6);
  EXPECT_NEAR(*shift_of(slope(8), {1, 0, 0.5f}, DepthFormat::depth32f, 1e-6), 0.0625, 1e-6);
  // And is forgotten by the next draw.
  EXPECT_NEAR(*shift_of(slope(8), {1, 0, 0}, DepthFormat::depth32f, 1e-6), 0.0625, 1e-6);
}

TEST_P(PolygonOffsetTest, DepthsStayWithinTheirRange) {
  for (DepthFormat format : kFormats) {
    for (float units : {0x1p25f, -0x1p25f}) {
      Scene scene = row(8, format, StencilFormat::none);
      scene.draws = {flat_rectangle(0, 0, 8, 1, 0)};
      scene.draws[0].polygon_offset = PolygonOffset{0, units, 0};
      const auto rendering = drawn(scene);
      if (!rendering) continue;
      EXPECT_THAT(rendering->depths, Each(units > 0 ? 1.0 : 0.0)) << name_of(format);
      if (name().starts_with("egl:device")) continue;
      // What is told of fragments is clamped by softpipe alone.
      const bool clamps = name().find("softpipe") != std::string::npos;
      for (const Fragment& fragment : rendering->fragments)
        EXPECT_EQ(fragment.depth >= 0 && fragment.depth <= 1, clamps) << name_of(format);
    }
  }
}

TEST_P(PolygonOffsetTest, IsForPolygonsAlone) {
  const Draw line = make_draw(Primitive::lines, {{0, 128}, {8 * 256, 128}});
  for (DepthFormat format : kFormats)
    for (const Draw& draw : {point_at(3, 0.25), line})
      EXPECT_EQ(shift_of(draw, {1, 4096, 0}, format, 0).value_or(0), 0) << name_of(format);
}

INSTANTIATE_TEST_SUITE_P(OpenGl, DepthOperationsTest, EDGECASE_ALL_PLACES, place_name);
INSTANTIATE_TEST_SUITE_P(OpenGl, PolygonOffsetTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
