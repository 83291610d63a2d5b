// SPDX-License-Identifier: MIT
#include "profile/textures/texture_json.h"

#include <nlohmann/json.hpp>

#include "casefile/case_writer.h"
#include "model/scene_words.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const ResidualExample& example) {
  Json json = {{"id", example.id},
               {"scene", scene_words(example.scene)},
               {"primitive", example.primitive},
               {"pixel", {example.pixel.x, example.pixel.y}},
               {"told", example.told},
               {"formula", example.formula}};
  const CaseText text = case_text(example.scene, {"",
                                                  "Level of detail",
                                                  "Found by edgecase profile.",
                                                  {name_of(RuleId::texture_log2)},
                                                  "",
                                                  "",
                                                  {}});
  if (text.diagnostics.empty()) json["case"] = Json::parse(text.text);
  return json;
}

Json to_json(const FormulaResidual& formula) {
  Json json = {{"scale_factor", name_of(formula.scale_factor)},
               {"log2", name_of(formula.log2)},
               {"fragments", formula.fragments},
               {"mean", formula.mean()},
               {"largest", formula.largest}};
  if (formula.worst) json["worst"] = to_json(*formula.worst);
  return json;
}

Json to_json(const LevelResiduals& row) {
  Json json = {{"ramp", name_of(row.kind)},
               {"level", row.source == LevelSource::query ? "query" : "color"},
               {"derivatives", row.derivatives},
               {"most", kMostResidual},
               {"within", row.found().largest <= kMostResidual},
               {"found", to_json(row.found())}};
  Json formulas = Json::array();
  for (const FormulaResidual& formula : row.formulas) {
    FormulaResidual plain = formula;
    plain.worst.reset();
    formulas.push_back(to_json(plain));
  }
  json["formulas"] = std::move(formulas);
  return json;
}

}  // namespace

Json level_residuals_json(std::span<const LevelResiduals> rows) {
  Json json = Json::array();
  for (const LevelResiduals& row : rows) json.push_back(to_json(row));
  return json;
}

}  // namespace edgecase
