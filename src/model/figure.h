// SPDX-License-Identifier: MIT
//
// Figure: the geometry that explains a pixel, computed by rules and drawn by reports. Reports know
// no rules: they style marks by role and write their labels.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace edgecase {

enum class MarkRole {
  primitive,       // outline of the primitive as given, in window coordinates
  vertex,          // one of its vertices
  snapped_vertex,  // where a vertex lies after snapping
  region,          // the area that a sample's rule examines: a line's diamond, a point's square
  owned,           // edges or corners of a primitive or region that count as inside
  sample,          // the sample in question
  edge,            // the edge or segment that decides
};

inline const char* name_of(MarkRole role) {
  switch (role) {
    case MarkRole::primitive:
      return "primitive";
    case MarkRole::vertex:
      return "vertex";
    case MarkRole::snapped_vertex:
      return "snapped-vertex";
    case MarkRole::region:
      return "region";
    case MarkRole::owned:
      return "owned";
    case MarkRole::sample:
      return "sample";
    case MarkRole::edge:
      return "edge";
  }
  return "?";
}

struct Mark {
  MarkRole role = MarkRole::primitive;
  bool closed = false;                            // joins the last position to the first
  std::vector<std::pair<double, double>> points;  // window coordinates, pixels, y up
  std::string label;                              // beside the first position; may be empty
};

struct Figure {
  std::vector<Mark> marks;
};

}  // namespace edgecase
