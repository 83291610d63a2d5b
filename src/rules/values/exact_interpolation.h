// SPDX-License-Identifier: MIT
//
// The results of interpolate_exact where several are wanted at once: for attributes that share
// vertices, and for neighbouring pixels.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "exact/interval_lanes.h"
#include "model/rendering.h"
#include "rules/values/interpolation.h"
#include "rules/values/weighted_mean.h"

namespace edgecase {

class LazyRational;

// The results of interpolate_exact for several attributes of one primitive at one sample. The part
// that the attributes share is computed once.
class ExactPlace {
 public:
  explicit ExactPlace(Point sample) : sample_(sample) {}

  // Attributes have the same vertices and line parameter; those with perspective have the same w.
  Interval value(const Interpolant& f) const;

 private:
  using Weights = WeightsOf<Interval>;
  bool has_extent(const Interpolant& f) const;
  const Weights& weights_of(const Interpolant& f) const;
  const Interval& total_of(const Interpolant& f) const;

  Point sample_;
  // Computed on demand: whether the primitive has an extent, the weights as they are, the weights
  // divided by w, and the sum of the former.
  mutable std::optional<bool> has_extent_;
  mutable std::optional<Weights> plain_;
  mutable std::optional<Weights> over_w_;
  mutable std::optional<Interval> total_;
};

// The same at the centres of neighbouring pixels of a row. Vector instructions compute several
// pixels of a triangle together.
class ExactRun {
 public:
  static constexpr std::size_t kLongest = 16;

  // `first` and the pixels to its right, `count` in all, 1 to kLongest.
  ExactRun(PixelPosition first, std::size_t count) : first_(first), count_(count) {}

  // For each pixel what ExactPlace::value gives at its centre, to the bit; `count` results. The
  // attributes must be as there. `rational`: that of the attribute, kept from run to run.
  void values(const Interpolant& f, LazyRational& rational, std::span<Interval> results);

 private:
  using Lanes = IntervalLanes<kLongest>;
  using Weights = WeightsOf<Lanes>;
  const Weights& weights_of(const Interpolant& f);
  Lanes means_of(const Interpolant& f);
  Point centre(std::size_t pixel) const;

  PixelPosition first_;
  std::size_t count_;
  std::optional<ExactPlace> alone_;  // of a single pixel
  std::optional<Weights> plain_;
  std::optional<Weights> over_w_;
};

}  // namespace edgecase
