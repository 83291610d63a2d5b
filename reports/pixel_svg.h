// SPDX-License-Identifier: MIT
//
// One pixel of a case, and why it is drawn or not, as an SVG picture: the target's pixels, the
// primitives' outlines, and the geometry that the rule tests.
//
// The pixel has a frame, solid if it is drawn and dashed if it is not. A dot is a covered sample, a
// ring an uncovered one. The picture has its own background and no style sheet, for pages that
// allow none.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "model/figure.h"

namespace pugi {
class xml_node;
}

namespace edgecase {

// One sample's part of a decision.
struct PixelDecision {
  bool is_covered = false;
  Figure figure;
};

struct PixelPicture {
  int width = 0;  // of the target, pixels
  int height = 0;
  std::string title;
  std::vector<int> hits;  // fragments per pixel, row by row from the bottom, width * height; of
                          // several samples 1 where any is covered
  Figure figure;          // the scene's outlines
  int x = 0;              // the pixel that is explained
  int y = 0;
  std::vector<PixelDecision> decisions;  // of each primitive, of multisampled ones of each sample
};

// Adds the picture as an element `svg`.
void add_pixel_svg(pugi::xml_node parent, const PixelPicture& picture);

// The same element as a file. The caller checks the stream's state afterwards.
void write_pixel_svg(const PixelPicture& picture, std::ostream& out);

}  // namespace edgecase
