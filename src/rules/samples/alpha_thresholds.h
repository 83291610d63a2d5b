// SPDX-License-Identifier: MIT
//
// Numbers of samples that alpha to coverage keeps, over many pixels.
//
// The function of alpha may be pseudo-random and differ from pixel to pixel (GL 4.6 core, 14.9.3).
// The plainest such function has a threshold of its own for each sample of each pixel, spread
// evenly over 0 to 1, and keeps a sample if alpha is above it. One pixel may then keep fewer
// samples than another of a smaller alpha, and any number of them. Of many pixels the numbers are
// proportional to alpha. So only what such thresholds practically never yield is held against a
// renderer.
#pragma once

#include <span>

namespace edgecase {

// A pixel with one fragment that covers all samples.
struct KeptByAlpha {
  double alpha = 0;
  int kept = 0;
};

enum class AlphaTrend {
  proportional,      // as thresholds that were drawn by chance may have it
  disproportionate,  // too many, too few, too steep or too far apart
  falling,           // fewer as alpha grows
};

// The odds below which thresholds practically never yield what was kept.
inline constexpr double kLeastOdds = 1e-9;

// How the numbers follow alpha. Where pixels of equal alphas keep equal numbers, so many that
// thresholds practically never yield that, one function of alpha is taken to hold for all pixels:
// then it is falling as soon as its mean number falls from an alpha to a larger one, and else
// disproportionate, whatever it is.
AlphaTrend trend_of(std::span<const KeptByAlpha> pixels, int samples);

}  // namespace edgecase
