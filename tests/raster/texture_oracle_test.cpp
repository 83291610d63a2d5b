// SPDX-License-Identifier: MIT
//
// The texture stage against the specification's formulas in fractions: random fragments, among them
// many that lie on borders of texels and of levels. What the stage answers are intervals, and the
// fraction must lie in them.
#include <gtest/gtest.h>

#include "exact/rational.h"
#include "raster/texture_stage.h"
#include "tests/oracles/area_ratios.h"
#include "tests/oracles/texture_lookup.h"
#include "tests/raster/random_textured_scenes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using oracle::Fraction;

// s and t over a primitive, by the formulas of 14.5.1 and 14.6.1.
class FractionPrimitive {
 public:
  explicit FractionPrimitive(const ScenePrimitive& primitive) : primitive_(primitive) {
    const Draw& draw = *primitive.state;
    for (std::size_t v = 0; v < static_cast<std::size_t>(vertices_of(primitive.kind)); ++v) {
      const Vertex& vertex = *primitive.vertices[v];
      x_[v] = Fraction(vertex.position.x.raw(), Fixed::kOne);
      y_[v] = Fraction(vertex.position.y.raw(), Fixed::kOne);
      w_[v] = draw.interpolation == Interpolation::smooth ? Fraction(vertex.w) : Fraction(1);
    }
  }

  bool has_extent() const {
    if (primitive_.kind == PrimitiveKind::point) return true;
    if (primitive_.kind == PrimitiveKind::line) return x_[0] != x_[1] || y_[0] != y_[1];
    return doubled_area(x_[0], y_[0], x_[1], y_[1], x_[2], y_[2]) != 0;
  }

  // s, t; none where 1/w is not positive.
  std::optional<std::array<Fraction, 2>> at(int column, int row) const {
    const std::array<Fraction, 3> weights =
        weights_at(column + Fraction(1, 2), row + Fraction(1, 2));
    Fraction inverse_w = 0;
    std::array<Fraction, 2> sum{};
    for (std::size_t v = 0; v < static_cast<std::size_t>(vertices_of(primitive_.kind)); ++v) {
      inverse_w += weights[v] / w_[v];
      for (std::size_t c = 0; c < 2; ++c) sum[c] += weights[v] / w_[v] * coordinate(v, c);
    }
    if (inverse_w <= 0) return std::nullopt;
    return std::array<Fraction, 2>{sum[0] / inverse_w, sum[1] / inverse_w};
  }

 private:
  Fraction coordinate(std::size_t v, std::size_t c) const {
    const bool flat = primitive_.state->interpolation == Interpolation::flat;
    const auto provoking = static_cast<std::size_t>(primitive_.provoking_last);
    return Fraction(primitive_.vertices[flat ? provoking : v]->texture_coordinates[c]);
  }

  std::array<Fraction, 3> weights_at(const Fraction& x, const Fraction& y) const {
    if (primitive_.kind == PrimitiveKind::point) return {1, 0, 0};
    if (primitive_.kind == PrimitiveKind::line) {
      const Fraction run_x = x_[1] - x_[0], run_y = y_[1] - y_[0];
      const Fraction t =
          ((x - x_[0]) * run_x + (y - y_[0]) * run_y) / (run_x * run_x + run_y * run_y);
      return {1 - t, t, 0};
    }
    const Fraction area = doubled_area(x_[0], y_[0], x_[1], y_[1], x_[2], y_[2]);
    return {doubled_area(x_[1], y_[1], x_[2], y_[2], x, y) / area,
            doubled_area(x_[2], y_[2], x_[0], y_[0], x, y) / area,
            doubled_area(x_[0], y_[0], x_[1], y_[1], x, y) / area};
  }

  const ScenePrimitive& primitive_;
  std::array<Fraction, 3> x_{}, y_{}, w_{};
};

struct Expected {
  std::array<Fraction, 2> coordinates;
  oracle::LevelOfDetail lambda_prime;
  Fraction lambda;
  Fraction accessed;
  oracle::FractionColor color;
};

// Of quads that begin at even columns and rows: dFdxFine and dFdyFine.
std::optional<oracle::Gradients> gradients_at(const FractionPrimitive& primitive, int x, int y) {
  const int left = x - x % 2, bottom = y - y % 2;
  const auto a = primitive.at(left, y), b = primitive.at(left + 1, y);
  const auto c = primitive.at(x, bottom), d = primitive.at(x, bottom + 1);
  if (!a || !b || !c || !d) return std::nullopt;
  return oracle::Gradients{{(*b)[0] - (*a)[0], (*b)[1] - (*a)[1]},
                           {(*d)[0] - (*c)[0], (*d)[1] - (*c)[1]}};
}

std::optional<oracle::LevelOfDetail> base_at(const oracle::TextureQuery& query,
                                             const Lookup& lookup,
                                             const FractionPrimitive& primitive, int x, int y) {
  if (lookup.kind == LookupKind::lod) return oracle::LevelOfDetail{false, Fraction(lookup.value)};
  if (lookup.kind == LookupKind::gradients)
    return log2_of_scale(query, {{Fraction(lookup.dx[0]), Fraction(lookup.dx[1])},
                                 {Fraction(lookup.dy[0]), Fraction(lookup.dy[1])}});
  const auto gradients = gradients_at(primitive, x, y);
  if (!gradients) return std::nullopt;
  return log2_of_scale(query, *gradients);
}

