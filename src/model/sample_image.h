// SPDX-License-Identifier: MIT
//
// SampleImage: what the samples of a multisampled image hold, for those who show it.
#pragma once

#include <cstdint>
#include <vector>

#include "model/rendering.h"
#include "model/sampling.h"

namespace edgecase {

// Whatever was not told is empty.
struct SampleImage {
  int samples = 1;            // of a pixel; 1: not multisampled, and all else is empty
  SamplePositions positions;  // `samples` of them
  // RGBA8 before it is resolved: a plane for each sample, row by row from the bottom.
  std::vector<std::uint8_t> pixels;
  // Fragments that were written to each sample: planes as above.
  std::vector<std::uint32_t> hits;
  // Per pixel: bit s set where some fragment covers sample s (Fragment::coverage).
  std::vector<std::uint32_t> coverage;

  friend bool operator==(const SampleImage&, const SampleImage&) = default;
};

SampleImage sample_image(const Rendering& rendering);

}  // namespace edgecase
