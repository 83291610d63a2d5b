// SPDX-License-Identifier: MIT
//
// The colour that a pixel should hold, by the renderer's own fragments.
#pragma once

#include <cstddef>

#include "diff/values/pixel_truth.h"
#include "diff/values/value_diff.h"

namespace edgecase {

PixelTruth truth_of_clear(const Scene& scene);

// The colour that the renderer reported, or all that it may have had if it reported none.
PixelTruth truth_of_fragment(const ValueContext& context, const Fragment& fragment);

// The permitted component, with all that a contested ruling accepts.
Interval accepted(const PixelTruth& truth, std::size_t component);

// True if a fragment's alpha may be changed after the shader: that of a multisampled point smaller
// than the fade threshold, which is 1, may be multiplied by the square of the size (GL 4.6 core,
// 14.4, equation 14.2, and 17.2).
bool may_fade(const ValueContext& context, const Fragment& fragment);
// An alpha, with all values to which it may fade.
Interval with_fade(const ValueContext& context, const Fragment& fragment, Interval alpha);

// Compares pixels, of multisampled targets sample by sample, with the last fragment that the
// renderer reports there. Appends disagreements and aggregates to `result`.
void compare_pixels(const ValueContext& context, const Rendering& rendered, Result& result);

// True if the fragment has its provoking vertex' own colour, which no interpolation and no texture
// changes.
bool has_flat_color(const ValueContext& context, const Fragment& fragment);
// Compares the pixels of one colour with each other, on a target of one sample: dithering is
// disabled. Appends disagreements to `result`.
void compare_dithering(const ValueContext& context, const Rendering& rendered, Result& result);

}  // namespace edgecase
