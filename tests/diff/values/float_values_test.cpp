// SPDX-License-Identifier: MIT
//
// No false alarms: what straightforward renderers compute in float32, by one formula or another, is
// never a violation, and where all differences are one number no method is told apart.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/attributes.h"
#include "raster/rasterizer.h"
#include "rules/values/framebuffer.h"
#include "tests/diff/values/value_mutants.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

constexpr int kScenes = 200;

struct Position {
  float x = 0, y = 0;
};

// How a renderer computes its weights.
enum class Formula {
  areas,   // areas with the sample, over the whole
  planes,  // from the first vertex: a0 + b1 (a1 - a0) + b2 (a2 - a0)
};

// Everything in float32, one rounding per operation.
class FloatPrimitive {
 public:
  FloatPrimitive(const ScenePrimitive& primitive, Formula formula, bool snapped)
      : primitive_(primitive), formula_(formula) {
    for (std::size_t i = 0; i < count(); ++i) {
      Point p = nearest_point(primitive.positions[i]);
      if (snapped) p = Snap{8, Snap::Rounding::half_even}(p);
      at_[i] = {static_cast<float>(p.x.to_double()), static_cast<float>(p.y.to_double())};
    }
  }

  std::size_t count() const { return static_cast<std::size_t>(vertices_of(primitive_.kind)); }
  // A renderer that snaps draws nothing of what it has snapped to nothing.
  bool has_extent() const {
    if (count() == 1) return true;
    if (count() == 2) return at_[0].x != at_[1].x || at_[0].y != at_[1].y;
    return area(at_[0], at_[1], at_[2]) != 0;
  }

  template <class ValueOf>
  float value(float x, float y, bool perspective, ValueOf value_of) const {
    if (count() == 1) return value_of(*primitive_.vertices[0]);
    std::array<float, 3> weights = weights_at({x, y});
    if (perspective) divide_by_w(weights);
    const float first = value_of(*primitive_.vertices[0]);
    float sum = formula_ == Formula::areas ? weights[0] * first : first;
    for (std::size_t i = 1; i < count(); ++i) {
      const float value = value_of(*primitive_.vertices[i]);
      sum += weights[i] * (formula_ == Formula::areas ? value : value - first);
    }
    return sum;
  }

  float color(float x, float y, std::size_t c) const {
    const Draw& draw = *primitive_.state;
    if (draw.interpolation == Interpolation::flat)
      return primitive_.vertices[provoking_index(primitive_, ProvokingChoice::as_set)]->color[c];
    return value(x, y, draw.interpolation == Interpolation::smooth,
                 [c](const Vertex& v) { return v.color[c]; });
  }
  float depth(float x, float y) const {
    return value(x, y, false,
                 [](const Vertex& v) { return (static_cast<float>(v.z.to_double()) + 1) / 2; });
  }
  float inverse_w(float x, float y) const {
    return value(x, y, false, [](const Vertex& v) { return 1 / v.w; });
  }

 private:
  static float area(Position a, Position b, Position c) {
    return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
  }

  std::array<float, 3> weights_at(Position p) const {
    if (count() == 2) {
      const float dx = at_[1].x - at_[0].x, dy = at_[1].y - at_[0].y;
      const float t = ((p.x - at_[0].x) * dx + (p.y - at_[0].y) * dy) / (dx * dx + dy * dy);
      return {1 - t, t, 0};
    }
    const float whole = area(at_[0], at_[1], at_[2]);
    return {area(at_[1], at_[2], p) / whole, area(at_[2], at_[0], p) / whole,
            area(at_[0], at_[1], p) / whole};
  }

  void divide_by_w(std::array<float, 3>& weights) const {
    float sum = 0;
    for (std::size_t i = 0; i < count(); ++i) sum += weights[i] /= primitive_.vertices[i]->w;
    for (float& weight : weights) weight /= sum;
  }

  const ScenePrimitive& primitive_;
  Formula formula_;
  std::array<Position, 3> at_{};
};

// In which pixels a renderer takes a difference.
using Differences = std::array<std::array<double, 4>, kDerivatives>;

Differences differences_at(const FloatPrimitive& primitive, int x, int y) {
  Differences result;
  const int left = x - x % 2, bottom = y - y % 2;
  const auto centre = [](int i) { return static_cast<float>(i) + 0.5f; };
  for (std::size_t c = 0; c < 4; ++c) {
    const auto along_x = [&](int row) {
      return static_cast<double>(primitive.color(centre(left + 1), centre(row), c) -
                                 primitive.color(centre(left), centre(row), c));
    };
    const auto along_y = [&](int column) {
      return static_cast<double>(primitive.color(centre(column), centre(bottom + 1), c) -
                                 primitive.color(centre(column), centre(bottom), c));
    };
    result[0][c] = result[2][c] = along_x(y);
    result[1][c] = result[3][c] = along_y(x);
    result[4][c] = along_x(bottom);
    result[5][c] = along_y(left);
  }
  return result;
}

