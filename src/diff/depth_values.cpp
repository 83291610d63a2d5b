// SPDX-License-Identifier: MIT
//
// The depth buffer (ruling 18): each pixel must hold the depth of the renderer's own last fragment
// there, as the format has it, or the clear value.
#include <fmt/format.h>

#include <cmath>

#include "diff/value_diff.h"
#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

constexpr const char* kRule = "framebuffer.depth";
constexpr int kRuling = 18;
constexpr double kClearDepth = 1;

// The depth before conversion: exact as far as it is known, and all that it may have been.
struct DepthTruth {
  double depth = kClearDepth;
  Interval permitted = kClearDepth;
  int primitive = -1;
};

DepthTruth truth_of(const ValueContext& context, const Fragment* last) {
  if (last == nullptr) return {};
  if (last->has_depth) return {last->depth, last->depth, last->primitive};
  const PrimitiveValues& values = context.values_of(*last);
  const Point sample = pixel_centre(last->x, last->y);
  return {middle(interpolate_exact(values.chosen.depth, sample)),
          interpolate_permitted(values.lawful.depth, sample, values.reach), last->primitive};
}

// Does the format have this value?
bool is_storable(double stored, DepthFormat format) {
  return stored == to_depth(stored, format);
}

// Distance of the stored values next to this one.
double step_at(double depth, DepthFormat format) {
  const int bits = bits_of(format);
  return bits == 0 ? float_ulp(depth) : 1 / (std::ldexp(1.0, bits) - 1);
}

void report(PixelPosition pixel, const DepthTruth& truth, double stored, DepthFormat format,
            Result& result) {
  Disagreement d = value_disagreement(pixel, -1, kRule, kRuling);
  d.exact = {to_depth(truth.depth, format)};
  d.rendered = {stored};
  d.explanation = fmt::format(
      "the depth buffer should hold {:.9g}, {}; it holds {:.9g}", d.exact[0],
      truth.primitive < 0
          ? "the clear value, since no fragment was drawn there"
          : fmt::format("the depth of primitive {}, the last drawn there", truth.primitive),
      stored);
  result.disagreements.push_back(std::move(d));
}

}  // namespace

void compare_depths(const ValueContext& context, const Rendering& rendered, Result& result) {
  const DepthFormat format = context.scene.target.depth;
  ValueAggregator aggregator("depth buffer", kRule, kRuling);
  // Fragments are sorted by row, column and primitive: walk them along with the pixels.
  auto next = rendered.fragments.begin();
  for (int y = 0; y < rendered.height; ++y) {
    for (int x = 0; x < rendered.width; ++x) {
      const Fragment* last = nullptr;
      for (; next != rendered.fragments.end() && next->x == x && next->y == y; ++next)
        last = &*next;
      aggregator.count_compared(1);
      const DepthTruth truth = truth_of(context, last);
      const double stored = rendered.depths[rendered.pixel_index(x, y)];
      if (stored == to_depth(truth.depth, format)) continue;
      if (!is_storable(stored, format) ||
          !depth_permitted(truth.permitted, format).contains(stored)) {
        report({x, y}, truth, stored, format, result);
        continue;
      }
      const ValueAggregate::Place place{x, y, truth.primitive};
      aggregator.add_error(place, {0, truth.depth, stored,
                                   std::fabs(stored - truth.depth) / step_at(stored, format), 1});
      aggregator.add_place(place);
    }
  }
  aggregator.flush(result);
}

}  // namespace edgecase
