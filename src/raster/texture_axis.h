// SPDX-License-Identifier: MIT
//
// TextureAxis: one of a textured primitive's two coordinates, s or t, at its pixels.
//
// A nearest filter asks on which side of a texel's border a coordinate lies, and a grid of texel
// coordinates asks the like. An interval that leaves that open is asked again as a quotient of
// integers, and the answer is an interval, or a point, that leaves nothing open. A linear filter
// without a grid asks nothing: its colours run into one another at the texels' centres.
#pragma once

#include <optional>
#include <vector>

#include "exact/rational.h"
#include "model/texture.h"
#include "rules/textures/texel_filter.h"
#include "rules/values/derivative.h"
#include "rules/values/rational_interpolation.h"

namespace edgecase {

// Where a lookup changes, in every texel: at multiples of 1/parts; nowhere, where parts is 0.
struct TexelBorders {
  int parts = 0;
  // At odd multiples it is rounded to the even multiple of 2/parts; elsewhere a coordinate on a
  // border belongs to what lies above.
  bool ties_to_even = false;
};

TexelBorders texel_borders(Filter filter, TexelGrid grid, TextureFormat format);

class TextureAxis {
 public:
  // `sizes`: along this axis, in texels, of the levels that matter.
  TextureAxis(const Interpolant& coordinate, Wrap wrap, const std::vector<int>& sizes);

  const Interpolant& coordinate() const { return coordinate_; }
  Interval value(Point sample) const { return interpolate_exact(coordinate_, sample); }

  // Where to look up: equivalent to the value under the wrap mode, and on one side of every border.
  // It holds the value, or its equivalent, unless that lies on a border and is no double.
  Interval place(Point sample, TexelBorders borders);
  // The same so much further along the axis.
  Interval place(Point sample, TexelBorders borders, const Rational& further);

  // None as rational_interpolation.h says.
  std::optional<Rational> derivative(const QuadPixel& at, Axis axis, DerivativeMethod method);

 private:
  const std::optional<RationalInterpolation>& rational();
  bool is_open(Interval value, TexelBorders borders) const;
  Interval decided(const Rational& value, TexelBorders borders) const;
  Rational brought_near(const Rational& value) const;

  Interpolant coordinate_;
  Wrap wrap_;
  std::vector<int> sizes_;  // none divides another
  bool is_known_ = false;
  std::optional<RationalInterpolation> rational_;
};

}  // namespace edgecase
