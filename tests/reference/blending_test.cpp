// SPDX-License-Identifier: MIT
//
// Blending and colour masks on the OpenGL side, against the formulas worked out here: every factor
// and every equation, colour and alpha each with its own (GL 4.6 core, 17.3.6).
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/reference/operation_scenes.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;

using Rgba = std::array<double, 4>;
using F = BlendFactor;
using E = BlendEquation;

constexpr std::array<F, 15> kFactors = {F::zero,
                                        F::one,
                                        F::src_color,
                                        F::one_minus_src_color,
                                        F::dst_color,
                                        F::one_minus_dst_color,
                                        F::src_alpha,
                                        F::one_minus_src_alpha,
                                        F::dst_alpha,
                                        F::one_minus_dst_alpha,
                                        F::constant_color,
                                        F::one_minus_constant_color,
                                        F::constant_alpha,
                                        F::one_minus_constant_alpha,
                                        F::src_alpha_saturate};
constexpr std::array<E, 5> kEquations = {E::add, E::subtract, E::reverse_subtract, E::min, E::max};

// Source, destination and constant; the destination is made of codes.
constexpr Rgba kSource = {0.25, 0.5, 0.875, 0.625};
constexpr Rgba kDestination = {204 / 255.0, 51 / 255.0, 102 / 255.0, 153 / 255.0};
constexpr Rgba kConstant = {0.125, 0.75, 0.375, 0.5};

Color to_color(const Rgba& rgba) {
  Color color{};
  std::transform(rgba.begin(), rgba.end(), color.begin(),
                 [](double component) { return static_cast<float>(component); });
  return color;
}

// The factor of component c.
double factor_of(F factor, std::size_t c, const Rgba& s, const Rgba& d) {
  switch (factor) {
    case F::zero:
      return 0;
    case F::one:
      return 1;
    case F::src_color:
      return s[c];
    case F::one_minus_src_color:
      return 1 - s[c];
    case F::dst_color:
      return d[c];
    case F::one_minus_dst_color:
      return 1 - d[c];
    case F::src_alpha:
      return s[3];
    case F::one_minus_src_alpha:
      return 1 - s[3];
    case F::dst_alpha:
      return d[3];
    case F::one_minus_dst_alpha:
      return 1 - d[3];
    case F::constant_color:
      return kConstant[c];
    case F::one_minus_constant_color:
      return 1 - kConstant[c];
    case F::constant_alpha:
      return kConstant[3];
    case F::one_minus_constant_alpha:
      return 1 - kConstant[3];
    case F::src_alpha_saturate:
      return c == 3 ? 1 : std::min(s[3], 1 - d[3]);
  }
  return -1;
}

double blended(const BlendTerm& term, std::size_t c, const Rgba& s, const Rgba& d) {
  const double source = s[c] * factor_of(term.source, c, s, d);
  const double destination = d[c] * factor_of(term.destination, c, s, d);
  switch (term.equation) {
    case E::add:
      return source + destination;
    case E::subtract:
      return source - destination;
    case E::reverse_subtract:
      return destination - source;
    case E::min:
      return std::min(s[c], d[c]);
    case E::max:
      return std::max(s[c], d[c]);
  }
  return -1;
}

class BlendingTest : public OperationsTest {
 protected:
  // SwiftShader lacks what would let it be a destination's factor too.
  bool saturates_destinations() const { return name() != "egl:zink-swiftshader"; }

  // Blends the source onto the destination in each of these ways, in a pixel of its own, and holds
  // all four components against the formulas, within a code.
  void expect_blended(const std::vector<Blending>& ways) {
    Scene scene = row(static_cast<int>(ways.size()), DepthFormat::none, StencilFormat::none);
    scene.target.clear = to_color(kDestination);
    for (std::size_t x = 0; x < ways.size(); ++x) {
      scene.draws.push_back(point_at(static_cast<int>(x), 0, to_color(kSource)));
      scene.draws.back().operations.blending = ways[x];
      scene.draws.back().operations.blending->constant = to_color(kConstant);
    }
    const auto rendering = drawn(scene);
    ASSERT_TRUE(rendering.has_value());
    EXPECT_EQ(rendering->hits, std::vector<std::uint32_t>(ways.size(), 1));
    for (std::size_t x = 0; x < ways.size(); ++x) {
      const auto codes = pixel(*rendering, static_cast<int>(x), 0);
      for (std::size_t c = 0; c < 4; ++c) {
        const BlendTerm& term = c < 3 ? ways[x].color : ways[x].alpha;
        const double expected = std::clamp(blended(term, c, kSource, kDestination), 0.0, 1.0);
        EXPECT_NEAR(codes[c], 255 * expected, 1.0)
            << name_of(term.equation) << ' ' << name_of(term.source) << ' '
            << name_of(term.destination) << ", component " << c;
      }
    }
  }
};

TEST_P(BlendingTest, EveryFactorIsWhatItIsNamedAfter) {
  std::vector<Blending> ways;
  for (std::size_t i = 0; i < kFactors.size(); ++i) {
    const F factor = kFactors[i];
    const F other = kFactors[(i + 4) % kFactors.size()];
    ways.push_back({{E::add, factor, F::zero}, {E::add, factor, F::one}, {}});
    if (factor == F::src_alpha_saturate && !saturates_destinations()) continue;
    ways.push_back({{E::add, F::constant_alpha, factor}, {E::add, factor, F::dst_color}, {}});
    if (other == F::src_alpha_saturate && !saturates_destinations()) continue;
    ways.push_back({{E::subtract, factor, other}, {E::reverse_subtract, other, factor}, {}});
  }
  expect_blended(ways);
}

