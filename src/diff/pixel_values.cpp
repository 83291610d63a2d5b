// SPDX-License-Identifier: MIT
//
// Pixels (rulings 10 and 11): each must hold what the renderer's own last fragment there puts into
// it, or the clear colour. A renderer that tells right fragments and shows a wrong picture is
// caught here.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "diff/value_diff.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

// What a pixel should hold, component by component, before conversion to 8 bits.
struct PixelTruth {
  std::array<double, 4> exact{};
  std::array<Interval, 4> permitted{};
};

PixelTruth truth_of_clear(const Scene& scene) {
  PixelTruth truth;
  for (std::size_t c = 0; c < 4; ++c) {
    truth.exact[c] = static_cast<double>(scene.target.clear[c]);
    truth.permitted[c] = truth.exact[c];
  }
  return truth;
}

// The colour that the renderer told, or where it told none, all that it may have had.
PixelTruth truth_of_fragment(const ValueContext& context, const Fragment& fragment) {
  const Point sample = pixel_centre(fragment.x, fragment.y);
  PixelTruth truth;
  if (fragment.has_color) {
    truth.exact = fragment.color;
    for (std::size_t c = 0; c < 4; ++c)
      truth.permitted[c] = std::isnan(truth.exact[c]) ? Interval::everything() : truth.exact[c];
    return truth;
  }
  // What a texture would have shown is judged where it is told.
  if (context.primitive_of(fragment).state->texture) {
    truth.permitted.fill(Interval::everything());
    return truth;
  }
  const PrimitiveValues& values = context.values_of(fragment);
  for (std::size_t c = 0; c < 4; ++c) {
    truth.exact[c] = middle(interpolate_exact(values.chosen.color[c], sample));
    truth.permitted[c] =
        hull(interpolate_permitted(values.lawful.color[c], sample, values.reach), truth.exact[c]);
  }
  return truth;
}

bool holds(const std::uint8_t* pixel, const PixelTruth& truth) {
  for (std::size_t c = 0; c < 4; ++c) {
    const Unorm8Range range = unorm8_permitted(truth.permitted[c]);
    if (pixel[c] < range.low || pixel[c] > range.high) return false;
  }
  return true;
}

class PixelComparison {
 public:
  PixelComparison(const ValueContext& context, const Rendering& rendered)
      : context_(context), rendered_(rendered), clear_(truth_of_clear(context.scene)) {}

  void run(Result& result) {
    // Fragments are sorted by row, column and primitive: walk them along with the pixels.
    auto next = rendered_.fragments.begin();
    for (int y = 0; y < rendered_.height; ++y) {
      for (int x = 0; x < rendered_.width; ++x) {
        const auto first = next;
        while (next != rendered_.fragments.end() && next->x == x && next->y == y) ++next;
        compare({x, y}, {first, next}, result);
      }
    }
    aggregator_.flush(result);
  }

 private:
  void compare(PixelPosition pixel, std::span<const Fragment> fragments, Result& result) {
    aggregator_.count_compared(4);
    const PixelTruth truth =
        fragments.empty() ? clear_ : truth_of_fragment(context_, fragments.back());
    const std::uint8_t* stored =
        rendered_.pixels.data() + 4 * rendered_.pixel_index(pixel.x, pixel.y);
    if (holds(stored, truth))
      aggregate(pixel, fragments.empty() ? -1 : fragments.back().primitive, truth, stored);
    else
      report(pixel, fragments, truth, stored, result);
  }

  void aggregate(PixelPosition pixel, int primitive, const PixelTruth& truth,
                 const std::uint8_t* stored) {
    const ValueAggregate::Place place{pixel.x, pixel.y, primitive};
    bool differs = false;
    for (std::size_t c = 0; c < 4; ++c) {
      if (stored[c] == to_unorm8(truth.exact[c])) continue;
      differs = true;
      const double exact = truth.exact[c] * 255;
      aggregator_.add_error(place, {static_cast<int>(c), exact, static_cast<double>(stored[c]),
                                    std::fabs(stored[c] - exact), 255});
    }
    if (differs) aggregator_.add_place(place);
  }

  void report(PixelPosition pixel, std::span<const Fragment> fragments, const PixelTruth& truth,
              const std::uint8_t* stored, Result& result) {
    const Fragment* earlier = nullptr;
    for (const Fragment& fragment : fragments.first(fragments.empty() ? 0 : fragments.size() - 1))
      if (holds(stored, truth_of_fragment(context_, fragment))) earlier = &fragment;
    Disagreement d = earlier != nullptr ? value_disagreement(pixel, -1, "framebuffer.order", 11)
                                        : value_disagreement(pixel, -1, "framebuffer.unorm8", 10);
    for (std::size_t c = 0; c < 4; ++c) {
      d.exact.push_back(to_unorm8(truth.exact[c]));
      d.rendered.push_back(stored[c]);
    }
    const std::string what = fragments.empty()
                                 ? "the clear colour, since no fragment was drawn there"
                                 : fmt::format("the colour of primitive {}, the last drawn there",
                                               fragments.back().primitive);
    std::string note;
    if (earlier != nullptr)
      note = fmt::format("; that is the colour of primitive {}, drawn earlier", earlier->primitive);
    else if (!fragments.empty() && holds(stored, clear_))
      note = "; that is the clear colour";
    d.explanation = fmt::format("the pixel should hold {}, ({}); it holds ({}){}", what,
                                fmt::join(d.exact, ", "), fmt::join(d.rendered, ", "), note);
    result.disagreements.push_back(std::move(d));
  }

  const ValueContext& context_;
  const Rendering& rendered_;
  PixelTruth clear_;
  ValueAggregator aggregator_{"pixel", "framebuffer.unorm8", 10};
};

}  // namespace

void compare_pixels(const ValueContext& context, const Rendering& rendered, Result& result) {
  PixelComparison(context, rendered).run(result);
}

}  // namespace edgecase
