// SPDX-License-Identifier: MIT
//
// The colours of textured fragments of which a renderer tells none: what the lookup yields exactly,
// and the bounds that the lookup's rulings set (20 to 24, 48, 50 and 53), with the coordinates and
// the mip chain that the renderer tells.
#pragma once

#include <utility>
#include <vector>

#include "diff/textures/texture_lookups.h"
#include "diff/values/pixel_truth.h"

namespace edgecase {

// True if the rendering has a textured fragment without a colour.
bool has_untold_colors(const ValueContext& context, const Rendering& rendered);

class UntoldColors {
 public:
  // Everything referred to must outlive this.
  UntoldColors(const ValueContext& context, const Rendering& exact, const Rendering& rendered)
      : lookups_(context, exact, rendered) {}

  // The colour of one of the rendering's own fragments, of a textured draw.
  PixelTruth of(const Fragment& fragment);

 private:
  PixelTruth looked_up(const Fragment& fragment);

  TextureLookups lookups_;
  // Of the latest pixel: a sample after the other, and a choice after the other, asks for the same.
  std::vector<std::pair<const Fragment*, PixelTruth>> known_;
};

}  // namespace edgecase
