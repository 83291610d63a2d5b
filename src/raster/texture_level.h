// SPDX-License-Identifier: MIT
//
// The point and the level at which a textured primitive is looked up at its pixels.
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
// A nearest filter, like a grid of texel coordinates, has to know on which side of a texel's border
// a coordinate lies. If an interval leaves that open, the coordinate is computed again as a
// quotient of integers, and the answer is an interval, or a point, that leaves nothing open. A
// linear filter without a grid has no such question: its colours are continuous.
//
// Borders are considered only in the levels that a lookup uses: a number on a tie of a grid may be
// rounded up in one level and down in another.

// The lookup's discontinuities within each texel: multiples of 1/parts, or none if parts is 0.
struct TexelBorders {
  int parts = 0;
  // Whether odd multiples are borders, rounded to the even multiple of 2/parts. Otherwise a
  // coordinate on a border belongs to the part above it.
  bool ties_to_even = false;
};

TexelBorders texel_borders(Filter filter, TexelGrid grid, TextureFormat format);

class TextureAxis {
 public:
  TextureAxis(const Interpolant& coordinate, Wrap wrap) : coordinate_(coordinate), wrap_(wrap) {}

  const Interpolant& coordinate() const { return coordinate_; }
  Interval value(Point sample) const { return interpolate_exact(coordinate_, sample); }

  // The coordinate to look up at a sample, where it has this value(), plus `further`: an interval
  // on one side of every border of levels with these `sizes` in texels. It holds the number unless
  // that lies closer to a border than doubles resolve. A number that is no double and lies at least
  // 2^20 from 0 is replaced by an equivalent one, under the wrap mode, near 0. An interval narrower
  // than 2^-40 that touches no border is returned unchanged.
  Interval place(Point sample, Interval value, TexelBorders borders, std::span<const int> sizes,
                 const Rational& further);
  // The same without anything further.
  Interval place(Point sample, Interval value, TexelBorders borders, std::span<const int> sizes);

  // Nothing in the cases named in rational_interpolation.h.
  std::optional<Rational> derivative(const QuadPixel& at, Axis axis, DerivativeMethod method);

 private:
  const std::optional<RationalInterpolation>& rational() { return rational_.of(coordinate_); }
  template <class Number>  // Rational or MachineQuotient
  Interval decided(const Number& value, TexelBorders borders, std::span<const int> sizes) const;
  Rational brought_near(const Rational& value) const;

  Interpolant coordinate_;
  Wrap wrap_;
  LazyRational rational_;
};

// Decides exactly on which side of a border between two levels a level of detail lies.
//
// The square of a scale factor is a rational number r. Levels change where log2(r)/2 + bias is a
// multiple T of 1/2, that is where r = 2^(2 (T - bias)). If 2 (T - bias) is whole, both sides are
// rational and are compared. Otherwise the right side is irrational, a root of a power of two: r
// never equals it, no tie exists, and a double suffices to find the side.

// In s and t, or texels of the base level, per pixel. The second number is 0 in one dimension.
struct RationalFootprint {
  std::array<Rational, 2> dx;
  std::array<Rational, 2> dy;
  int dimensions = 2;
};

RationalFootprint in_texels(const RationalFootprint& derivatives, int width, int height);
// The narrowest intervals that hold the numbers.
Footprint intervals_of(const RationalFootprint& footprint);

// Whether a choice uses several probes.
bool is_anisotropic(const Sampler& sampler, const TextureChoice& choice);
// As probes(), for a footprint in texels; recognizes lengths whose quotient is exactly whole.
ProbeRow exact_probes(const RationalFootprint& footprint, const Sampler& sampler,
                      const TextureChoice& choice);
// The offset of each probe from the centre, in the footprint's units.
std::vector<std::array<Rational, 2>> ways_to(const ProbeRow& row,
                                             const RationalFootprint& footprint, Anisotropy choice);

// The square of the row's scale factor, for a footprint in texels.
Rational squared_scale_factor(const RationalFootprint& footprint, const ProbeRow& row,
                              const Sampler& sampler, const TextureChoice& choice);
// The same for a method, as scale_factor().
Rational squared_scale_factor(const RationalFootprint& footprint, ScaleFactor method);

// Whether the scale factor of a pixel's own derivatives of s and t is exactly 0.
bool has_no_extent(const std::array<Interpolant, 2>& coordinates, const QuadPixel& at,
                   int dimensions, const TextureChoice& choice);

// Whether the interval touches a number at which another level, or another weight of it, begins.
bool is_level_open(Interval lambda_prime, LevelWeight weight);

// The part of lambda_prime on the exact number's side of the border that it touches, or the border
// itself if the number lies on it. `squared` is the scale factor's square, `bias` the addend of
// with_bias. A rational number cannot lie on a border whose square is irrational: there the middle
// of the interval decides, and the border belongs above.
Interval decided_level(Interval lambda_prime, const Rational& squared, Interval bias,
                       Log2Method log2, LevelWeight weight);

}  // namespace edgecase