// Exact's fragments with float32 values; none of primitives that snapping has left nothing of.
Rendering float_rendering(const Scene& scene, Rendering rendering, Formula formula, bool snapped) {
  const std::vector<ScenePrimitive> primitives = primitives_of(scene);
  for (Fragment& f : rendering.fragments) {
    const FloatPrimitive primitive(primitives[static_cast<std::size_t>(f.primitive)], formula,
                                   snapped);
    if (!primitive.has_extent()) continue;
    const float x = static_cast<float>(f.x) + 0.5f, y = static_cast<float>(f.y) + 0.5f;
    for (std::size_t c = 0; c < 4; ++c) f.color[c] = static_cast<double>(primitive.color(x, y, c));
    f.depth = static_cast<double>(primitive.depth(x, y));
    FragmentDetail& detail = rendering.details[static_cast<std::size_t>(f.detail)];
    detail.coordinates = {f.x + .5, f.y + .5, f.depth,
                          static_cast<double>(primitive.inverse_w(x, y))};
    const Differences differences = differences_at(primitive, f.x, f.y);
    for (std::size_t i = 0; i < kDerivatives; ++i) detail.derivatives[i] = differences[i];
  }
  return stored(scene, std::move(rendering));
}

// Random primitives, interpolations, colours and w.
class RandomValues {
 public:
  explicit RandomValues(std::uint64_t seed) : scenes_(seed) {}

  Scene next(bool perspective) {
    Scene scene = scenes_.next({10, 512, 3, false});
    scene.details = {true, true};
    constexpr DepthFormat kFormats[] = {DepthFormat::none, DepthFormat::depth16,
                                        DepthFormat::depth24, DepthFormat::depth32f};
    scene.target.depth = kFormats[scenes_.below(4)];
    for (Draw& draw : scene.draws) {
      constexpr Interpolation kWays[] = {Interpolation::flat, Interpolation::smooth,
                                         Interpolation::smooth, Interpolation::noperspective};
      draw.interpolation = kWays[scenes_.below(4)];
      // With one component instead of four, two methods come near each other more easily.
      const bool grey = scenes_.below(2) == 0;
      for (Vertex& vertex : draw.vertices) {
        if (perspective) vertex.w = std::ldexp(1.0f, scenes_.below(7) - 2);
        for (float& c : vertex.color) c = static_cast<float>(scenes_.below(4096) - 1024) / 1024;
        if (grey) vertex.color.fill(vertex.color[0]);
      }
    }
    return scene;
  }

 private:
  RandomScenes scenes_;
};

std::string first_of(const Result& result) {
  if (result.disagreements.empty()) return "no disagreement";
  const Disagreement& d = result.disagreements[0];
  return std::string(name_of(d.rule)) + " '" + text_of(d.cause) + "': " + d.explanation;
}

void expect_no_violation(Formula formula, bool perspective, bool snapped) {
  RandomValues random(formula == Formula::areas ? 5 : 6);
  std::size_t fragments = 0;
  int differing = 0;
  for (int i = 0; i < kScenes; ++i) {
    const Scene scene = random.next(perspective);
    const Rendering exact = rasterize(scene, {});
    const Result result = judged(scene, float_rendering(scene, exact, formula, snapped));
    EXPECT_NE(result.verdict, Verdict::violation) << "scene " << i << ": " << first_of(result);
    fragments += exact.fragments.size();
    differing += result.verdict != Verdict::agree;
  }
  // The scenes show something, and float32 is not exact.
  EXPECT_GT(fragments, 3000u);
  EXPECT_GT(differing, kScenes / 3);
}

TEST(FloatValues, AreasAreNeverAViolation) {
  expect_no_violation(Formula::areas, false, false);
  expect_no_violation(Formula::areas, true, false);
}

TEST(FloatValues, PlanesAreNeverAViolation) {
  expect_no_violation(Formula::planes, false, false);
  expect_no_violation(Formula::planes, true, false);
}

TEST(FloatValues, SnappedVerticesAreNeverAViolation) {
  expect_no_violation(Formula::areas, false, true);
  expect_no_violation(Formula::areas, true, true);
  expect_no_violation(Formula::planes, true, true);
}

// Where attributes run linearly in the window, all differences are one number.
TEST(FloatValues, LinearScenesHaveNoDisagreementByAnyMethod) {
  RandomValues random(7);
  for (int i = 0; i < 40; ++i) {
    const Scene scene = random.next(false);
    const Rendering exact = rasterize(scene, {});
    for (const DerivativeMethod method : values_of<DerivativeMethod>()) {
      RuleChoices choices;
      choices.values.derivatives = {method, method, method};
      const Result result = judged(scene, shaded_under(scene, exact, choices));
      EXPECT_TRUE(result.disagreements.empty()) << name_of(method) << " " << first_of(result);
    }
  }
}

}  // namespace
}  // namespace edgecase
