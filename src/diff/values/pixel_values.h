// SPDX-License-Identifier: MIT
//
// What a pixel should hold, by the renderer's own fragments.
#pragma once

#include <array>

#include "diff/values/value_diff.h"
#include "exact/interval.h"

namespace edgecase {

// Component by component, before conversion to 8 bits.
struct PixelTruth {
  std::array<double, 4> exact{};
  std::array<Interval, 4> permitted{};
};

PixelTruth truth_of_clear(const Scene& scene);

// The colour that the renderer told, or where it told none, all that it may have had.
PixelTruth truth_of_fragment(const ValueContext& context, const Fragment& fragment);

// May a fragment's alpha be changed after the shader? That of a multisampled point smaller than the
// fade threshold, which is 1, may be multiplied by the square of the size (GL 4.6 core, 14.4,
// equation 14.2, and 17.2).
bool may_fade(const ValueContext& context, const Fragment& fragment);
// An alpha, with what it may become so.
Interval with_fade(const ValueContext& context, const Fragment& fragment, Interval alpha);

// Pixels, of multisampled targets sample by sample, against the last fragment that the renderer
// says it drew there. Appends disagreements and aggregates to `result`.
void compare_pixels(const ValueContext& context, const Rendering& rendered, Result& result);

}  // namespace edgecase
