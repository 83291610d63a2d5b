// SPDX-License-Identifier: MIT
#include "profile/profile_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "casefile/case_writer.h"
#include "model/scene_words.h"
#include "profile/output/output_json.h"
#include "profile/profile_text.h"
#include "profile/samples/sample_json.h"
#include "profile/textures/texture_json.h"
#include "profile/values/value_json.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Rate& rate) {
  return {{"agreeing", rate.agreeing}, {"of", rate.of}};
}

Json to_json(const Trait& trait) {
  Json json = {
      {"id", trait.id}, {"follows", trait.alternative}, {"agreement", to_json(trait.rate)}};
  if (!trait.runner_up.empty()) {
    json["runner_up"] = trait.runner_up;
    json["runner_up_agreement"] = to_json(trait.runner_up_rate);
  }
  if (!trait.remark.empty()) json["remark"] = trait.remark;
  return json;
}

Json to_json(const OwnershipTable& table) {
  Json cells = Json::array();
  for (const auto& row : table.cells) {
    Json line = Json::array();
    for (const OwnershipTable::Cell& cell : row) line.push_back({cell.drawn, cell.of});
    cells.push_back(std::move(line));
  }
  return {{"title", table.title},
          {"rows", table.rows},
          {"columns", table.columns},
          {"drawn_of", std::move(cells)}};
}

// The rules that a cluster is about, for the case file of its smallest scene.
std::vector<std::string> rules_of(const Cluster& cluster) {
  if (!cluster.rule.empty()) return {cluster.rule};
  return {cluster.cause.substr(0, cluster.cause.find('='))};
}

Json to_json(const ProfileCluster& found) {
  const Cluster& cluster = found.cluster;
  Json json = {{"title", title_of(cluster)},
               {"rule", cluster.rule},
               {"kind", cluster.kind},
               {"legality", name_of(cluster.legality)},
               {"cause", cluster.cause},
               {"situation", cluster.situation},
               {"disagreements", cluster.disagreements},
               {"scenes", cluster.cases},
               {"smallest", scene_words(found.smallest)},
               {"pixel", {cluster.x, cluster.y}}};
  const CaseText text = case_text(
      found.smallest,
      {"", title_of(cluster), "Found by edgecase profile.", rules_of(cluster), "", "", {}});
  if (text.diagnostics.empty()) json["case"] = Json::parse(text.text);
  return json;
}

Json to_json(const SurfaceProfile& surface);

template <class Item>
Json list_of(const std::vector<Item>& items) {
  Json json = Json::array();
  for (const Item& item : items) json.push_back(to_json(item));
  return json;
}

Json to_json(const SurfaceProfile& surface) {
  Json json = {{"surface", name_of(surface.surface)}};
  if (!surface.unavailable.empty()) {
    json["unavailable"] = surface.unavailable;
    return json;
  }
  json["scenes"] = surface.scenes;
  json["not_drawn"] = surface.not_drawn;
  if (surface.not_drawn > 0) json["first_failure"] = surface.first_failure;
  json["random_scenes"] = surface.random_scenes;
  json["with_ties"] = surface.with_ties;
  json["illegal_scenes"] = surface.illegal_scenes;
  json["traits"] = list_of(surface.traits);
  json["tables"] = list_of(surface.tables);
  json["values"] = value_errors_json(surface.values);
  json["levels_of_detail"] = level_residuals_json(surface.levels);
  json["samples"] = sample_profile_json(surface.samples);
  json["output"] = output_profile_json(surface.output);
  json["clusters"] = list_of(surface.clusters);
  return json;
}

// A policy has one alternative of a rule. What a renderer does otherwise where the rule is asked in
// another way: " Of texture.nearest-level:lod it follows even-at-ties."; empty: nothing.
std::string other_ways_of(const SurfaceProfile& surface) {
  std::string text;
  for (const Trait& trait : surface.traits) {
    const std::size_t colon = trait.id.find(':');
    if (colon == std::string::npos || trait.rate.of == 0) continue;
    const std::string rule = trait.id.substr(0, colon);
    const auto main = std::ranges::find(surface.traits, rule, &Trait::id);
    if (main != surface.traits.end() && main->alternative != trait.alternative &&
        !trait.is_undecided())
      text += fmt::format(" Of {} it follows {}.", trait.id, trait.alternative);
  }
  return text;
}

// "fbo: triangle.snap 100 %, line.snap 98.20 %; window: …"
std::string why_of(const Profile& profile) {
  std::vector<std::string> surfaces;
  std::string other_ways;
  for (const SurfaceProfile& surface : profile.surfaces) {
    if (!surface.unavailable.empty()) continue;
    if (other_ways.empty()) other_ways = other_ways_of(surface);
    std::vector<std::string> rates;
    for (const Trait& trait : surface.traits)
      if (trait.id.ends_with(".snap") || trait.id == name_of(RuleId::line_width))
        rates.push_back(
            fmt::format("{} {}", trait.id.substr(0, trait.id.find(".snap")), percent(trait.rate)));
    surfaces.push_back(fmt::format("{}: {}", name_of(surface.surface), fmt::join(rates, ", ")));
  }
  return fmt::format(
      "Measured by edgecase profile with {} random scenes of each primitive type on each surface, "
      "seed {}. Scenes that agree with it wholly: {}.{}",
      profile.scenes_per_kind, profile.seed, fmt::join(surfaces, "; "), other_ways);
}

Json to_json(const Policy& policy, const std::string& why) {
  Json json = {
      {"name", policy.name}, {"why", why}, {"latitude", "opengl"}, {"rules", policy.rules}};
  for (const auto& [surface, choices] : policy.surfaces)
    json["surfaces"][name_of(surface)] = choices;
  return json;
}

// Names and messages may hold bytes that are no UTF-8; they are replaced, never fatal.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string profile_json(const Profile& profile, const std::string& tool) {
  const RendererInfo& info = profile.renderer;
  const Json json = {{"tool", tool},
                     {"renderer",
                      {{"name", info.name},
                       {"vendor", info.vendor},
                       {"version", info.version},
                       {"device", info.device},
                       {"subpixel_bits", info.subpixel_bits}}},
                     {"seed", profile.seed},
                     {"scenes_per_kind", profile.scenes_per_kind},
                     {"policy", to_json(profile.policy, why_of(profile))},
                     {"surfaces", list_of(profile.surfaces)}};
  return text_of(json);
}

std::string policy_text(const Profile& profile) {
  return text_of(to_json(profile.policy, why_of(profile)));
}

}  // namespace edgecase
