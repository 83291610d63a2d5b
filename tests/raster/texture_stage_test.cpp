// SPDX-License-Identifier: MIT
//
// What the texture stage answers, number by number, against literal arithmetic in fractions:
// coordinates, footprints, levels of detail, and what a query tells, with perspective and without,
// in one dimension and in two.
#include "raster/texture_stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "exact/rational.h"
#include "tests/raster/random_scenes.h"
#include "tests/raster/texture_scenes.h"

namespace edgecase {
namespace {

using RationalPair = std::array<Rational, 2>;

// A triangle's corner: where it is, pixels, and what it carries.
struct Corner {
  Rational x;
  Rational y;
  float w = 1;
  std::array<float, 2> st{};
};
using Corners = std::array<Corner, 3>;

Rational doubled_area(const Corner& a, const Corner& b, const Rational& x, const Rational& y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

// s and t at a pixel's centre (14.6.1): none on the horizon.
std::optional<RationalPair> coordinates_at(const Corners& corners, int column, int row) {
  const Rational x = column + Rational(1, 2), y = row + Rational(1, 2);
  RationalPair above{};
  Rational below = 0;
  for (std::size_t v = 0; v < 3; ++v) {
    const Rational weight =
        doubled_area(corners[(v + 1) % 3], corners[(v + 2) % 3], x, y) / rational_of(corners[v].w);
    below += weight;
    for (std::size_t c = 0; c < 2; ++c) above[c] += weight * rational_of(corners[v].st[c]);
  }
  if (below == 0) return std::nullopt;
  return RationalPair{above[0] / below, above[1] / below};
}

// How far s and t move along x or y in the pixel's own quad.
RationalPair step_of(const Corners& corners, int x, int y, bool along_x) {
  const int left = x - x % 2, bottom = y - y % 2;
  const auto first =
      along_x ? coordinates_at(corners, left, y) : coordinates_at(corners, x, bottom);
  const auto second =
      along_x ? coordinates_at(corners, left + 1, y) : coordinates_at(corners, x, bottom + 1);
  return {(*second)[0] - (*first)[0], (*second)[1] - (*first)[1]};
}

double as_double(const Rational& value) {
  return middle(interval_of(value));
}

bool holds(Interval interval, const Rational& value) {
  return rational_of(interval.low) <= value && value <= rational_of(interval.high);
}

bool same(Interval a, Interval b) {
  return a.low == b.low && a.high == b.high;
}

// A scene of one triangle, its stage, and the lookups of the triangle's pixels.
class OneTriangle {
 public:
  OneTriangle(const Corners& corners, const Texture& texture, const TextureUse& use,
              const TextureChoice& choice = {})
      : scene_(scene_of(corners, texture, use)), stage_(scene_, choices_) {
    choices_.textures = choice;
    primitive_.emplace(primitives_of(scene_).at(0));
    attributes_ = attributes_of(*primitive_, choices_, scene_.target);
    textured_.emplace(stage_, *primitive_, attributes_);
  }
  OneTriangle(const OneTriangle&) = delete;
  OneTriangle& operator=(const OneTriangle&) = delete;

  ExactLookup look_up(int x, int y) { return textured_->look_up({x, y}); }
  const PrimitiveAttributes& attributes() const { return attributes_; }

 private:
  static Scene scene_of(const Corners& corners, const Texture& texture, const TextureUse& use) {
    Scene scene = blank_scene(16, 16);
    scene.textures = {std::make_shared<const Texture>(texture)};
    Draw draw;
    draw.primitive = Primitive::triangles;
    draw.interpolation = Interpolation::smooth;
    for (const Corner& corner : corners) {
      Vertex vertex;
      vertex.position = at(as_double(corner.x), as_double(corner.y));
      vertex.w = corner.w;
      vertex.texture_coordinates = corner.st;
      draw.vertices.push_back(vertex);
    }
    draw.texture = use;
    scene.draws = {draw};
    return scene;
  }

  RuleChoices choices_;
  Scene scene_;
  TextureStage stage_;
  std::optional<ScenePrimitive> primitive_;
  PrimitiveAttributes attributes_;
  std::optional<TexturedPrimitive> textured_;
};

Texture flat_texture(int width, int dimensions) {
  Texture texture = chain_of(width, dimensions == 1 ? 1 : width / 2, TextureFormat::rgba32f,
                             [](int, int, int level) {
                               return std::array<float, 4>{static_cast<float>(level), 1, 2, 3};
                             });
  texture.dimensions = dimensions;
  return texture;
}

// s and t run unlike in x and y.
Corners corners_of(bool perspective) {
  Corners corners{{{0, 0, 1, {0.125F, 0.5F}}, {16, 0, 1, {1.75F, 0.75F}}, {0, 16, 1, {-0.5F, 2}}}};
  if (perspective) {
    corners[1].w = 3;
    corners[2].w = 1.75F;
  }
  return corners;
}

struct Expected {
  std::array<RationalPair, 2> footprint;  // along x, along y; texels of the base level
  double base = 0;                        // log2 of the longer vector
};

Expected expected_of(const std::array<RationalPair, 2>& steps, const Texture& texture) {
  Expected result;
  Rational longest = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    result.footprint[i] = {steps[i][0] * texture.levels[0].width,
                           steps[i][1] * texture.levels[0].height};
    const RationalPair& v = result.footprint[i];
    const Rational squared = v[0] * v[0] + (texture.dimensions == 2 ? Rational(v[1] * v[1]) : 0);
    longest = std::max(longest, squared);
  }
  result.base = std::log2(as_double(longest)) / 2;
  return result;
}

constexpr LookupKind kKinds[] = {LookupKind::implicit, LookupKind::bias, LookupKind::lod,
                                 LookupKind::gradients};
constexpr float kSamplerBias = 0.3F;

TextureUse use_of(LookupKind kind) {
  TextureUse use;
  use.sampler = sampler_of(Filter::linear, MipFilter::linear);
  use.sampler.lod_bias = kSamplerBias;
  use.lookup.kind = kind;
  use.lookup.value = 0.45F;
  use.lookup.dx = {0.1F, 0.7F};
  use.lookup.dy = {-0.2F, 0.05F};
  return use;
}

void compare(const ExactLookup& found, const Expected& own, const Expected& queried,
             const TextureUse& use, const Texture& texture) {
  const LookupKind kind = use.lookup.kind;
  EXPECT_EQ(found.footprint.dimensions, texture.dimensions);
  for (std::size_t c = 0; c < static_cast<std::size_t>(texture.dimensions); ++c) {
    const bool none = kind == LookupKind::lod;
    EXPECT_TRUE(holds(found.footprint.dx[c], none ? 0 : own.footprint[0][c]));
    EXPECT_TRUE(holds(found.footprint.dy[c], none ? 0 : own.footprint[1][c]));
    EXPECT_LT(width_of(found.footprint.dx[c]), 1e-12);
    EXPECT_LT(width_of(found.footprint.dy[c]), 1e-12);
  }
  const double sampler_bias = static_cast<double>(kSamplerBias);
  const double given = static_cast<double>(use.lookup.value);
  const double prime = (kind == LookupKind::lod    ? given
                        : kind == LookupKind::bias ? own.base + given
                                                   : own.base) +
                       sampler_bias;
  const auto last = static_cast<double>(texture.levels.size() - 1);
  EXPECT_NEAR(found.lambda_prime.low, prime, 1e-13);
  EXPECT_NEAR(found.lambda_prime.high, prime, 1e-13);
  EXPECT_NEAR(found.accessed.low, std::clamp(prime, 0.0, last), 1e-13);
  EXPECT_NEAR(found.queried[1].low, queried.base + sampler_bias, 1e-13);
  EXPECT_NEAR(found.queried[1].high, queried.base + sampler_bias, 1e-13);
  EXPECT_NEAR(found.queried[0].low, std::clamp(queried.base + sampler_bias, 0.0, last), 1e-13);
  EXPECT_NEAR(found.color[0].low, std::clamp(prime, 0.0, last), 1e-13);
  for (std::size_t c = 1; c < 4; ++c) EXPECT_TRUE(same(found.color[c], static_cast<double>(c)));
}

// Pixel by pixel, one after another of one primitive.
TEST(TextureStage, LevelsOfEveryKindOfLookup) {
  for (const bool perspective : {false, true})
    for (const int dimensions : {1, 2})
      for (const LookupKind kind : kKinds) {
        const Texture texture = flat_texture(22, dimensions);
        const TextureUse use = use_of(kind);
        const Corners corners = corners_of(perspective);
        OneTriangle triangle(corners, texture, use);
        for (const PixelPosition p : {PixelPosition{1, 2}, {6, 3}, {2, 9}, {11, 0}}) {
          const Expected queried = expected_of(
              {step_of(corners, p.x, p.y, true), step_of(corners, p.x, p.y, false)}, texture);
          const auto pair = [](const std::array<float, 2>& v) {
            return RationalPair{rational_of(v[0]), rational_of(v[1])};
          };
          const Expected own =
              kind == LookupKind::gradients
                  ? expected_of({pair(use.lookup.dx), pair(use.lookup.dy)}, texture)
                  : queried;
          SCOPED_TRACE(testing::Message() << name_of(kind) << dimensions << perspective << p.x);
          const ExactLookup found = triangle.look_up(p.x, p.y);
          compare(found, own, queried, use, texture);
          const RationalPair st = *coordinates_at(corners, p.x, p.y);
          for (std::size_t c = 0; c < 2; ++c) EXPECT_TRUE(holds(found.coordinates[c], st[c]));
          EXPECT_TRUE(holds(found.point.s, st[0]));
          EXPECT_TRUE(holds(found.point.t, st[1]));
        }
      }
}

// In one dimension what the gradients say of t is nothing, and t is told as it is interpolated.
TEST(TextureStage, OneDimensionIgnoresT) {
  TextureUse use = use_of(LookupKind::gradients);
  const Texture texture = flat_texture(22, 1);
  use.lookup.dx = {0.0625F, 4};
  use.lookup.dy = {0.03125F, -8};
  OneTriangle triangle(corners_of(true), texture, use);
  const ExactLookup found = triangle.look_up(3, 2);
  EXPECT_NEAR(found.lambda_prime.low, std::log2(22 / 16.0) + 0.3, 1e-7);
  for (const IntervalPair& vector : {found.footprint.dx, found.footprint.dy})
    EXPECT_TRUE(same(vector[1], 0));
  EXPECT_TRUE(same(found.point.t, found.coordinates[1]));
}

// Where nothing is open, the footprint is that of the intervals; without perspective that of the
// first pixel for all.
TEST(TextureStage, QuotientsAreForOpenQuestions) {
  const Texture texture = flat_texture(22, 2);
  for (const bool perspective : {false, true}) {
    OneTriangle triangle(corners_of(perspective), texture, use_of(LookupKind::implicit));
    const QuadPixel at = perspective ? QuadPixel{{7, 4}, {6, 4}} : QuadPixel{{0, 0}, {0, 0}};
    const auto along = [&](Axis axis) {
      const auto& color = triangle.attributes().color;
      return IntervalPair{derivative_exact(color[0], at, axis, DerivativeMethod::fine),
                          derivative_exact(color[1], at, axis, DerivativeMethod::fine)};
    };
    const Footprint narrow = footprint(along(Axis::x), along(Axis::y), 22, 11, 2);
    const ExactLookup found = triangle.look_up(7, 4);
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_TRUE(same(found.footprint.dx[c], narrow.dx[c]));
      EXPECT_TRUE(same(found.footprint.dy[c], narrow.dy[c]));
    }
  }
}

// rho is the root of 2 exactly, or 2, and the bias is no multiple of any border's distance: lambda'
// is 1/2 or 1 and the bias, to the last digit.
TEST(TextureStage, ABiasIsAddedToTheExactLogarithm) {
  for (const int dimensions : {1, 2})
    for (const float bias : {0.3F, -0.7F, 0.3F * 0x1p-20F}) {
      TextureUse use = use_of(LookupKind::implicit);
      use.sampler.lod_bias = bias;
      const Texture texture = flat_texture(48, dimensions);  // 48 by 24
      // By (1, 1) texels along x and by (-1, 1) along y; by 2 and by 0.
      const Corners diagonal{{{0, 0, 1, {0, 0}}, {48, 0, 1, {1, 2}}, {0, 48, 1, {-1, 2}}}};
      const Corners straight{{{0, 0, 1, {0, 0}}, {24, 0, 1, {1, 1}}, {0, 24, 1, {0, 1}}}};
      OneTriangle triangle(dimensions == 2 ? diagonal : straight, texture, use);
      const ExactLookup found = triangle.look_up(4, 5);
      const Rational base = dimensions == 2 ? Rational(1, 2) : Rational(1);
      EXPECT_TRUE(holds(found.lambda_prime, base + rational_of(bias))) << bias;
      EXPECT_LT(width_of(found.lambda_prime), 1e-15);
      EXPECT_EQ(found.footprint.dimensions, dimensions);
      EXPECT_TRUE(same(found.footprint.dx[0], dimensions == 2 ? 1 : 2));
      EXPECT_TRUE(same(found.footprint.dy[0], dimensions == 2 ? -1 : 0));
    }
}

// Off 1 texel by less than doubles know, and 3 levels up: on its side of the level still.
TEST(TextureStage, ABiasMovesNothingOntoABorder) {
  TextureChoice choice;
  choice.scale_factor = ScaleFactor::length_of_sum;
  for (const int sign : {-1, 1}) {
    TextureUse use = use_of(LookupKind::gradients);
    use.sampler.lod_bias = 3;
    use.lookup.dx = {1.0F / 16, 0};
    use.lookup.dy = {static_cast<float>(sign) * 0x1p-64F, 0};
    OneTriangle triangle(corners_of(false), flat_texture(16, 2), use, choice);
    const Interval found = triangle.look_up(2, 2).lambda_prime;
    EXPECT_EQ(found.high < 3, sign < 0);
    EXPECT_EQ(found.low > 3, sign > 0);
    EXPECT_NEAR(found.low, 3, 1e-14);
    EXPECT_NEAR(found.high, 3, 1e-14);
  }
}

// The neighbour along x lies on the horizon, those along y do not: nothing is known of x alone.
TEST(TextureStage, AHorizonBesideThePixel) {
  const Texture texture = flat_texture(22, 2);
  Corners corners{{{0, 0, 1, {0, 0}}, {8, 0, 17, {1, 0.5F}}, {0, 8, 1, {0.25F, 1}}}};
  ASSERT_FALSE(coordinates_at(corners, 8, 1));
  OneTriangle triangle(corners, texture, use_of(LookupKind::implicit));
  const ExactLookup found = triangle.look_up(9, 1);
  const Expected along_y = expected_of({RationalPair{}, step_of(corners, 9, 1, false)}, texture);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_TRUE(is_everything(found.footprint.dx[c]));
    EXPECT_TRUE(holds(found.footprint.dy[c], along_y.footprint[1][c]));
  }
  EXPECT_NEAR(found.lambda_prime.low, along_y.base + 0.3, 1e-7);
  EXPECT_TRUE(std::isinf(found.lambda_prime.high));
  EXPECT_EQ(found.accessed.high, static_cast<double>(texture.levels.size() - 1));
}

