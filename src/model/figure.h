// SPDX-License-Identifier: MIT
//
// Figure: the geometry that explains a pixel, computed by rules and drawn by reports. Reports know
// no rules: they style marks by role and write their labels.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "model/names.h"

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
template <>
inline constexpr auto kNames<MarkRole> =
    std::to_array<Named<MarkRole>>({{MarkRole::primitive, "primitive"},
                                    {MarkRole::vertex, "vertex"},
                                    {MarkRole::snapped_vertex, "snapped-vertex"},
                                    {MarkRole::region, "region"},
                                    {MarkRole::owned, "owned"},
                                    {MarkRole::sample, "sample"},
                                    {MarkRole::edge, "edge"}});

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
