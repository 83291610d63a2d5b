// SPDX-License-Identifier: MIT
#include "profile/values/value_json.h"

#include <nlohmann/json.hpp>

#include "casefile/case_writer.h"
#include "model/scene_words.h"
#include "profile/values/value_text.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

const char* rule_of(ValueKind kind) {
  if (kind == ValueKind::depth) return name_of(RuleId::fragment_depth);
  return kind == ValueKind::inverse_w ? name_of(RuleId::fragment_coordinates)
                                      : name_of(RuleId::attribute_smooth);
}

Json to_json(const ValueExample& example, const ValueErrors& row) {
  Json json = {{"id", example.id},
               {"scene", scene_words(example.scene)},
               {"primitive", example.primitive},
               {"pixel", {example.pixel.x, example.pixel.y}},
               {"component", component_name(row.kind, example.component)},
               {"exact", example.exact},
               {"rendered", example.rendered},
               {"ulp", example.ulp},
               {"of_range", example.relative}};
  if (example.permitted) json["permitted"] = {example.permitted->low, example.permitted->high};
  const CaseText text =
      case_text(example.scene,
                {"", row.attribute, "Found by edgecase profile.", {rule_of(row.kind)}, "", "", {}});
  if (text.diagnostics.empty()) json["case"] = Json::parse(text.text);
  return json;
}

Json to_json(const ValueErrors& row) {
  Json json = {{"attribute", row.attribute},       {"against", row.as_found ? "profile" : "opengl"},
               {"fragments", row.fragments},       {"components", row.components},
               {"correctly_rounded", row.correct}, {"not_numbers", row.not_numbers},
               {"mean_ulp", row.mean_ulp()}};
  Json histogram = Json::object();
  for (const auto& [exponent, count] : row.histogram) histogram[std::to_string(exponent)] = count;
  json["log2_ulp"] = std::move(histogram);
  if (!row.as_found) {
    json["beyond"] = row.beyond;
    json["beyond_not_asked"] = row.not_asked;
  }
  if (row.worst_ulp) json["largest_ulp"] = to_json(*row.worst_ulp, row);
  if (row.worst_relative) json["largest_of_range"] = to_json(*row.worst_relative, row);
  if (row.smallest_beyond) json["smallest_beyond"] = to_json(*row.smallest_beyond, row);
  return json;
}

}  // namespace

Json value_errors_json(std::span<const ValueErrors> rows) {
  Json json = Json::array();
  for (const ValueErrors& row : rows) json.push_back(to_json(row));
  return json;
}

}  // namespace edgecase