// 1/w at pixel (5, 3) is so near 0 that no sum of intervals tells it from 0, and it is not: it is
// asked as a quotient.
TEST(TextureStage, AlmostAHorizon) {
  const Texture texture = flat_texture(22, 2);
  const auto raw = [](int value) { return Rational(value, 1 << 16); };
  const Corners corners{{{raw(425984), raw(229376), 88261, {0, 0}},
                         {raw(362128), raw(225145), 117155, {1, 0.5F}},
                         {raw(358395), raw(225107), 125559, {0.25F, 1}}}};
  TextureUse use = use_of(LookupKind::implicit);
  use.sampler.magnify = use.sampler.minify = Filter::nearest;
  OneTriangle triangle(corners, texture, use);
  const ExactLookup found = triangle.look_up(5, 3);
  EXPECT_GT(found.coordinates[0].magnitude(), 0x1p20);
  EXPECT_LT(width_of(found.coordinates[0]), found.coordinates[0].magnitude() * 0x1p-50);
  const Expected expected =
      expected_of({step_of(corners, 5, 3, true), step_of(corners, 5, 3, false)}, texture);
  ASSERT_GT(expected.base, 40);
  EXPECT_NEAR(found.lambda_prime.low, expected.base + 0.3, 1e-6);
  EXPECT_NEAR(found.lambda_prime.high, expected.base + 0.3, 1e-6);
  EXPECT_LT(width_of(found.lambda_prime), 1e-12);
  EXPECT_LT(width_of(found.point.s), 1e-15);
  EXPECT_LT(width_of(found.footprint.dx[0]), std::exp2(expected.base - 50));
}

}  // namespace
}  // namespace edgecase
