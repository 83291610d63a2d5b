// SPDX-License-Identifier: MIT
//
// At which place, and in which level, a textured primitive is looked up at its pixels.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "exact/rational.h"
#include "model/texture.h"
#include "rules/choices.h"
#include "rules/textures/level_of_detail.h"
#include "rules/textures/texel_filter.h"
#include "rules/values/derivative.h"
#include "rules/values/rational_interpolation.h"

namespace edgecase {

// TextureAxis: one of a textured primitive's two coordinates, s or t, at its pixels.
//
// A nearest filter asks on which side of a texel's border a coordinate lies, and a grid of texel
// coordinates asks the like. An interval that leaves that open is asked again as a quotient of
// integers, and the answer is an interval, or a point, that leaves nothing open. A linear filter
// without a grid asks nothing: its colours run into one another at the texels' centres.
//
// Borders are asked for in the levels that a lookup takes, and in no others: a number on a tie of a
// grid may be rounded up in one level and down in another.

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

// Level of detail without doubt: on which side of a border between two levels it lies.
//
// A scale factor's square is a rational number r. Levels change where log2(r)/2 + bias is a
// multiple T of 1/2, that is where r = 2^(2 (T - bias)). Where 2 (T - bias) is whole, both are
// rational and are compared. Where it is not, the right side is a root of a power of two, which is
// irrational: r never equals it, and no tie exists; a double tells which side it is on.

// Per pixel: of (s, t), or in texels of the base level. The second number is 0 in one dimension.
struct RationalFootprint {
  std::array<Rational, 2> dx;
  std::array<Rational, 2> dy;
  int dimensions = 2;
};

RationalFootprint in_texels(const RationalFootprint& derivatives, int width, int height);
// The narrowest intervals.
Footprint intervals_of(const RationalFootprint& footprint);

// Are there several probes under a choice?
bool is_anisotropic(const Sampler& sampler, const TextureChoice& choice);
// As probes(), of a footprint in texels: lengths whose quotient is whole are seen as such.
ProbeRow exact_probes(const RationalFootprint& footprint, const Sampler& sampler,
                      const TextureChoice& choice);
// How far each probe lies from the centre, in what the footprint is in.
std::vector<std::array<Rational, 2>> ways_to(const ProbeRow& row,
                                             const RationalFootprint& footprint, Anisotropy choice);

// The square of the row's scale factor, of a footprint in texels.
Rational squared_scale_factor(const RationalFootprint& footprint, const ProbeRow& row,
                              const Sampler& sampler, const TextureChoice& choice);
// The same of a method, as scale_factor().
Rational squared_scale_factor(const RationalFootprint& footprint, ScaleFactor method);

// Is the scale factor of a pixel's own derivatives of s and t 0, to the last digit?
bool has_no_extent(const std::array<Interpolant, 2>& coordinates, const QuadPixel& at,
                   int dimensions, const TextureChoice& choice);

// Does the interval touch a number where another level, or another weight of it, begins?
bool is_level_open(Interval lambda_prime, LevelWeight weight);

// The part of lambda_prime that lies on the exact number's side of the border that it touches; the
// border itself where the exact number does. `squared` is the scale factor's square, `bias` what
// with_bias adds. No rational number lies on a border whose square is irrational: there the
// interval's middle tells the side, the border itself being the upper one.
Interval decided_level(Interval lambda_prime, const Rational& squared, Interval bias,
                       Log2Method log2, LevelWeight weight);

}  // namespace edgecase
