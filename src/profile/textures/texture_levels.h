// SPDX-License-Identifier: MIT
//
// Levels of detail by formula: what each catalogued scale factor, logarithm and derivative makes of
// a fragment of a ramp.
#pragma once

#include <optional>
#include <vector>

#include "exact/interval.h"
#include "model/scene.h"
#include "profile/textures/texture_evidence.h"
#include "raster/attributes.h"
#include "rules/choices.h"

namespace edgecase {

// A level of detail that a renderer told of a fragment, and how it came about.
enum class LevelSource {
  query,  // textureQueryLod: lambda'
  color,  // the level that was looked up, within the levels that there are
};
const char* name_of(LevelSource source);

// One ramp: a draw, one texture.
class RampLevels {
 public:
  // `scene` must outlive it.
  RampLevels(const Scene& scene, const RuleChoices& found);

  // The footprint of a pixel, its derivatives exactly so, or as float32 may have them.
  Footprint exact_footprint(const ToldLookup& lookup, DerivativeMethod method) const;
  Footprint rounded_footprint(const ToldLookup& lookup, DerivativeMethod method) const;

  // What the renderer told; none where it told nothing.
  std::optional<double> told(const ToldLookup& lookup, LevelSource source) const;
  // What is told of a lambda_base.
  Interval tellable(Interval lambda_base, LevelSource source) const;
  // Are both the same end of the levels that there are, so that neither says how far beyond it is?
  bool are_ends(double a, double b, LevelSource source) const;

 private:
  template <class Derivative>
  Footprint footprint_by(const Derivative& derivative) const;

  const Scene& scene_;
  const RuleChoices& found_;
  std::vector<PrimitiveAttributes> attributes_;
  double last_ = 0;
};

}  // namespace edgecase
