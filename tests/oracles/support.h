// SPDX-License-Identifier: MIT
//
// What the comparisons share: grids of ends, questions put to both sides, and counts.
#pragma once

#include <string>
#include <vector>

#include "rules/coverage/line_algorithm.h"
#include "tests/oracles/lines.h"

namespace edgecase {

// What a run compared. A scene is one primitive under one choice of rules; a decision is one pixel
// of it; a tied scene holds a decision that hangs on a convention (open and closed boundaries
// differ, a line midway between two pixels, ...).
struct Tally {
  long scenes = 0;
  long decisions = 0;
  long tied = 0;
  void add(const Tally& other);
  void print(const char* what) const;
};

// A line and everything that decides it. Boundary and ties are names.
struct LineScene {
  Segment segment;
  Fixed width = Fixed::from_integer(1);
  LineAlgorithm algorithm = LineAlgorithm::diamond_exit;
  WideLine wide = WideLine::replicate;
  std::string boundary = "left-bottom";
  std::string ties = "left-top";
};

std::string describe(const Segment& segment);
std::string describe(const LineScene& scene);

oracle::Line oracle_line(const Segment& segment);

// Our pixels, sorted, each as often as it came.
std::vector<PixelPosition> our_pixels(const LineScene& scene, const PixelBounds& window);
std::vector<PixelPosition> oracle_pixels(const LineScene& scene, const PixelBounds& window);

// Is the scene tied in the window?
bool is_tied(const LineScene& scene, const PixelBounds& window);

// Compares a scene in a window and counts it; false, with a failure that describes it, where the
// two sides differ.
bool agrees(const LineScene& scene, const PixelBounds& window, Tally& tally);

// All points from `low` to `high` in steps, each in raw units.
std::vector<Point> grid(std::int64_t low, std::int64_t high, std::int64_t step);

// Kinds of lines: every algorithm under the rules that it asks for and no others.
std::vector<LineScene> thin_line_kinds();

}  // namespace edgecase