std::optional<Expected> expected_at(const oracle::TextureQuery& query, const Lookup& lookup,
                                    const FractionPrimitive& primitive, int x, int y) {
  const auto coordinates = primitive.at(x, y);
  const auto base = base_at(query, lookup, primitive, x, y);
  if (!coordinates || !base) return std::nullopt;
  Expected result;
  result.coordinates = *coordinates;
  result.lambda_prime = oracle::with_bias(*base, query.sampler,
                                          lookup.kind == LookupKind::bias ? lookup.value : 0.0F);
  result.lambda = oracle::clamped(result.lambda_prime, query.sampler);
  result.accessed = oracle::accessed(query, result.lambda);
  result.color = oracle::look_up(query, *coordinates, result.lambda);
  return result;
}

bool holds(Interval interval, const Fraction& value) {
  return rational_of(interval.low) <= value && value <= rational_of(interval.high);
}

struct Tally {
  int fragments = 0;
  int on_borders = 0;  // of a level or a texel of the base level
  int magnified = 0;
  int between = 0;    // mixed of two levels
  double widest = 0;  // colour, relative to the largest texel of a hundred
};

void compare(const ExactLookup& found, const Expected& expected, const Texture& texture,
             Tally& tally) {
  for (std::size_t c = 0; c < 2; ++c)
    ASSERT_TRUE(holds(found.coordinates[c], expected.coordinates[c]));
  if (expected.lambda_prime.is_infinite)
    ASSERT_TRUE(std::isinf(found.lambda_prime.low));
  else
    ASSERT_TRUE(holds(found.lambda_prime, expected.lambda_prime.value));
  ASSERT_TRUE(holds(found.lambda, expected.lambda));
  ASSERT_TRUE(holds(found.accessed, expected.accessed));
  const double scale = texture.format == TextureFormat::rgba32f ? 100 : 1;
  for (std::size_t c = 0; c < 4; ++c) {
    ASSERT_TRUE(holds(found.color[c], expected.color[c])) << c;
    tally.widest = std::max(tally.widest, width_of(found.color[c]) / scale);
  }
  ++tally.fragments;
  const Fraction doubled = expected.lambda * 2;
  const auto on_border = [&](std::size_t c, int size) {
    return is_whole(expected.coordinates[c] * 2 * size);
  };
  if (is_whole(doubled) || on_border(0, texture.levels[0].width) ||
      on_border(1, texture.levels[0].height))
    ++tally.on_borders;
  if (expected.lambda <= 0) ++tally.magnified;
  if (!is_whole(expected.accessed)) ++tally.between;
}

void compare_scene(const Scene& scene, const RuleChoices& choices, Tally& tally) {
  const ScenePrimitive primitive = primitives_of(scene).at(0);
  const FractionPrimitive fractions(primitive);
  if (!fractions.has_extent()) return;
  const TextureUse& use = *primitive.state->texture;
  const Texture& texture = *scene.textures[0];
  const oracle::TextureQuery query{texture,
                                   texture.levels,
                                   use.sampler,
                                   {choices.textures.crossover == Crossover::by_filters,
                                    choices.textures.nearest_level == NearestLevel::up_at_ties}};
  const TextureStage stage(scene, choices);
  const auto attributes = attributes_of(primitive, choices, scene.target);
  TexturedPrimitive textured(stage, primitive, attributes);
  for (int y = 0; y < 8; y += 3)
    for (int x = 0; x < 8; x += 2) {
      const auto expected = expected_at(query, use.lookup, fractions, x, y);
      if (!expected) continue;
      const ExactLookup found = textured.look_up({x, y});
      ASSERT_NO_FATAL_FAILURE(compare(found, *expected, texture, tally)) << x << ", " << y;
    }
}

TEST(TextureOracle, RandomFragmentsAgree) {
  TexturedScenes scenes(share_seed(6));
  Tally tally;
  for (int i = 0; tally.fragments < share_of(25'000, 2'500); ++i) {
    RuleChoices choices;
    choices.textures.crossover = i % 2 == 0 ? Crossover::zero : Crossover::by_filters;
    choices.textures.nearest_level =
        i % 3 == 0 ? NearestLevel::up_at_ties : NearestLevel::down_at_ties;
    const Scene scene = scenes.next();
    ASSERT_NO_FATAL_FAILURE(compare_scene(scene, choices, tally)) << "scene " << i;
  }
  EXPECT_GT(tally.on_borders, tally.fragments / 4);
  EXPECT_LT(tally.on_borders, tally.fragments * 3 / 4);
  EXPECT_GT(tally.magnified, tally.fragments / 10);
  EXPECT_GT(tally.between, least_of(25'000 / 20));
  EXPECT_LT(tally.widest, 1e-11);
}

}  // namespace
}  // namespace edgecase
