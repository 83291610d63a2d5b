// SPDX-License-Identifier: MIT
#include "profile/samples/sample_json.h"

#include <nlohmann/json.hpp>

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const SampleInterval& interval) {
  return {interval.low.to_double(), interval.high.to_double()};
}

Json to_json(const MeasuredPosition& position) {
  Json json = {{"reported", {position.reported.x.to_double(), position.reported.y.to_double()}}};
  if (position.is_measured) {
    json["x"] = to_json(position.x);
    json["y"] = to_json(position.y);
  }
  json["equal"] = position.is_as_reported();
  return json;
}

Json to_json(const MeasuredPositions& found) {
  Json positions = Json::array();
  for (const MeasuredPosition& position : found.positions) positions.push_back(to_json(position));
  return {{"samples", found.samples},
          {"placement", found.placement},
          {"positions", std::move(positions)}};
}

Json to_json(const InvocationRow& row) {
  Json made = Json::array();
  for (const auto& [covered, invocations] : row.invocations)
    for (const auto& [count, pixels] : invocations)
      made.push_back({{"covered", covered}, {"invocations", count}, {"pixels", pixels}});
  return {
      {"asked", row.asked},         {"attribute", row.location},       {"least", row.least},
      {"at_sample", row.at_sample}, {"violation", row.is_violation()}, {"made", std::move(made)},
      {"whole", row.whole},         {"partial", row.partial}};
}

Json to_json(const AlphaRun& run) {
  return {{"first", run.first}, {"last", run.last}, {"mask", run.mask}};
}

template <class Item>
Json list_of(const std::vector<Item>& items) {
  Json json = Json::array();
  for (const Item& item : items) json.push_back(to_json(item));
  return json;
}

}  // namespace

nlohmann::ordered_json sample_profile_json(const SampleProfile& samples) {
  Json counts = Json::array();
  for (const AskedSamples& asked : samples.counts) {
    Json json = {{"samples", asked.samples}, {"made", asked.refusal.empty()}};
    if (!asked.refusal.empty()) json["refusal"] = asked.refusal;
    counts.push_back(std::move(json));
  }
  Json json = {{"counts", std::move(counts)}};
  if (!samples.unavailable.empty()) {
    json["unavailable"] = samples.unavailable;
    return json;
  }
  json["samples"] = samples.samples;
  json["random_scenes"] = samples.random_scenes;
  json["with_ties"] = samples.with_ties;
  json["positions"] = list_of(samples.positions);
  json["invocations"] = list_of(samples.invocations);
  json["alpha_to_coverage"] = list_of(samples.alphas);
  return json;
}

}  // namespace edgecase
