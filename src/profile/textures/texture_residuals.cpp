// SPDX-License-Identifier: MIT
#include "profile/textures/texture_residuals.h"

#include <algorithm>
#include <cmath>

namespace edgecase {
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

const FormulaResidual& LevelResiduals::found() const {
  return *std::find_if(formulas.begin(), formulas.end(),
                       [](const FormulaResidual& formula) { return formula.is_found; });
}

LevelResiduals& ResidualTable::row(RampKind kind, LevelSource source) {
  for (LevelResiduals& row : rows_)
    if (row.kind == kind && row.source == source) return row;
  rows_.push_back(
      {kind, source, name_of(found_.textures.derivatives), formulas_of(found_.textures)});
  return rows_.back();
}

void ResidualTable::add(RampKind kind, const std::string& id, const Scene& scene,
                        const std::vector<ToldLookup>& lookups) {
  const RampLevels ramp(scene, found_);
  for (const ToldLookup& lookup : lookups) {
    const Footprint footprint = ramp.exact_footprint(lookup, found_.textures.derivatives);
    for (const LevelSource source : {LevelSource::query, LevelSource::color}) {
      const auto told = ramp.told(lookup, source);
      if (!told) continue;
      for (FormulaResidual& formula : row(kind, source).formulas) {
        const Interval scale = scale_factor(footprint, formula.scale_factor);
        const double level = middle(ramp.tellable(log2_of(scale, formula.log2), source));
        if (ramp.are_ends(*told, level, source)) continue;
        const double residual = std::fabs(*told - level);
        ++formula.fragments;
        formula.sum += residual;
        // What is no number is farther off than anything.
        if (residual <= formula.largest) continue;
        formula.largest = std::isnan(residual) ? HUGE_VAL : residual;
        if (formula.is_found)
          formula.worst = ResidualExample{id, scene, lookup.primitive, lookup.pixel, *told, level};
      }
    }
  }
}

}  // namespace edgecase
