// SPDX-License-Identifier: MIT
#include "raster/fragment_runs.h"

#include <algorithm>

#include "rules/values/exact_interpolation.h"

namespace edgecase {

// The number of pixels from the first that lie side by side, up to the longest run.
std::size_t FragmentRuns::length_of_run() const {
  const std::size_t most = std::min(pixels_.size(), ExactRun::kLongest);
  std::size_t length = 1;
  while (length < most && pixels_[length].y == pixels_[0].y &&
         pixels_[length].x == pixels_[length - 1].x + 1)
    ++length;
  return length;
}

void FragmentRuns::shade_run(std::size_t count) {
  constexpr std::size_t kFew = 4;  // fewer are shaded sooner one by one
  run_.clear();
  if (count < kFew) {
    for (const PixelPosition pixel : pixels_.first(count))
      run_.push_back(shade(primitive_, attributes_, pixel));
    return;
  }
  ExactRun run(pixels_[0], count);
  std::array<Interval, ExactRun::kLongest> values;
  run.values(attributes_.depth, rationals_[4], values);
  for (std::size_t i = 0; i < count; ++i)
    run_.push_back(fragment_at(primitive_, pixels_[i], clamped_depth(attributes_, values[i])));
  for (std::size_t c = 0; c < 4; ++c) {
    run.values(attributes_.color[c], rationals_[c], values);
    for (std::size_t i = 0; i < count; ++i) run_[i].color[c] = middle(values[i]);
  }
}

const Fragment& FragmentRuns::next() {
  if (next_ == run_.size()) {
    const std::size_t count = length_of_run();
    shade_run(count);
    pixels_ = pixels_.subspan(count);
    next_ = 0;
  }
  return run_[next_++];
}

}  // namespace edgecase
