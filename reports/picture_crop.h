// SPDX-License-Identifier: MIT
//
// The part of a case's target that a picture shows, so that a few relevant pixels are not lost in a
// large target.
#pragma once

#include "model/verdict.h"
#include "reports/difference_svg.h"

namespace edgecase {

// Columns left to right - 1 and rows bottom to top - 1 of the target, y up.
struct Crop {
  int left = 0;
  int bottom = 0;
  int right = 0;
  int top = 0;
  int width() const { return right - left; }
  int height() const { return top - bottom; }
  bool contains(const Disagreement& d) const {
    return left <= d.x && d.x < right && bottom <= d.y && d.y < top;
  }
};

// The pixels that either side draws, with a margin of one pixel, within the target. If that is more
// than 24 pixels on a side and something differs, the pixels that differ, with a margin of four. If
// nothing is drawn, the whole target.
Crop crop_of(const DifferencePicture& picture);

}  // namespace edgecase
