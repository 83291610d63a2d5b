// SPDX-License-Identifier: MIT
//
// Why a pixel of a case is drawn or not: the text and picture of `edgecase explain` and of the rule
// book.
#pragma once

#include <string>

#include "model/case.h"
#include "model/policy.h"
#include "reports/pixel_svg.h"
#include "tools/edgecase/options.h"

namespace edgecase {

// Lines with the pixel and a sentence for each primitive and, if multisampled, for each sample; for
// a supersampled scene, the same for each pass.
std::string pixel_words(const Scene& scene, const Policy& policy, Pixel pixel);

// The same decisions as a picture; for a supersampled case, those of its first pass.
PixelPicture pixel_picture(const Case& one, const Policy& policy, Pixel pixel);

}  // namespace edgecase
