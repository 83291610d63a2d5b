// SPDX-License-Identifier: MIT
//
// What is measured of fragment operations, beside rules and their rates.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "model/fragment_operations.h"
#include "model/scene.h"

namespace edgecase {

// Codes that are so far from the one at or below the exact number, and how far above that one the
// numbers lay, as shares of a step.
struct CodeStep {
  std::size_t numbers = 0;
  double least = 0;
  double largest = 0;
};

// What numbers of 0 to 1 become in an unsigned format.
struct CodeEvidence {
  std::string id;  // "depth16", "depth24", "unorm8"
  int bits = 0;
  std::size_t numbers = 0;
  std::map<long, CodeStep> steps;  // by distance from the code at or below
};

// One unit of polygon offset, as the depths of triangles without a slope tell it.
struct MeasuredUnit {
  DepthFormat format = DepthFormat::none;
  int exponent = 0;  // of the largest depth, of a floating-point buffer
  std::size_t depths = 0;
  // In steps of 1/(2^bits - 1), or in 2^(exponent - 23).
  double least = 0;
  double largest = 0;
};

// How blended values differ from those of the alternative that comes closest, by term.
struct BlendResidual {
  BlendTerm term;
  bool is_alpha = false;
  std::size_t values = 0;
  std::map<int, std::size_t> off;  // by difference, 0 not among them
  std::size_t wrong() const;
};

struct OutputProfile {
  std::vector<CodeEvidence> codes;
  std::vector<MeasuredUnit> units;
  std::vector<BlendResidual> blending;  // those that differ, the worst first
  std::size_t random_scenes = 0;
};

}  // namespace edgecase
