// SPDX-License-Identifier: MIT
//
// Why a pixel of a case is drawn or not, in the words and the picture of `edgecase explain`, which
// are those of the rule book, too.
#pragma once

#include <string>

#include "model/case.h"
#include "model/policy.h"
#include "reports/pixel_svg.h"
#include "tools/edgecase/options.h"

namespace edgecase {

// Lines: the pixel, and a sentence of each primitive, of multisampled ones of each sample; of a
// supersampled scene all of that for each pass.
std::string pixel_words(const Scene& scene, const Policy& policy, Pixel pixel);

// The same decisions as a picture, of a supersampled case those of its first pass.
PixelPicture pixel_picture(const Case& one, const Policy& policy, Pixel pixel);

}  // namespace edgecase
