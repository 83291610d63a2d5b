// SPDX-License-Identifier: MIT
//
// Which pixels of a case a picture shows, so that a few that matter are not lost in a large target.
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

// What either side draws and a pixel more all round, within the target. Where that has more than
// 24 pixels on a side and something differs: what differs, and four pixels more. The whole target
// where nothing is drawn.
Crop crop_of(const DifferencePicture& picture);

}  // namespace edgecase
