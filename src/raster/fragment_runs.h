// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "raster/attributes.h"
#include "rules/values/rational_interpolation.h"

namespace edgecase {

// The fragments of a triangle without a texture at all of its pixels, one after the other: what
// shade() gives, to the bit. Neighbours in a row are shaded together. What is given must stay
// valid.
class FragmentRuns {
 public:
  FragmentRuns(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
               std::span<const PixelPosition> pixels)
      : primitive_(primitive), attributes_(attributes), pixels_(pixels) {}

  // The fragment at the next pixel, of which there must be one.
  const Fragment& next();

 private:
  std::size_t length_of_run() const;
  void shade_run(std::size_t count);

  const ScenePrimitive& primitive_;
  const PrimitiveAttributes& attributes_;
  std::span<const PixelPosition> pixels_;  // that are not shaded yet
  std::array<LazyRational, 5> rationals_;  // of the colour and the depth
  std::vector<Fragment> run_;
  std::size_t next_ = 0;  // of the run
};

}  // namespace edgecase
