// SPDX-License-Identifier: MIT
//
// Things that are one for a renderer on a surface, whatever it draws there: the unit of polygon
// offset of a depth buffer (14.6.5), the place of a sample (8.8), the least alpha of which a pixel
// keeps so many samples (14.9.3). Each answer may show bounds of
// them (Result::shown), and each may be right alone while two of them cannot both be.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "diff/findings/most_meet.h"
#include "model/result.h"

namespace edgecase {

// What most answers show of a thing.
struct Meeting {
  Interval where;
  std::string lowest;       // the answer that shows the largest `low` of them
  std::string highest;      // that which shows the least `high`
  bool is_refuted = false;  // some answer shows something else
};
using Meetings = std::map<SingleThing, Meeting>;

// Gathers what answers show. What they show alike is kept once.
class SingleThings {
 public:
  void add(const Result& result, const std::string& id);
  // Of all but cells.
  Meetings meetings() const;

 private:
  struct Saying {
    std::size_t answers = 0;
    std::string first;  // the least id
  };
  // By thing, then by low and high.
  std::map<SingleThing, std::map<std::pair<double, double>, Saying>> sayings_;
};

// What a run says of its renderer's things, as traits: "unit of polygon offset, 16 bits" is
// "1.526e-05 to 1.527e-05", "place of sample 2 of 4" is "(0.359, 0.594) to (0.391, 0.656)".
std::map<std::string, std::string> traits_of(const Meetings& meetings);
// Whether a trait is one of them, with whatever behind its name.
bool is_of_a_thing(const std::string& trait);

// Adds a disagreement for each thing of which the answer shows what most others refute, and names
// one that does. Two intervals that both meet others need not meet each other, but those of most
// answers meet in one place, so one of them alone refutes what does not (Helly). Cells are refuted
// where none of them meets what most answers show of both coordinates. Takes away what another run
// made it say.
void report_refuted_things(const Meetings& meetings, Result& result);

}  // namespace edgecase
