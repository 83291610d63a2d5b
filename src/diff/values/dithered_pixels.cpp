// SPDX-License-Identifier: MIT
//
// Dithering, which is disabled in all targets (ruling 10). Which of the two codes next to a colour
// is stored must then not depend on x and y (GL 4.6 core, 17.3.8). So all pixels that one draw
// gives one flat colour, and all that hold the clear colour, hold one code in each component.
// Smooth colours are left out: two equal ones may have differed before the renderer reported them.
#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <tuple>

#include "diff/findings/add_disagreement.h"
#include "diff/values/pixel_truth.h"
#include "diff/values/value_diff.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

// A component of a draw's colour; draw -1 stands for the clear colour.
using ColorKey = std::tuple<int, std::size_t, double>;

class DitheredPixels {
 public:
  DitheredPixels(const ValueContext& context, const Rendering& rendered)
      : context_(context), rendered_(rendered), clear_(truth_of_clear(context.scene)) {}

  void run(Result& result) {
    for_each_component([&](PixelPosition pixel, const ColorKey& key, int stored) {
      if (stored == to_unorm8(std::get<double>(key))) nearest_.try_emplace(key, pixel);
    });
    for_each_component([&](PixelPosition pixel, const ColorKey& key, int stored) {
      const double component = std::get<double>(key);
      const Unorm8Range codes = unorm8_permitted(component);
      // What is not permitted by itself is reported already.
      if (stored == to_unorm8(component) || stored < codes.low || stored > codes.high) return;
      const auto other = nearest_.find(key);
      if (other != nearest_.end()) report(pixel, other->second, key, stored, result);
    });
  }

 private:
  template <class Visit>
  void for_each_component(const Visit& visit) const {
    auto next = rendered_.fragments.begin();
    for (int y = 0; y < rendered_.height; ++y)
      for (int x = 0; x < rendered_.width; ++x) {
        const Fragment* last = nullptr;
        for (; next != rendered_.fragments.end() && next->x == x && next->y == y; ++next)
          last = &*next;
        if (last != nullptr && !has_flat_color(context_, *last)) continue;
        const auto color =
            last == nullptr ? clear_.exact : truth_of_fragment(context_, *last).exact;
        const int draw = last == nullptr ? -1 : context_.primitive_of(*last).draw;
        const std::uint8_t* const stored =
            rendered_.pixels.data() + 4 * rendered_.pixel_index(x, y);
        for (std::size_t c = 0; c < 4; ++c) visit({x, y}, {draw, c, color[c]}, stored[c]);
      }
  }

  void report(PixelPosition pixel, PixelPosition other, const ColorKey& key, int stored,
              Result& result) const {
    constexpr const char* kComponents[] = {"red", "green", "blue", "alpha"};
    const auto [draw, c, component] = key;
    Disagreement* const d =
        add_disagreement(result, pixel, value_class(-1, RuleId::framebuffer_unorm8));
    if (d == nullptr) return;
    d->figure = value_figure(pixel);
    d->exact = {static_cast<double>(to_unorm8(component))};
    d->rendered = {static_cast<double>(stored)};
    d->explanation = fmt::format(
        "the {} of {}, {:.9g}, is stored as {} here and as {} at pixel ({}, {}): dithering is "
        "disabled, so the choice must not depend on the pixel (17.3.8)",
        kComponents[c], draw < 0 ? "the clear colour" : fmt::format("draw {}", draw), component,
        stored, to_unorm8(component), other.x, other.y);
  }

  const ValueContext& context_;
  const Rendering& rendered_;
  const PixelTruth clear_;
  std::map<ColorKey, PixelPosition> nearest_;  // a pixel that holds the nearest code
};

}  // namespace

void compare_dithering(const ValueContext& context, const Rendering& rendered, Result& result) {
  DitheredPixels(context, rendered).run(result);
}

}  // namespace edgecase
