// SPDX-License-Identifier: MIT
//
// The other algorithms for lines, each as the set of pixels that its description names. Where an
// implementation walks or keeps a running error, here every pixel is asked by itself: is its column
// one of those that take part, and is its row the right one there?
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/line_algorithm.h"  // for the names of the algorithms alone
#include "tests/oracles/diamonds.h"
#include "tests/oracles/ties.h"

namespace edgecase::oracle {

// What is asked of a line; names as in policies.
struct LineQuestion {
  Line line;
  Rational width = 1;
  LineAlgorithm algorithm = LineAlgorithm::diamond_exit;
  WideLine wide = WideLine::replicate;
  Boundary boundary;
  Ties ties;
};

// The pixels of a window that the line covers, in ascending order.
std::vector<PixelPosition> line_pixels(const LineQuestion& question, const PixelBounds& window);

// Where the centre of a pixel lies, the sample moved: positive inside the area of a line, negative
// outside, zero on the boundary.
int where_in_rectangle(const Line& line, const Rational& width, const Place& sample);
int where_in_parallelogram(const Line& line, const Rational& width, const Place& sample);

// Does a walk or an integer algorithm meet a case in the window that its description decides by a
// convention: a column's end on a column border or centre, a row border hit exactly, a line midway
// between two pixels?
bool hangs_on_convention(const LineQuestion& question, const PixelBounds& window);

}  // namespace edgecase::oracle
