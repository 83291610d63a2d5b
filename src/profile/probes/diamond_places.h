// SPDX-License-Identifier: MIT
//
// Points at the places of a pixel's diamond; DiamondPlace and its names are in probe_scenes.h.
#pragma once

#include "profile/probes/probe_scenes.h"
#include "profile/random/random_source.h"

namespace edgecase {

// The point of pixel (0, 0) at a place, by one number: raw, at least 2 and less than 1/2 pixel.
// On an edge it is the horizontal distance from the centre; outside, the distance from either side
// of the pixel's square, halved; inside, that from the centre, halved in x and quartered in y. Of a
// corner there is one point only.
Point point_at(DiamondPlace place, std::int64_t along);

// One of those points with coordinates that are multiples of `step`, raw, a power of two up to 1/16
// pixel.
Point random_point_at(DiamondPlace place, RandomSource& random, std::int64_t step);

// Does some boundary decide whether the segment meets the pixel's diamond, or ends in it?
bool is_tied(const Segment& segment, PixelPosition pixel);

}  // namespace edgecase
