// SPDX-License-Identifier: MIT
//
// What an adversary's fragments carry (GL 4.6 core, 14.5.1, 14.6.1 and 14.6.5; GLSL 4.60, 8.14.1).
#pragma once

#include <array>
#include <vector>

#include "tests/adversaries/shape.h"

namespace edgecase::adversary {

using Values4 = std::array<double, 4>;

class Values {
 public:
  Values(const Scene& scene, const Freedoms& freedoms) : scene_(scene), freedoms_(freedoms) {}

  Values4 attribute(const Shape& shape, const Piece& piece, Place place) const;
  double inverse_w(const Shape& shape, const Piece& piece, Place place) const;
  // With the polygon offset, clamped where there is one.
  double depth(const Shape& shape, const Piece& piece, Place place) const;
  // In the order of model/rendering.h.
  std::array<Values4, kDerivatives> derivatives(const Shape& shape, const Piece& piece,
                                                PixelPosition pixel) const;

 private:
  // Weights of the corners, and what formula makes of numbers that they have.
  using Weights = std::array<Real, 3>;
  Weights weights(const Shape& shape, const Piece& piece, Place place) const;
  Real mean(const Shape& shape, const Piece& piece, Place place, const Weights& weights,
            std::array<Real, 3> numbers) const;
  Real offset(const Shape& shape) const;

  const Scene& scene_;
  const Freedoms& freedoms_;
};

}  // namespace edgecase::adversary
