// SPDX-License-Identifier: MIT
#include "diff/differing_planes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "diff/values/value_diff.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

// One plane of both renderings.
struct Plane {
  const char* attribute;
  RuleId rule;
  std::size_t components;  // of a pixel
};

constexpr Plane kPixels{"pixel", RuleId::framebuffer_unorm8, 4};
constexpr Plane kSamples{"sample", RuleId::framebuffer_unorm8, 4};
constexpr Plane kDepths{"depth buffer", RuleId::framebuffer_depth, 1};
constexpr Plane kStencils{"stencil buffer", RuleId::stencil_test, 1};
constexpr Plane kHits{"written samples", RuleId::fragment_once, 1};
constexpr Plane kAccumulated{"accumulated color", RuleId::supersample_accumulation, 4};

// Renderers answer in float32.
bool is_same(double a, double b) {
  return to_float(a) == to_float(b) || (std::isnan(a) && std::isnan(b));
}

// Appends the aggregate of a plane, where both have it and it differs. The planes of samples follow
// each other.
template <class Number>
void compare(const Plane& plane, const std::vector<Number>& exact,
             const std::vector<Number>& stored, const Rendering& size, Result& result) {
  if (exact.size() != stored.size() || exact == stored ||
      std::ranges::equal(exact, stored, is_same))
    return;
  ValueAggregator aggregator(plane.attribute, plane.rule);
  const std::size_t area = size.pixel_index(0, size.height);
  const auto width = static_cast<std::size_t>(size.width);
  aggregator.count_compared(plane.components, exact.size() / plane.components);
  for (std::size_t i = 0; i < exact.size(); i += plane.components) {
    const std::size_t pixel = i / plane.components % area;
    const ValueAggregate::Place place{static_cast<int>(pixel % width),
                                      static_cast<int>(pixel / width), -1};
    bool differs = false;
    for (std::size_t c = 0; c < plane.components; ++c) {
      const auto should = static_cast<double>(exact[i + c]);
      const auto is = static_cast<double>(stored[i + c]);
      if (is_same(should, is)) continue;
      differs = true;
      aggregator.add_error(place, {static_cast<int>(c), should, is, error_in_ulp(should, is), 0});
    }
    if (differs) aggregator.add_place(place);
  }
  aggregator.flush(result);
}

}  // namespace

bool has_differences(const Result& result) {
  return !result.disagreements.empty() ||
         std::ranges::any_of(result.values,
                             [](const ValueAggregate& v) { return !v.differing.empty(); });
}

void find_differing_planes(const Rendering& exact, const Rendering& rendered, Result& result) {
  compare(kPixels, exact.pixels, rendered.pixels, exact, result);
  compare(kSamples, exact.sample_pixels, rendered.sample_pixels, exact, result);
  compare(kDepths, exact.depths, rendered.depths, exact, result);
  compare(kStencils, exact.stencils, rendered.stencils, exact, result);
  compare(kHits, exact.hits, rendered.hits, exact, result);
  compare(kAccumulated, exact.accumulated, rendered.accumulated, exact, result);
  for (std::size_t k = 0; k < exact.passes.size() && k < rendered.passes.size(); ++k)
    find_differing_planes(exact.passes[k], rendered.passes[k], result);
}

}  // namespace edgecase
