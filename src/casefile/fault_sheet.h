// SPDX-License-Identifier: MIT
//
// Gathers the faults of all cases of one file, so that a person reads each of them once.
//
// A fault that every combination of a sweep has is one of the file, and told as such; any other
// says which values of the axes or which image lead to it, and how many more cases have it.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "casefile/fields.h"

namespace edgecase {

class FaultSheet {
 public:
  // Adds what was found in one combination; `label` names it: "dx=0.5, dy=1".
  void add(std::vector<Diagnostic> faults, const std::string& label) { add(faults, label, false); }
  // The same for an image of a combination: "dx=0.5, dy=1, octant=3".
  void add_of_image(std::vector<Diagnostic> faults, const std::string& label) {
    add(faults, label, true);
  }

  bool empty() const { return entries_.empty(); }
  // Enough faults that reading more cases helps nobody.
  bool full() const { return entries_.size() >= kMost; }

  // Hands all faults over; `combinations`: how many were read.
  void move_to(Findings& findings, std::size_t combinations);

 private:
  static constexpr std::size_t kMost = 20;
  void add(std::vector<Diagnostic>& faults, const std::string& label, bool image);

  struct Entry {
    Diagnostic fault;
    std::string label;      // of the first case
    bool image = false;     // of an image
    std::size_t count = 0;  // of cases
  };
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t> index_;  // text of a fault -> entry
};

}  // namespace edgecase
