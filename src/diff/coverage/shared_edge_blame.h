// SPDX-License-Identifier: MIT
//
// Blames disagreements on faults of shared edges: a hole or a double hit on an edge of two
// triangles (ruling 5) turns what both disagree on there into violations.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "diff/coverage/shared_edge_faults.h"
#include "model/result.h"

namespace edgecase {

// The ruling that the fault breaks: 5, or 47 if it holds only at reported positions.
int ruling_on(const SharedEdgeFault& fault);

// The disagreements of one comparison, which must outlive it.
class SharedEdgeBlame {
 public:
  explicit SharedEdgeBlame(Result& result);

  // Turns the disagreements of both triangles at the pixel into violations; false if there are
  // none. A triangle that breaks a ruling by itself keeps that ruling, unless it is contested.
  bool add(const SharedEdgeFault& fault, const std::string& reason);
  // Turns those that are only counted. Call once, after the last fault.
  void finish();

 private:
  using Sample = std::tuple<int, int, int, int>;  // primitive, sample, row, column
  struct Blamed {
    PixelPosition pixel;
    bool is_certain = true;
    int ruling = 0;
  };

  void index_new();
  bool blame_counted(int primitive, const SharedEdgeFault& fault);
  void split(CountedDisagreements& counted, std::vector<Blamed> blamed,
             std::vector<CountedDisagreements>& turned) const;

  Result& result_;
  std::multimap<Sample, std::size_t> in_full_;  // indices
  std::size_t indexed_ = 0;
  std::map<std::pair<int, int>, std::vector<std::size_t>> counted_;  // by primitive and sample
  std::map<std::size_t, std::vector<Blamed>> blamed_;                // by index of counted ones
};

}  // namespace edgecase
