// SPDX-License-Identifier: MIT
#include "rules/textures/level_selection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "exact/elementary.h"
#include "rules/textures/directed.h"

namespace edgecase {
namespace {

double crossover_of(const Sampler& sampler, Crossover crossover) {
  const bool sharper_minified = sampler.magnify == Filter::linear &&
                                sampler.minify == Filter::nearest &&
                                sampler.mipmap != MipFilter::none;
  return crossover == Crossover::by_filters && sharper_minified ? 0.5 : 0;
}

// For a lambda of 0 or more. Adding 1/2 would round just below a tie, so no sum is formed.
double nearest_level(double lambda, NearestLevel choice) {
  const double below = std::floor(lambda);
  const double fraction = lambda - below;
  if (fraction < 0.5) return below;
  if (fraction > 0.5) return below + 1;
  switch (choice) {
    case NearestLevel::down_at_ties:
      return below;
    case NearestLevel::up_at_ties:
      return below + 1;
    case NearestLevel::even_at_ties:
      return std::fmod(below, 2) == 0 ? below : below + 1;
  }
  return below;
}

// The nearest levels of an interval from 0 to `most`: all whole numbers between the two ends.
Interval nearest_levels(Interval lambda, double most, const LevelRules& rules) {
  const auto lowest = rules.any_tie ? NearestLevel::down_at_ties : rules.nearest;
  const auto highest = rules.any_tie ? NearestLevel::up_at_ties : rules.nearest;
  return {std::min(nearest_level(lambda.low, lowest), most),
          std::min(nearest_level(lambda.high, highest), most)};
}

// Exact: `steps` is a power of two.
double on_grid(double fraction, double steps, bool to_nearest) {
  const double scaled = fraction * steps;
  const double below = std::floor(scaled);
  return (to_nearest && scaled - below >= 0.5 ? below + 1 : below) / steps;
}

// For a fraction of less than 1. Grows with it, except for one_at_ties.
double weight_of(double fraction, LevelWeight choice) {
  switch (choice) {
    case LevelWeight::exact:
      return fraction;
    case LevelWeight::floor_8:
      return on_grid(fraction, 256, false);
    case LevelWeight::nearest_8:
      return on_grid(fraction, 256, true);
    case LevelWeight::floor_4:
      return on_grid(fraction, 16, false);
    case LevelWeight::nearest_4:
      return on_grid(fraction, 16, true);
    case LevelWeight::floor_3:
      return on_grid(fraction, 8, false);
    case LevelWeight::nearest_3:
      return on_grid(fraction, 8, true);
    case LevelWeight::narrow:
      return std::clamp((fraction - 0.4375) * 8, 0.0, 1.0);
    case LevelWeight::one_at_ties:
      return fraction == 0.5 ? 1 : fraction;
    case LevelWeight::whole:
      return fraction < 0.5 ? 0 : 1;
  }
  return fraction;
}

Interval weights_of(Interval fraction, LevelWeight choice) {
  const bool holds_tie = fraction.low < fraction.high && fraction.contains(0.5);
  if (choice == LevelWeight::one_at_ties && holds_tie)
    return {fraction.low, weight_of(0.5, choice)};
  return {weight_of(fraction.low, choice), weight_of(fraction.high, choice)};
}

// For the lambdas of an interval between a level and the next. If lambda begins below the level its
// fraction is negative, and so is the weight until it is clamped.
Interval weights_between(Interval lambda, double level, const LevelRules& rules) {
  const bool reaches_next = lambda.high >= level + 1;
  const double high = reaches_next ? next_below(1.0) : lambda.high - level;
  Interval weights = weights_of({lambda.low - level, high}, rules.weight);
  // The fraction itself gets as close to 1 as lambda gets to the next level.
  if (reaches_next) weights.high = next_above(weights.high);
  return {std::max(Down::sum(weights.low, -rules.slack), 0.0),
          std::min(Up::sum(weights.high, rules.slack), 1.0)};
}

LevelPicks nearest_picks(Interval lambda, const Sampler& sampler, int last,
                         const LevelRules& rules) {
  const int most = last - sampler.base_level;
  const Interval levels = nearest_levels(lambda, most, rules);
  LevelPicks picks;
  for (int d = static_cast<int>(levels.low); d <= static_cast<int>(levels.high); ++d)
    picks.push_back({sampler.minify, sampler.base_level + d, sampler.base_level + d, 0, false});
  return picks;
}

LevelPicks linear_picks(Interval lambda, const Sampler& sampler, int last,
                        const LevelRules& rules) {
  const int most = last - sampler.base_level;
  const auto whole = [&](double end) {
    return static_cast<int>(std::min<double>(std::floor(end), most));
  };
  LevelPicks picks;
  for (int d = whole(lambda.low); d <= whole(lambda.high); ++d) {
    const int level = sampler.base_level + d;
    if (d == most)
      picks.push_back({sampler.minify, last, last, 0, false});
    else
      picks.push_back({sampler.minify, level, level + 1, weights_between(lambda, d, rules), false});
  }
  return picks;
}

// For a lambda of 0 or more.
LevelPicks minified_picks(Interval lambda, const Sampler& sampler, int last,
                          const LevelRules& rules) {
  switch (sampler.mipmap) {
    case MipFilter::none:
      break;
    case MipFilter::nearest:
      return nearest_picks(lambda, sampler, last, rules);
    case MipFilter::linear:
      return linear_picks(lambda, sampler, last, rules);
  }
  return {{sampler.minify, sampler.base_level, sampler.base_level, 0, false}};
}

// Two levels and the weight between them, as one number.
Interval linear_levels(Interval lambda, double most, const LevelRules& rules) {
  const double first = std::floor(lambda.low);
  const double second = std::floor(lambda.high);
  const double low = first + weights_between(lambda, first, rules).low;
  const double high = second + (second == most ? 0 : weights_between(lambda, second, rules).high);
  return {std::min(low, most), high};
}

}  // namespace

int last_level(const Sampler& sampler, const Texture& texture) {
  const bool single = texture.levels.size() <= 1 && !texture.generated;
  if (single || texture.levels.empty()) return sampler.base_level;
  const TextureLevel& first = texture.levels.front();
  const int end_of_chain = level_count(first.width, first.height) - 1;
  return std::max(std::min(end_of_chain, sampler.max_level), sampler.base_level);
}

Sampler limited(Sampler sampler, LevelLimits limits) {
  constexpr int kLastOfAnyChain = 1000;  // OpenGL's own max_level
  switch (limits) {
    case LevelLimits::as_set:
      break;
    case LevelLimits::max_level_as_max_lod:
      sampler.max_lod = std::min(sampler.max_lod, static_cast<float>(sampler.max_level));
      sampler.max_level = kLastOfAnyChain;
      break;
    case LevelLimits::max_lod_from_level_0:
      sampler.max_lod -= static_cast<float>(sampler.base_level);
      break;
    case LevelLimits::max_level_ignored:
      sampler.max_level = kLastOfAnyChain;
      break;
  }
  return sampler;
}

LevelPicks pick_levels(Interval lambda, const Sampler& sampler, int last, const LevelRules& rules) {
  lambda = known(lambda);
  const double crossover = crossover_of(sampler, rules.crossover);
  LevelPicks picks;
  if (lambda.low <= crossover)
    picks.push_back({sampler.magnify, sampler.base_level, sampler.base_level, 0, true});
  const double first_minified = rules.any_tie ? crossover : next_above(crossover);
  if (lambda.high < first_minified) return picks;
  lambda.low = std::max(lambda.low, first_minified);
  for (const LevelPick& pick : minified_picks(lambda, sampler, last, rules)) picks.push_back(pick);
  return picks;
}

Interval accessed_level(Interval lambda, const Sampler& sampler, int last,
                        const LevelRules& rules) {
  const double most = std::max(last - sampler.base_level, 0);
  lambda = known(lambda);
  lambda = {std::clamp(lambda.low, 0.0, most), std::clamp(lambda.high, 0.0, most)};
  switch (sampler.mipmap) {
    case MipFilter::none:
      break;
    case MipFilter::nearest:
      return nearest_levels(lambda, most, rules);
    case MipFilter::linear:
      return linear_levels(lambda, most, rules);
  }
  return 0;
}

Rule crossover_rule() {
  Rule rule;
  rule.id = RuleId::texture_crossover;
  rule.title = "A texture is magnified up to a level of detail of 0 and minified beyond";
  rule.spec = "8.14, as corrected in 2018 (KhronosGroup/OpenGL-API, issue 34), and 8.15";
  rule.latitude = "none";
  rule.standard = "zero";
  rule.alternatives = alternatives_of<Crossover>();
  return rule;
}

Rule nearest_level_rule() {
  Rule rule;
  rule.id = RuleId::texture_nearest_level;
  rule.title = "NEAREST_MIPMAP_NEAREST and LINEAR_MIPMAP_NEAREST take the nearest level";
  rule.spec = "8.14.3, nearest mipmap selection";
  rule.latitude = "which of two equally near levels (ruling 21)";
  rule.standard = "down-at-ties";
  rule.alternatives = alternatives_of<NearestLevel>();
  rule.rulings = {
      {21,
       "Ties of levels: where the level of detail lies halfway between two levels, or just at the "
       "crossover between magnification and minification, either is permitted, each by itself: "
       "the least error of a logarithm decides. The formulas take the larger image, and "
       "magnify."}};
  return rule;
}

Rule level_limits_rule() {
  Rule rule;
  rule.id = RuleId::texture_level_limits;
  rule.title = "base_level and max_level limit levels; min_lod and max_lod limit levels of detail";
  rule.spec = "8.14.1 (equation 8.9) and 8.14.3 (the level q)";
  rule.latitude = "none";
  rule.standard = "as-set";
  rule.alternatives = alternatives_of<LevelLimits>();
  return rule;
}

Rule level_weight_rule() {
  Rule rule;
  rule.id = RuleId::texture_level_weight;
  rule.title = "NEAREST_MIPMAP_LINEAR and LINEAR_MIPMAP_LINEAR weigh two levels by the fraction";
  rule.spec = "8.14.3, linear mipmap filters";
  rule.latitude = "the precision of the weight: 2^-6 (rulings 22 and 50)";
  rule.standard = "exact";
  rule.alternatives = alternatives_of<LevelWeight>();
  rule.rulings = {
      {22,
       "Weight of the second level: OpenGL states no number of bits for it. Permitted is any "
       "weight of a level of detail that is off by 2^-6 at most from the one that the renderer "
       "reports, or else from one that ruling 20 permits: the Khronos tests ask for 6 bits. What "
       "is beyond is a violation, or contested by ruling 50. The same error may lead to another "
       "nearest level."}};
  return rule;
}

namespace {

struct Axes {
  bool along_x;  // true if the vector along x is the longer one
  Interval longer;
  Interval shorter;
};

double middle(Interval value) {
  return std::isinf(value.high) ? value.high : value.low + (value.high - value.low) / 2;
}

Axes axes_of(const Footprint& footprint) {
  const auto [x, y] = lengths(footprint);
  if (middle(x) > middle(y)) return {true, x, y};
  return {false, y, x};
}

Interval divided(Interval value, double by) {
  return {Down::quotient(value.low, by), Up::quotient(value.high, by)};
}

// The number of lookups: a whole number of at least 1, even if max_anisotropy is NaN.
int probe_count(const Axes& axes, float max_anisotropy) {
  const double longer = middle(axes.longer);
  const double shorter = middle(axes.shorter);
  const double most = std::floor(static_cast<double>(max_anisotropy));
  if (longer == shorter) return 1;
  return static_cast<int>(std::min(std::ceil(longer / shorter), most));
}

ProbeRow equal_probes(const Axes& axes, float max_anisotropy) {
  const int count = probe_count(axes, max_anisotropy);
  ProbeRow row{axes.along_x, divided(axes.longer, count), {}};
  for (int i = 1; i <= count; ++i)
    row.probes.push_back({static_cast<double>(i) / (count + 1) - 0.5, divided(1, count)});
  return row;
}

ProbeRow gaussian_probes(const Axes& axes) {
  constexpr int kCount = 5;
  const Interval fifth = divided(axes.longer, kCount);
  ProbeRow row{axes.along_x,
               {std::max(axes.shorter.low, fifth.low), std::max(axes.shorter.high, fifth.high)},
               {}};
  Interval sum = 0;
  for (int i = -2; i <= 2; ++i) {
    const Interval weight = around(exponential(-8.0 * i * i / (kCount * kCount)), kPlacesOfLibrary);
    row.probes.push_back({static_cast<double>(i) / kCount, weight});
    sum = sum + weight;
  }
  for (Probe& probe : row.probes) probe.weight = probe.weight / sum;
  return row;
}

}  // namespace

ProbeRow probes(const Footprint& footprint, float max_anisotropy, Anisotropy choice,
                ScaleFactor isotropic) {
  if (choice == Anisotropy::none || !(max_anisotropy > 1))
    return {.scale_factor = scale_factor(footprint, isotropic), .probes = {{0, 1}}};
  const Axes axes = axes_of(footprint);
  return choice == Anisotropy::extension ? equal_probes(axes, max_anisotropy)
                                         : gaussian_probes(axes);
}

Rule anisotropy_rule() {
  Rule rule;
  rule.id = RuleId::texture_anisotropy;
  rule.title = "Anisotropic filters look up several times along the longer vector of a footprint";
  rule.spec = "8.14 (texture minification), with EXT_texture_filter_anisotropic";
  rule.latitude = "the implementation chooses the method, on levels that it may use (ruling 23)";
  rule.standard = "extension";
  rule.alternatives = alternatives_of<Anisotropy>();
  rule.rulings = {
      {23,
       "Anisotropy: the maximum that a sampler sets is a request, and the method an example; the "
       "catalogued method that comes closest is reported. Any method may access mip levels only "
       "if the minification filter uses them, and none outside base_level to max_level (8.14). "
       "So if the maximum is more than 1, a level accessed is one of these levels; lambda' may be "
       "anything. If each of the levels has one colour, each component of the result lies between "
       "the least and the largest of them. Else it leaves what lies between the least and the "
       "largest of their texels by the difference of both at most, since cubic and Lanczos "
       "filters, whose weights may be negative, lead no further."},
      {kRulingOnAnisotropicHull,
       "Contested: an anisotropic filter makes a component of levels of many colours that does not "
       "lie between the least and the largest of the texels that it may access, but leaves that "
       "range by no more than their difference. No mean leads there. But filters with negative "
       "weights do, and the scheme is the implementation's (8.14; the same in "
       "EXT_texture_filter_anisotropic, which OpenGL ES uses). The Khronos tests "
       "(KHR-GL46.texture_filter_anisotropic.*) count blurred points, and do not ask this. Beyond "
       "that difference it is a violation (ruling 23)."}};
  return rule;
}

}  // namespace edgecase
