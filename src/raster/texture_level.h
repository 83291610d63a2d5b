// SPDX-License-Identifier: MIT
//
// Level of detail without doubt: on which side of a border between two levels it lies.
//
// A scale factor's square is a rational number r. Levels change where log2(r)/2 + bias is a
// multiple T of 1/2, that is where r = 2^(2 (T - bias)). Where 2 (T - bias) is whole, both are
// rational and are compared. Where it is not, the right side is a root of a power of two, which is
// irrational: r never equals it, and no tie exists; a double tells which side it is on.
#pragma once

#include <array>
#include <vector>

#include "exact/rational.h"
#include "rules/textures/level_of_detail.h"
#include "rules/textures/texture_choice.h"
#include "rules/values/derivative.h"

namespace edgecase {

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
