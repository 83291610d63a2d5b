// SPDX-License-Identifier: MIT
//
// The levels that a lookup reads, the share of each, and the number of probes.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "exact/interval.h"
#include "model/texture.h"
#include "rules/rule.h"
#include "rules/textures/level_of_detail.h"

namespace edgecase {

// Essay: Filters and levels
//
// Which filter and which levels a level of detail selects (GL 4.6 core, 8.14, 8.14.3 and 8.15).
//
//   lambda <= c     the texture is magnified: the magnification filter takes the base level
//   lambda > c      the texture is minified: the minification filter takes, by its mipmap part,
//     none            the base level
//     nearest         the level ceil(lambda + 1/2) - 1 beyond the base, at most q
//     linear          the levels floor(lambda) and floor(lambda) + 1 beyond, the second weighted by
//                     the fraction of lambda; from q on q alone
//
// q is the last level that is used. It is floor(log2(larger side of the base level)) beyond the
// base, and at most max_level.
//
// c is 0 since version 4.5 (KhronosGroup/OpenGL-API, issue 34). Versions 1.0 to 3.0 asked for 1/2
// under two conditions. The magnification filter is linear, and the minification filter is
// NEAREST_MIPMAP_NEAREST or NEAREST_MIPMAP_LINEAR. Both of these are nearest within a level.
// Versions 3.1 to 4.4 let implementations choose between that and 0.

Rule crossover_rule();      // texture.crossover
Rule nearest_level_rule();  // texture.nearest-level
Rule level_weight_rule();   // texture.level-weight
Rule level_limits_rule();   // texture.level-limits

enum class Crossover {
  zero,        // c = 0 whatever the filters
  by_filters,  // c = 1/2 for the filters above
};
template <>
inline constexpr auto kNames<Crossover> = std::to_array<TabledAlternative<Crossover>>(
    {{Crossover::zero, "zero", Openness::mandated, "a level of detail of 0, whatever the filters"},
     {Crossover::by_filters, "by-filters", Openness::illegal,
      "1/2 for LINEAR magnification with NEAREST_MIPMAP_NEAREST or NEAREST_MIPMAP_LINEAR, else 0; "
      "versions 1.0 to 3.0 asked for it, 3.1 to 4.4 allowed it"}});

// The choice if lambda lies halfway between two levels.
enum class NearestLevel {
  down_at_ties,  // the larger image, as the formula says
  up_at_ties,    // the smaller one, as round() may
  even_at_ties,  // the level whose number beyond the base is even
};
template <>
inline constexpr auto kNames<NearestLevel> = std::to_array<TabledAlternative<NearestLevel>>(
    {{NearestLevel::down_at_ties, "down-at-ties", Openness::open,
      "the larger image where two levels are equally near"},
     {NearestLevel::up_at_ties, "up-at-ties", Openness::open,
      "the smaller image where two levels are equally near"},
     {NearestLevel::even_at_ties, "even-at-ties", Openness::open,
      "the level with an even number, counted from the base, where two are equally near"}});

// The fraction of lambda by which the second level is weighted.
enum class LevelWeight {
  exact,
  floor_8,    // a multiple of 1/256, rounded down
  nearest_8,  // to the nearest, half up
  floor_4,    // of 1/16
  nearest_4,
  floor_3,  // of 1/8
  nearest_3,
  // From what shows least to what shows most.
  one_at_ties,  // 1 at a fraction of 1/2: half a level off there, exact elsewhere
  whole,        // 0 below 1/2, else 1: the nearer level alone
  narrow,       // 0 below 7/16, 1 above 9/16, linear between: fixture gpuweb 4818
};
template <>
inline constexpr auto kNames<LevelWeight> = std::to_array<TabledAlternative<LevelWeight>>(
    {{LevelWeight::exact, "exact", Openness::open, "the fraction of the level of detail"},
     {LevelWeight::floor_8, "floor-8", Openness::open, "the fraction cut to 8 bits"},
     {LevelWeight::nearest_8, "nearest-8", Openness::open,
      "the fraction rounded to 8 bits, half up"},
     {LevelWeight::floor_4, "floor-4", Openness::open, "the fraction cut to 4 bits"},
     {LevelWeight::nearest_4, "nearest-4", Openness::open,
      "the fraction rounded to 4 bits, half up"},
     {LevelWeight::floor_3, "floor-3", Openness::illegal, "the fraction cut to 3 bits"},
     {LevelWeight::nearest_3, "nearest-3", Openness::illegal,
      "the fraction rounded to 3 bits, half up"},
     {LevelWeight::one_at_ties, "one-at-ties", Openness::illegal,
      "1 for a fraction of 1/2, half a level too far; else the fraction"},
     {LevelWeight::whole, "whole", Openness::illegal,
      "0 for fractions below 1/2, else 1: the nearer level alone, as without a filter between "
      "levels"},
     {LevelWeight::narrow, "narrow", Openness::illegal,
      "0 for fractions up to 7/16, 1 from 9/16 on, linear between them"}});

// What a sampler's limits of levels, and of levels of detail, are taken for. They differ where the
// base level is not 0, or the chain goes on beyond max_level.
enum class LevelLimits {
  as_set,
  max_level_as_max_lod,  // the level of detail is at most max_level; the chain goes on
  max_lod_from_level_0,  // max_lod counts from level 0 instead of the base level
  max_level_ignored,     // the chain goes on
};
template <>
inline constexpr auto kNames<LevelLimits> = std::to_array<TabledAlternative<LevelLimits>>(
    {{LevelLimits::as_set, "as-set", Openness::mandated,
      "levels count from level 0, levels of detail from the base level"},
     {LevelLimits::max_level_as_max_lod, "max-level-as-max-lod", Openness::illegal,
      "max_level limits the level of detail, counted from the base level, and not the levels"},
     {LevelLimits::max_lod_from_level_0, "max-lod-from-level-0", Openness::illegal,
      "max_lod counts from level 0 instead of the base level"},
     {LevelLimits::max_level_ignored, "max-level-ignored", Openness::illegal,
      "levels beyond max_level are read, too"}});
// The sampler whose limits, as set, have that effect.
Sampler limited(Sampler sampler, LevelLimits limits);

// A way to make a colour: one level under a filter, or two levels, the second by its weight.
struct LevelPick {
  Filter filter;
  int level;        // index into the texture's levels, base_level included
  int next;         // the second level; equal to `level` if there is only one
  Interval weight;  // of the second, 0 to 1
  bool magnified;
};
using LevelPicks = boost::container::small_vector<LevelPick, 2>;

struct LevelRules {
  Crossover crossover = Crossover::zero;
  NearestLevel nearest = NearestLevel::down_at_ties;
  LevelWeight weight = LevelWeight::exact;
  bool any_tie = false;  // use both levels at a tie, and either side of the crossover at its value
  // How far the weight may be from its fraction, either way; like texel_filter.h's slack.
  double slack = 0;
};

// The last level that a sampler uses, q: an index into the texture's levels, including those that
// are generated. For a texture that has a single level and generates none, the base level.
int last_level(const Sampler& sampler, const Texture& texture);

// Every pick that a lambda of the interval yields, from its low end to its high end: one for an
// exact lambda, unless any_tie finds two. Infinite ends are levels far away; an end that is NaN is
// the infinite one on its side.
LevelPicks pick_levels(Interval lambda, const Sampler& sampler, int last, const LevelRules& rules);

// The level accessed as textureQueryLod reports it (GLSL 4.60, 8.9.1), 0 the base level: 0 without
// a filter between levels; for nearest, the level's number; for linear, lambda within 0 to q with
// its fraction as made by `weight`. Magnification has no effect.
Interval accessed_level(Interval lambda, const Sampler& sampler, int last, const LevelRules& rules);

// Essay: Anisotropy
//
// Anisotropic filters: several lookups along the longer vector of a footprint (GL 4.6 core, 8.14.1,
// with the text of EXT_texture_filter_anisotropic). Each lookup reads a finer level than that
// vector alone would select. OpenGL gives one method as an example. Implementations may use
// another, on levels that the sampler lets them access. Pmax and Pmin are the lengths of the
// vectors:
//
//   extension   N = min(ceil(Pmax / Pmin), max_anisotropy) lookups of equal weight at
//               i / (N + 1) - 1/2 of the longer vector, i = 1 to N, in the level log2(Pmax / N); N
//               is rounded down where max_anisotropy is not an integer
//   gaussian-5  a course's: five lookups at -2/5, -1/5, 0, 1/5, 2/5 of the longer vector, weights
//               proportional to exp(-2 (2x)^2) at x of it, in the level log2(max(Pmin, Pmax / 5))
//
// If the vectors have equal lengths, the one along y counts as the longer, as in the extension.

Rule anisotropy_rule();  // texture.anisotropy
inline constexpr int kRulingOnAnisotropicHull = 57;

enum class Anisotropy {
  extension,
  gaussian_5,
  none,  // as if max_anisotropy were 1
};
template <>
inline constexpr auto kNames<Anisotropy> = std::to_array<TabledAlternative<Anisotropy>>(
    {{Anisotropy::extension, "extension", Openness::open,
      "up to max_anisotropy lookups of equal weight along the longer vector; the level is that of "
      "its length divided by their number, as in the example of EXT_texture_filter_anisotropic"},
     {Anisotropy::gaussian_5, "gaussian-5", Openness::open,
      "five lookups with Gaussian weights along the longer vector; the level is that of the "
      "shorter "
      "vector or of a fifth of the longer one"},
     {Anisotropy::none, "none", Openness::open, "one lookup, whatever the sampler says"}});

// One lookup: how far along the longer vector from the footprint's centre, -1/2 to 1/2, and its
// share of the colour.
struct Probe {
  double offset;
  Interval weight;
};

using Probes = boost::container::small_vector<Probe, 1>;

struct ProbeRow {
  bool along_x = false;   // the longer vector is that along x; arbitrary for one probe
  Interval scale_factor;  // texels per pixel; its logarithm is lambda_base
  Probes probes;          // from -1/2 on; without anisotropy one at 0, of weight 1
};

// If the lengths are known only as intervals, their middles decide which is longer and how many
// lookups there are. `max_anisotropy` is 1 to 16; for 1, and under `none`, the scale factor is that
// of `isotropic`.
ProbeRow probes(const Footprint& footprint, float max_anisotropy, Anisotropy choice,
                ScaleFactor isotropic);

}  // namespace edgecase
