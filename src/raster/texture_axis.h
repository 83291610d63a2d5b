// SPDX-License-Identifier: MIT
//
// TextureAxis: one of a textured primitive's two coordinates, s or t, at its pixels.
//
// A nearest filter asks on which side of a texel's border a coordinate lies, and a grid of texel
// coordinates asks the like. An interval that leaves that open is asked again as a quotient of
// integers, and the answer is an interval, or a point, that leaves nothing open. A linear filter
// without a grid asks nothing: its colours run into one another at the texels' centres.
//
// Borders are asked for in the levels that a lookup takes, and in no others: a number on a tie of a
// grid may be rounded up in one level and down in another.
#pragma once

#include <optional>
#include <span>

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
  TextureAxis(const Interpolant& coordinate, Wrap wrap) : coordinate_(coordinate), wrap_(wrap) {}

  const Interpolant& coordinate() const { return coordinate_; }
  Interval value(Point sample) const { return interpolate_exact(coordinate_, sample); }

  // Where to look up the value, or what lies so much further along the axis: on one side of every
  // border of levels that are so many texels long. It holds the number unless that lies beside a
  // border by less than doubles know. A number that is no double is replaced from 2^20 on, either
  // way, by one near 0 that the wrap mode makes the same of. An interval that is narrower than
  // 2^-40 and touches no border is handed on as it is.
  Interval place(Point sample, TexelBorders borders, std::span<const int> sizes,
                 const Rational& further);

  // None as rational_interpolation.h says.
  std::optional<Rational> derivative(const QuadPixel& at, Axis axis, DerivativeMethod method);

 private:
  const std::optional<RationalInterpolation>& rational();
  Interval decided(const Rational& value, TexelBorders borders, std::span<const int> sizes) const;
  Rational brought_near(const Rational& value) const;

  Interpolant coordinate_;
  Wrap wrap_;
  std::optional<std::optional<RationalInterpolation>> rational_;  // once it is asked for
};

}  // namespace edgecase
