// SPDX-License-Identifier: MIT
//
// Places of gl_FragCoord where the shader runs for each sample with a share of 1 (ruling 63).
#pragma once

#include <optional>

#include "diff/values/value_diff.h"
#include "exact/fixed.h"
#include "model/rendering.h"

namespace edgecase {

bool is_at_share_of_one(const ValueContext& context, const Fragment& fragment);

// The place in the pixel that gl_FragCoord.xy names, if that is not the sample for which the shader
// runs; none at any other share, too.
std::optional<Point> other_place(const ValueContext& context, const Rendering& rendered,
                                 const Fragment& fragment);

// True if the fragment's depth is that of a place.
bool has_depth_of(const ValueContext& context, const Fragment& fragment, Point place);

// True if some place of the fragment's pixel has this 1/w.
bool has_w_of_pixel(const ValueContext& context, const Fragment& fragment, double inverse_w);

}  // namespace edgecase
