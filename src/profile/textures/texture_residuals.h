// SPDX-License-Identifier: MIT
//
// Level residuals: how far the levels of detail that a renderer tells are from what formulas make
// of the exact texture coordinates.
//
// For every kind of ramp, and both for lambda' as textureQueryLod tells it and for the level that
// ramps look up: the formula that the renderer is found to follow, and beside it all others that
// are catalogued, a scale factor and a logarithm each. Derivatives are the exact coordinates', by
// the method that the renderer is found to follow.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "exact/pixel.h"
#include "model/scene.h"
#include "profile/textures/texture_evidence.h"
#include "profile/textures/texture_levels.h"
#include "profile/textures/texture_scenes.h"
#include "rules/choices.h"

namespace edgecase {

// What a renderer's formula may be off by and still be called its formula: twice the step of a
// level of detail of 8 bits.
constexpr double kMostResidual = 2 * 0x1p-8;

// The fragment that is farthest off.
struct ResidualExample {
  std::string id;  // of the scene that it was found in: "ramp rotated/00003"
  Scene scene;
  int primitive = 0;
  PixelPosition pixel;
  double told = 0;     // levels
  double formula = 0;  // likewise
};

// |told - formula|, in levels.
struct FormulaResidual {
  ScaleFactor scale_factor = ScaleFactor::lengths;
  Log2Method log2 = Log2Method::exact;
  bool is_found = false;  // the renderer is found to follow it
  std::size_t fragments = 0;
  double sum = 0;
  double largest = 0;
  std::optional<ResidualExample> worst;  // of the one found

  double mean() const { return fragments == 0 ? 0 : sum / static_cast<double>(fragments); }
};

struct LevelResiduals {
  RampKind kind = RampKind::axis_aligned;
  LevelSource source = LevelSource::query;
  std::string derivatives;                // the method
  std::vector<FormulaResidual> formulas;  // every scale factor with every logarithm

  const FormulaResidual& found() const;
};

// Counts the residuals of one surface.
class ResidualTable {
 public:
  explicit ResidualTable(const RuleChoices& found) : found_(found) {}

  void add(RampKind kind, const std::string& id, const Scene& scene,
           const std::vector<ToldLookup>& lookups);
  // In the order in which kinds were added; none for what was not told.
  std::vector<LevelResiduals>& rows() { return rows_; }

 private:
  LevelResiduals& row(RampKind kind, LevelSource source);

  RuleChoices found_;
  std::vector<LevelResiduals> rows_;
};

}  // namespace edgecase