TEST_P(BlendingTest, AFactorThatIsMissingIsNamed) {
  for (bool of_alpha : {false, true}) {
    Scene scene = row(1, DepthFormat::none, StencilFormat::none);
    scene.draws = {point_at(0, 0)};
    Blending blending;
    (of_alpha ? blending.alpha : blending.color).destination = F::src_alpha_saturate;
    scene.draws[0].operations.blending = blending;
    const std::string refusal = refusal_of(scene);
    if (name().starts_with("egl:device")) continue;
    EXPECT_EQ(refusal, saturates_destinations()
                           ? ""
                           : "src_alpha_saturate is no destination's factor on this driver: it "
                             "lacks GL_ARB_blend_func_extended");
  }
}

TEST_P(BlendingTest, EveryEquationIsWhatItIsNamedAfter) {
  std::vector<Blending> ways;
  for (E color : kEquations)
    for (E alpha : kEquations)
      ways.push_back(
          {{color, F::src_alpha, F::one_minus_constant_color}, {alpha, F::one, F::src_alpha}, {}});
  // One of the differences is clamped at 0.
  ways.push_back({{E::subtract, F::one, F::one}, {E::subtract, F::one, F::one}, {}});
  ways.push_back(
      {{E::reverse_subtract, F::one, F::one}, {E::reverse_subtract, F::one, F::one}, {}});
  expect_blended(ways);
}

TEST_P(BlendingTest, SourcesAreClampedBeforeTheyAreBlended) {
  Scene scene = row(2, DepthFormat::none, StencilFormat::none);
  scene.target.clear = {0.6f, 0.6f, 0.6f, 0.6f};
  scene.draws = {point_at(0, 0, {3, -2, 0.2f, 4}), point_at(1, 0, {3, -2, 0.2f, 4})};
  scene.draws[0].operations.blending = {{E::reverse_subtract, F::constant_alpha, F::one},
                                        {E::add, F::constant_alpha, F::zero},
                                        {0, 0, 0, 0.4f}};
  scene.draws[1].operations.blending = {{E::add, F::src_alpha, F::one_minus_src_alpha},
                                        {E::add, F::zero, F::one_minus_src_alpha},
                                        {}};
  const auto rendering = drawn(scene);
  ASSERT_TRUE(rendering.has_value());
  const std::vector<int> first = pixel(*rendering, 0, 0);
  const int expected[] = {51, 153, 133, 102};
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(first[c], expected[c], 1) << c;
  EXPECT_THAT(pixel(*rendering, 1, 0), ElementsAre(255, 0, 51, 0));
}

TEST_P(BlendingTest, LayersAddUpInDrawingOrder) {
  Scene scene = row(1, DepthFormat::none, StencilFormat::none);
  scene.target.clear = {0, 0, 0, 0};
  for (int layer = 0; layer < 5; ++layer) {
    scene.draws.push_back(point_at(0, 0, {0.2f, 0, layer == 4 ? 1.0f : 0.0f, 0.2f}));
    scene.draws.back().operations.blending = {
        {E::add, F::one, F::one}, {E::add, F::one, F::one}, {}};
  }
  const auto rendering = drawn(scene);
  ASSERT_TRUE(rendering.has_value());
  EXPECT_THAT(pixel(*rendering, 0, 0), ElementsAre(255, 0, 255, 255));
  EXPECT_THAT(rendering->hits, ElementsAre(5u));
  EXPECT_EQ(rendering->fragments.size(), 5u);
}

TEST_P(BlendingTest, MasksKeepComponents) {
  for (bool blends : {false, true}) {
    Scene scene = row(16, DepthFormat::none, StencilFormat::none);
    scene.target.clear = {0.2f, 0.4f, 0.6f, 0.8f};
    for (int x = 0; x < 16; ++x) {
      scene.draws.push_back(point_at(x, 0, {1, 0, 1, 0}));
      FragmentOperations& operations = scene.draws.back().operations;
      for (std::size_t c = 0; c < 4; ++c) operations.color_mask[c] = (x >> c & 1) == 1;
      if (blends) operations.blending = {{E::max, F::one, F::one}, {E::max, F::one, F::one}, {}};
    }
    const auto rendering = drawn(scene);
    ASSERT_TRUE(rendering.has_value());
    for (int x = 0; x < 16; ++x)
      EXPECT_THAT(pixel(*rendering, x, 0),
                  ElementsAre(x & 1 ? 255 : 51, x & 2 && !blends ? 0 : 102, x & 4 ? 255 : 153,
                              x & 8 && !blends ? 0 : 204))
          << x;
    // What masks keep is a hit like any other.
    EXPECT_EQ(rendering->hits, std::vector<std::uint32_t>(16, 1));
    EXPECT_EQ(rendering->fragments.size(), 16u);
  }
}

INSTANTIATE_TEST_SUITE_P(OpenGl, BlendingTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
