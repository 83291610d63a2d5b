// SPDX-License-Identifier: MIT
//
// Block walks of a case's triangles, side by side, as an SVG picture for documents.
//
// Both pattern and colour show a block's outcome. Accepted blocks are hatched upward. Rejected ones
// are hatched downward, with the number of the rejecting edge. In tested ones each sample is a dot,
// full if it is covered. The picture brings its own background.
#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "model/figure.h"

namespace edgecase {

struct DrawnBlock {
  enum class Kind { accepted, rejected, tested, divided };
  Kind kind = Kind::accepted;
  int x = 0;  // of its lower left pixel
  int y = 0;
  int width = 0;  // pixels, without those beyond the target
  int height = 0;
  int edge = -1;  // that rejects it
};

struct DrawnSample {
  std::pair<double, double> place;  // window coordinates, pixels, y up
  bool covered = false;
};

// One triangle.
struct BlocksPanel {
  std::string name;
  Mark outline;  // of its three vertices: edge i starts at vertex i
  std::vector<DrawnBlock> blocks;
  std::vector<DrawnSample> samples;  // of tested blocks
  std::vector<std::string> caption;  // lines
};

struct BlocksPicture {
  int width = 0;  // of the target, pixels
  int height = 0;
  std::string title;
  std::vector<BlocksPanel> panels;
};

// The same picture gives the same bytes. The caller checks the stream's state afterwards.
void write_blocks_svg(const BlocksPicture& picture, std::ostream& out);

}  // namespace edgecase
