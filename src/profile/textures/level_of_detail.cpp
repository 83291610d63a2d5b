// SPDX-License-Identifier: MIT
//
// Levels of detail: the levels of each catalogued scale factor, logarithm and derivative for a
// ramp's fragments, which of them a renderer follows, and its errors from their formulas.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "profile/evidence/inference.h"
#include "profile/textures/textures.h"

namespace edgecase {

RampLevels::RampLevels(const Scene& scene, const RuleChoices& found)
    : scene_(scene), found_(found) {
  for (const ScenePrimitive& primitive : primitives_of(scene))
    attributes_.push_back(attributes_of(primitive, found, scene.target));
  last_ = static_cast<double>(scene.textures[0]->levels.size()) - 1;
}

template <class Derivative>
Footprint RampLevels::footprint_by(const Derivative& derivative) const {
  const Texture& texture = *scene_.textures[0];
  const TextureLevel& base = texture.levels[0];
  return footprint({derivative(0, Axis::x), derivative(1, Axis::x)},
                   {derivative(0, Axis::y), derivative(1, Axis::y)}, base.width, base.height,
                   texture.dimensions);
}

Footprint RampLevels::exact_footprint(const FragmentLookup& lookup, DerivativeMethod method) const {
  const auto& color = attributes_[static_cast<std::size_t>(lookup.primitive)].color;
  const QuadPixel at = quad_of(lookup.pixel, found_.values, scene_.target);
  return footprint_by(
      [&](std::size_t c, Axis axis) { return derivative_exact(color[c], at, axis, method); });
}

Footprint RampLevels::rounded_footprint(const FragmentLookup& lookup,
                                        DerivativeMethod method) const {
  // A float32 operation errs by 2^-24, less than a hundredth of the 10^-5 that 2.3.1 allows; the
  // number of operations is unknown.
  constexpr double kShare = 0x1p-4;
  const auto& color = attributes_[static_cast<std::size_t>(lookup.primitive)].color;
  const QuadPixel at = quad_of(lookup.pixel, found_.values, scene_.target);
  return footprint_by([&](std::size_t c, Axis axis) {
    const Interval exact = derivative_exact(color[c], at, axis, method);
    const Interval inexact = derivative_inexact(color[c], at, axis, method);
    return Interval(exact.low - kShare * (exact.low - inexact.low),
                    exact.high + kShare * (inexact.high - exact.high));
  });
}

std::optional<double> RampLevels::reported(const FragmentLookup& lookup, LevelSource source) const {
  if (source == LevelSource::color) return lookup.color[0];
  return lookup.lambda_prime;
}

Interval RampLevels::reportable(Interval lambda_base, LevelSource source) const {
  const TextureUse& use = *scene_.draws[0].texture;
  const Interval lambda_prime =
      with_bias(lambda_base, use.sampler, use.lookup, found_.textures.bias);
  if (source == LevelSource::query) return lambda_prime;
  const TextureChoice& choice = found_.textures;
  const LevelRules rules{choice.crossover, choice.nearest_level, choice.level_weight, false, 0};
  return accessed_level(clamped(lambda_prime, use.sampler), use.sampler, static_cast<int>(last_),
                        rules);
}

bool RampLevels::are_ends(double a, double b, LevelSource source) const {
  return source == LevelSource::color && a == b && (a == 0 || a == last_);
}

// ------------------------------------------------------------------------------------------ traits

namespace {

// A combination of the three rules, as indices into the catalogue's tables.
struct Combination {
  std::size_t scale_factor = 0;
  std::size_t log2 = 0;
  std::size_t derivatives = 0;

