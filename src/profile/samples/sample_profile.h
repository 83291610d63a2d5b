// SPDX-License-Identifier: MIT
//
// What is measured of multisampled targets, beside rules and their rates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "model/sampling.h"

namespace edgecase {

// A number of samples that was asked for.
struct AskedSamples {
  int samples = 0;
  std::string refusal;  // why the renderer does not make them; empty: it does
};

// Between which places an edge found a sample, pixels, both inclusive.
struct SampleInterval {
  Fixed low;
  Fixed high;
};

// Where one sample lies.
struct MeasuredPosition {
  Point reported;
  SampleInterval x;
  SampleInterval y;
  bool is_measured = false;  // false: no edges found it, or edges of the two sides contradict
  bool is_as_reported() const {
    return is_measured && x.low <= reported.x && reported.x <= x.high && y.low <= reported.y &&
           reported.y <= y.high;
  }
};

struct MeasuredPositions {
  int samples = 0;
  std::vector<MeasuredPosition> positions;  // by sample; empty: none are reported
  std::string placement;                    // the alternative of sample.positions; empty: none fits
};

// How often the shader ran, and where it had its attributes, of draws that ask for it in one way.
struct InvocationRow {
  std::string asked;       // "once", "share 0.25", "sample"
  std::string location;    // of the attribute: its qualifier
  bool at_sample = false;  // must it be evaluated at the sample (rulings 29 and 30)?
  int least = 1;           // invocations that a wholly covered pixel must have
  // By how many samples of the pixel are covered: pixels with so many invocations.
  std::map<int, std::map<int, std::size_t>> invocations;
  // By place ("centre", "sample 2", …): attributes that were evaluated there, of wholly covered
  // pixels, and of others.
  std::map<std::string, std::size_t> whole;
  std::map<std::string, std::size_t> partial;

  // Was an attribute that is bound to its sample evaluated elsewhere?
  bool is_violation() const;
};

// What the places are called where an invocation's own sample lies.
inline constexpr const char* kOwnSample = "own sample";

// Neighbouring alphas of which alpha to coverage makes the same mask.
struct AlphaRun {
  float first = 0;
  float last = 0;
  std::uint32_t mask = 0;
};

struct SampleProfile {
  std::string unavailable;  // why nothing was measured; empty: it was
  std::vector<AskedSamples> counts;
  int samples = 0;  // what all that follows, but for positions, was measured with
  std::vector<MeasuredPositions> positions;  // of each number of samples that is made
  std::size_t random_scenes = 0;
  std::size_t with_ties = 0;  // random scenes with a tie
  std::vector<InvocationRow> invocations;
  std::vector<AlphaRun> alphas;
};

}  // namespace edgecase
