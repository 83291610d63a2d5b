// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "profile/tally.h"
#include "profile/textures/texture_levels.h"
#include "profile/textures/texture_traits.h"

namespace edgecase {
namespace {

// All combinations, by the indices of their parts.
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

// Of one lookup, which combinations yield it.
using Yields = std::vector<bool>;

bool yields_level(const RampLevels& ramp, Interval scale, Log2Method log2, double told,
                  LevelSource source) {
  const Interval lambda = log2_of(widened(scale, kScaleError), log2);
  const Interval level =
      ramp.tellable({lambda.low - kLevelError, lambda.high + kLevelError}, source);
  const double slack = source == LevelSource::color ? kLevelError : 0;
  return told >= level.low - slack && told <= level.high + slack;
}

Yields yields_of(const RampLevels& ramp, const ToldLookup& lookup, LevelSource source,
                 double told) {
  Yields yields(combination_count());
  for (std::size_t d = 0; d < values_of<DerivativeMethod>().size(); ++d) {
    const Footprint footprint = ramp.rounded_footprint(lookup, values_of<DerivativeMethod>()[d]);
    for (std::size_t s = 0; s < values_of<ScaleFactor>().size(); ++s) {
      const Interval scale = scale_factor(footprint, values_of<ScaleFactor>()[s]);
      for (std::size_t l = 0; l < values_of<Log2Method>().size(); ++l)
        yields[Combination{s, l, d}.index()] =
            yields_level(ramp, scale, values_of<Log2Method>()[l], told, source);
    }
  }
  return yields;
}

std::vector<Yields> all_yields(std::span<const ToldScene> ramps, const RuleChoices& found) {
  std::vector<Yields> result;
  for (const ToldScene& told : ramps) {
    const RampLevels ramp(told.scene, found);
    for (const ToldLookup& lookup : told.lookups)
      for (const LevelSource source : {LevelSource::query, LevelSource::color})
        if (const auto level = ramp.told(lookup, source))
          result.push_back(yields_of(ramp, lookup, source, *level));
  }
  return result;
}

// The catalogue's own comes first where several do as well.
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

// One rule, the two others as the best combination has them.
template <class Values>
Trait trait_of(const char* id, const Values& values, std::size_t Combination::*part,
               const Combination& best, std::size_t standard, const std::vector<Yields>& all) {
  std::vector<std::string> names;
  for (const auto value : values) names.push_back(name_of(value));
  Tally tally(std::move(names), standard);
  for (const Yields& yields : all) {
    std::vector<bool> agree;
    for (std::size_t i = 0; i < values.size(); ++i) {
      Combination other = best;
      other.*part = i;
      agree.push_back(yields[other.index()]);
    }
    tally.add(agree);
  }
  return tally.trait(id);
}

}  // namespace

std::vector<Trait> infer_level_of_detail(std::span<const ToldScene> ramps,
                                         const RuleChoices& found) {
  const std::vector<Yields> all = all_yields(ramps, found);
  const Combination best = best_of(all);
  return {trait_of(name_of(RuleId::texture_scale_factor), values_of<ScaleFactor>(),
                   &Combination::scale_factor, best, best.scale_factor, all),
          trait_of(name_of(RuleId::texture_log2), values_of<Log2Method>(), &Combination::log2, best,
                   best.log2, all),
          trait_of(name_of(RuleId::texture_derivatives), values_of<DerivativeMethod>(),
                   &Combination::derivatives, best, best.derivatives, all)};
}

}  // namespace edgecase
