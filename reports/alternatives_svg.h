// SPDX-License-Identifier: MIT
//
// One scene drawn under several alternatives, side by side, as an SVG picture for documents.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "model/figure.h"

namespace edgecase {

struct DrawnAlternative {
  std::string name;
  std::vector<int> hits;  // per pixel, row by row from the bottom
};

struct AlternativesPicture {
  int width = 0;  // pixels
  int height = 0;
  Figure figure;  // drawn over every alternative
  std::vector<DrawnAlternative> alternatives;
};

// The same picture gives the same bytes. The caller checks the stream's state afterwards.
void write_alternatives_svg(const AlternativesPicture& picture, std::ostream& out);

}  // namespace edgecase