  std::size_t index() const {
    return (derivatives * values_of<ScaleFactor>().size() + scale_factor) *
               values_of<Log2Method>().size() +
           log2;
  }
};

std::size_t combination_count() {
  return values_of<DerivativeMethod>().size() * values_of<ScaleFactor>().size() *
         values_of<Log2Method>().size();
}

// Rounding of float32 in scale factors and logarithms.
constexpr double kScaleError = 0x1p-19;
constexpr double kLevelError = 0x1p-17;

// Which combinations yield one lookup.
using Yields = std::vector<bool>;

bool yields_level(const RampLevels& ramp, Interval scale, Log2Method log2, double rendered,
                  LevelSource source) {
  const Interval lambda = log2_of(widened(scale, kScaleError), log2);
  const Interval level =
      ramp.reportable({lambda.low - kLevelError, lambda.high + kLevelError}, source);
  const double slack = source == LevelSource::color ? kLevelError : 0;
  return rendered >= level.low - slack && rendered <= level.high + slack;
}

Yields yields_of(const RampLevels& ramp, const FragmentLookup& lookup, LevelSource source,
                 double rendered) {
  Yields yields(combination_count());
  for (std::size_t d = 0; d < values_of<DerivativeMethod>().size(); ++d) {
    const Footprint footprint = ramp.rounded_footprint(lookup, values_of<DerivativeMethod>()[d]);
    for (std::size_t s = 0; s < values_of<ScaleFactor>().size(); ++s) {
      const Interval scale = scale_factor(footprint, values_of<ScaleFactor>()[s]);
      for (std::size_t l = 0; l < values_of<Log2Method>().size(); ++l)
        yields[Combination{s, l, d}.index()] =
            yields_level(ramp, scale, values_of<Log2Method>()[l], rendered, source);
    }
  }
  return yields;
}

std::vector<Yields> all_yields(std::span<const LookupScene> ramps, const RuleChoices& found) {
  std::vector<Yields> result;
  for (const LookupScene& scene : ramps) {
    const RampLevels ramp(scene.scene, found);
    for (const FragmentLookup& lookup : scene.lookups)
      for (const LevelSource source : {LevelSource::query, LevelSource::color})
        if (const auto level = ramp.reported(lookup, source))
          result.push_back(yields_of(ramp, lookup, source, *level));
  }
  return result;
}

// Among equals, the catalogue's own comes first.
Combination best_of(const std::vector<Yields>& all) {
  std::vector<std::size_t> counts(combination_count());
  for (const Yields& yields : all)
    for (std::size_t i = 0; i < yields.size(); ++i)
      if (yields[i]) ++counts[i];
  const auto methods = values_of<DerivativeMethod>();
  const auto standard = static_cast<std::size_t>(
      std::find(methods.begin(), methods.end(), TextureChoice{}.derivatives) - methods.begin());
  Combination best{0, 0, standard};
  for (std::size_t d = 0; d < methods.size(); ++d)
    for (std::size_t s = 0; s < values_of<ScaleFactor>().size(); ++s)
      for (std::size_t l = 0; l < values_of<Log2Method>().size(); ++l)
        if (const Combination other{s, l, d}; counts[other.index()] > counts[best.index()])
          best = other;
  return best;
}

// One rule, with the two others as in the best combination.
Trait trait_of(RuleId rule, std::size_t Combination::*part, const Combination& best,
               const std::vector<Yields>& all) {
  const std::vector<std::string> names = names_of_alternatives(rule);
  Tally tally(names, best.*part);
  for (const Yields& yields : all) {
    std::vector<bool> agree;
    for (std::size_t i = 0; i < names.size(); ++i) {
      Combination other = best;
      other.*part = i;
      agree.push_back(yields[other.index()]);
    }
    tally.add(agree);
  }
  return tally.trait(rule);
}

}  // namespace

std::vector<Trait> infer_level_of_detail(std::span<const LookupScene> ramps,
                                         const RuleChoices& found) {
  const std::vector<Yields> all = all_yields(ramps, found);
  const Combination best = best_of(all);
  return {trait_of(RuleId::texture_scale_factor, &Combination::scale_factor, best, all),
          trait_of(RuleId::texture_log2, &Combination::log2, best, all),
          trait_of(RuleId::texture_derivatives, &Combination::derivatives, best, all)};
}

// --------------------------------------------------------------------------------------- residuals

namespace {

std::vector<FormulaResidual> formulas_of(const TextureChoice& found) {
  std::vector<FormulaResidual> formulas;
  for (const ScaleFactor scale : values_of<ScaleFactor>())
    for (const Log2Method log2 : values_of<Log2Method>()) {
      FormulaResidual formula;
      formula.scale_factor = scale;
      formula.log2 = log2;
      formula.is_found = scale == found.scale_factor && log2 == found.log2;
      formulas.push_back(formula);
    }
  return formulas;
}

}  // namespace

LevelResiduals& ResidualTable::row(RampKind kind, LevelSource source) {
  for (LevelResiduals& row : rows_)
    if (row.ramp == name_of(kind) && row.source == source) return row;
  rows_.push_back(
      {name_of(kind), source, name_of(found_.textures.derivatives), formulas_of(found_.textures)});
  return rows_.back();
}

void ResidualTable::add(RampKind kind, const std::string& id, const Scene& scene,
                        const std::vector<FragmentLookup>& lookups) {
  const RampLevels ramp(scene, found_);
  for (const FragmentLookup& lookup : lookups) {
    const Footprint footprint = ramp.exact_footprint(lookup, found_.textures.derivatives);
    for (const LevelSource source : {LevelSource::query, LevelSource::color}) {
      const auto level_reported = ramp.reported(lookup, source);
      if (!level_reported) continue;
      for (FormulaResidual& formula : row(kind, source).formulas) {
        const Interval scale = scale_factor(footprint, formula.scale_factor);
        const double level = middle(ramp.reportable(log2_of(scale, formula.log2), source));
        if (ramp.are_ends(*level_reported, level, source)) continue;
        const double residual = std::fabs(*level_reported - level);
        ++formula.fragments;
        formula.sum += residual;
        // NaN counts as the largest error.
        if (residual <= formula.largest) continue;
        formula.largest = std::isnan(residual) ? HUGE_VAL : residual;
        if (formula.is_found)
          formula.worst =
              ResidualExample{id, scene, lookup.primitive, lookup.pixel, *level_reported, level};
      }
    }
  }
}

}  // namespace edgecase
