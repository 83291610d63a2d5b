// SPDX-License-Identifier: MIT
//
// Sizes that a renderer supports (GL 4.6 core, 14.4.1, 14.5.2.3 and 14.5.4; table 23.55).
//
// Implementations need not support all sizes of points, nor all widths of multisampled lines: an
// unsupported size becomes the nearest supported one. GL_POINT_SIZE_GRANULARITY and
// GL_SMOOTH_LINE_WIDTH_GRANULARITY give the distance between supported sizes; others may be
// supported besides.
#pragma once

#include <map>
#include <string>

#include "exact/fixed.h"

namespace edgecase {

// Evenly spaced sizes, pixels, from `least` on. step 0: unknown; every size is taken as supported.
struct SizeSteps {
  double least = 1;
  double step = 0;
};

struct SupportedSizes {
  SizeSteps points;
  SizeSteps lines;  // multisampled ones
};

// The sizes that a renderer claims by its traits "point_size_steps" and "sampled_line_width_steps",
// as "1 by 0.125". A trait that is missing, or has another form, means unknown.
SupportedSizes supported_sizes(const std::map<std::string, std::string>& traits);

// The least and the largest size that a requested size may become, both more than 0.
struct SizeRange {
  Fixed low;
  Fixed high;
};
SizeRange permitted_sizes(Fixed asked, const SizeSteps& supported);

}  // namespace edgecase
