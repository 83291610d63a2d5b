// SPDX-License-Identifier: MIT
//
// SampleImage: what the samples of a multisampled image hold, for those who show it.
#pragma once

#include "model/packed_words.h"
#include "model/rendering.h"
#include "model/sampling.h"
#include "model/shared.h"

namespace edgecase {

// Whatever was not told is empty.
struct SampleImage {
  int samples = 1;            // of a pixel; 1: not multisampled, and all else is empty
  SamplePositions positions;  // `samples` of them
  // RGBA8 before it is resolved: a plane for each sample, row by row from the bottom.
  Shared<PackedWords> pixels;
  // Fragments that were written to each sample: planes as above.
  Shared<PackedWords> hits;
  // Per pixel: bit s set where some fragment covers sample s (Fragment::coverage).
  Shared<PackedWords> coverage;

  // What both tell alike is one in memory from here on.
  void share_with(const SampleImage& other) {
    pixels.share_with(other.pixels);
    hits.share_with(other.hits);
    coverage.share_with(other.coverage);
  }
  friend bool operator==(const SampleImage&, const SampleImage&) = default;
};

SampleImage sample_image(const Rendering& rendering);

}  // namespace edgecase
