// SPDX-License-Identifier: MIT
//
// The diamond-exit rule as it is written: a pixel's diamond is the set of points with
// |dx| + |dy| < 1/2 from its centre, and whatever of its boundary it owns; a segment produces the
// pixel if one of its points lies in the set and its last point does not.
//
// Whether a point of the segment lies in the set can change only where the segment crosses one of
// the four lines of the boundary. So it is enough to look at the two ends, at the crossings, and
// halfway between neighbours among these.
#pragma once

#include <string_view>

#include "tests/oracles/nearby.h"

namespace edgecase::oracle {

struct Line {
  Spot a;
  Spot b;
};

// Slopes from -1 to 1 are x-major, 45 degrees included (GL 4.6 core, 14.5.1).
bool is_x_major(const Line& line);

// The parts of a diamond's boundary that belong to it: edges without their ends, and corners.
struct Owned {
  bool lower_left = false, lower_right = false, upper_left = false, upper_right = false;
  bool left = false, right = false, bottom = false, top = false;
};

// A diamond's boundary by its name: a tie rule's, "direct3d" or "scotty3d".
struct Boundary {
  Move move{0, 0};
  Owned x_major;
  Owned y_major;
};

Boundary boundary_named(std::string_view name);

bool meets_diamond(const Line& line, const Boundary& boundary, int x, int y);
bool ends_in_diamond(const Line& line, const Boundary& boundary, int x, int y);
bool exits_diamond(const Line& line, const Boundary& boundary, int x, int y);

}  // namespace edgecase::oracle
