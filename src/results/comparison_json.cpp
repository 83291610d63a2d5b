// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "results/comparison.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

Json facts_json(const std::vector<FactChange>& facts) {
  Json list = Json::array();
  for (const FactChange& fact : facts)
    list.push_back({{"what", fact.what}, {"before", fact.before}, {"after", fact.after}});
  return list;
}

Json answer_json(const Judgement& answer) {
  return {{"verdict", name_of(answer.verdict)}, {"fingerprint", answer.fingerprint}};
}

Json case_json(const CaseChange& one) {
  Json json = {{"id", one.id}, {"change", name_of(one.change)}};
  if (one.before) json["before"] = answer_json(*one.before);
  if (one.after) json["after"] = answer_json(*one.after);
  return json;
}

Json cluster_json(const ChangeCluster& cluster) {
  return {{"change", name_of(cluster.change)},
          {"rule", cluster.rule},
          {"cause", cluster.cause},
          {"cases", cluster.cases},
          {"disagreements", cluster.disagreements},
          {"first_case", cluster.first_case}};
}

Json renderer_json(const RendererComparison& renderer) {
  Json counts = Json::object();
  for (const auto& [change, count] : renderer.counts) counts[name_of(change)] = count;
  Json clusters = Json::array();
  for (const ChangeCluster& cluster : renderer.clusters) clusters.push_back(cluster_json(cluster));
  Json cases = Json::array();
  for (const CaseChange& one : renderer.cases) cases.push_back(case_json(one));
  return {{"before", renderer.before},
          {"after", renderer.after},
          {"facts", facts_json(renderer.facts)},
          {"same", renderer.same},
          {"counts", std::move(counts)},
          {"clusters", std::move(clusters)},
          {"cases", std::move(cases)}};
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
  Json renderers = Json::array();
  for (const RendererComparison& renderer : comparison.renderers)
    renderers.push_back(renderer_json(renderer));
  const Json json = {{"edgecase_comparison", 1},
                     {"facts", facts_json(comparison.facts)},
                     {"renderers", std::move(renderers)},
                     {"only_before", comparison.only_before},
                     {"only_after", comparison.only_after}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace edgecase
