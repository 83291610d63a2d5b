// SPDX-License-Identifier: MIT
#include "profile/output/output_json.h"

#include <nlohmann/json.hpp>

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const CodeEvidence& evidence) {
  Json steps = Json::array();
  for (const auto& [distance, step] : evidence.steps)
    steps.push_back({{"from_code_below", distance},
                     {"numbers", step.numbers},
                     {"share_of_step", {step.least, step.largest}}});
  return {{"format", evidence.id},
          {"bits", evidence.bits},
          {"numbers", evidence.numbers},
          {"stored", std::move(steps)}};
}

Json to_json(const MeasuredUnit& unit) {
  Json json = {{"format", name_of(unit.format)}};
  if (unit.format == DepthFormat::depth32f) json["exponent"] = unit.exponent;
  json["depths"] = unit.depths;
  json["unit"] = {unit.least, unit.largest};
  return json;
}

Json to_json(const BlendResidual& residual) {
  Json off = Json::array();
  for (const auto& [difference, values] : residual.off)
    off.push_back({{"by", difference}, {"values", values}});
  return {{"component", residual.is_alpha ? "alpha" : "color"},
          {"equation", name_of(residual.term.equation)},
          {"source", name_of(residual.term.source)},
          {"destination", name_of(residual.term.destination)},
          {"values", residual.values},
          {"off", std::move(off)}};
}

template <class Item>
Json list_of(const std::vector<Item>& items) {
  Json json = Json::array();
  for (const Item& item : items) json.push_back(to_json(item));
  return json;
}

}  // namespace

nlohmann::ordered_json output_profile_json(const OutputProfile& output) {
  return {{"random_scenes", output.random_scenes},
          {"codes", list_of(output.codes)},
          {"offset_units", list_of(output.units)},
          {"blending", list_of(output.blending)}};
}

}  // namespace edgecase
