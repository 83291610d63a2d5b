// SPDX-License-Identifier: MIT
//
// SampleImage: the samples of a multisampled image, for display.
#pragma once

#include "base/packed_words.h"
#include "base/shared.h"
#include "model/rendering.h"
#include "model/sampling.h"

namespace edgecase {

// Whatever was not reported is empty.
struct SampleImage {
  int samples = 1;            // per pixel; 1: not multisampled, and all else is empty
  SamplePositions positions;  // one per sample
  // RGBA8 before it is resolved: one plane per sample, row by row from the bottom.
  Shared<PackedWords> pixels;
  // The number of fragments written to each sample: planes as above.
  Shared<PackedWords> hits;
  // Per pixel: bit s is set if some fragment covers sample s (Fragment::coverage).
  Shared<PackedWords> coverage;

  // Equal parts share one object in memory from here on.
  void share_with(const SampleImage& other) {
    pixels.share_with(other.pixels);
    hits.share_with(other.hits);
    coverage.share_with(other.coverage);
  }
  friend bool operator==(const SampleImage&, const SampleImage&) = default;
};

SampleImage sample_image(const Rendering& rendering);

}  // namespace edgecase
