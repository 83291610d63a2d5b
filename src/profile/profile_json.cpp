// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "casefile/case_writer.h"
#include "model/scene.h"
#include "profile/profile.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

// Adds the text of a case file of the scene, if a case file can express it.
void add_case(Json& json, const Scene& scene, const std::string& title,
              const std::vector<std::string>& rules) {
  const CaseText text =
      case_text(scene, {"", title, "Found by edgecase profile.", rules, "", "", {}});
  if (text.diagnostics.empty()) json["case"] = Json::parse(text.text);
}

const char* rule_of(ValueKind kind) {
  switch (kind) {
    case ValueKind::color:
      break;
    case ValueKind::depth:
      return name_of(RuleId::fragment_depth);
    case ValueKind::inverse_w:
      return name_of(RuleId::fragment_coordinates);
  }
  return name_of(RuleId::attribute_smooth);
}

Json to_json(const ValueExample& example, const ValueErrors& row) {
  Json json = {{"id", example.id},
               {"scene", scene_text(example.scene)},
               {"primitive", example.primitive},
               {"pixel", {example.pixel.x, example.pixel.y}},
               {"component", component_name(row.kind, example.component)},
               {"exact", example.exact},
               {"rendered", example.rendered},
               {"ulp", example.ulp},
               {"of_range", example.relative}};
  if (example.permitted) json["permitted"] = {example.permitted->low, example.permitted->high};
  add_case(json, example.scene, row.attribute, {rule_of(row.kind)});
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

Json to_json(const ResidualExample& example) {
  Json json = {{"id", example.id},
               {"scene", scene_text(example.scene)},
               {"primitive", example.primitive},
               {"pixel", {example.pixel.x, example.pixel.y}},
               {"told", example.reported},
               {"formula", example.formula}};
  add_case(json, example.scene, "Level of detail", {name_of(RuleId::texture_log2)});
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
  Json json = {{"ramp", row.ramp},
               {"level", name_of(row.source)},
               {"derivatives", row.derivatives},
               {"most", kMostResidual},
               {"within", row.found().largest <= kMostResidual},
               {"found", to_json(row.found())}};
  for (FormulaResidual formula : row.formulas) {
    formula.worst.reset();
    json["formulas"].push_back(to_json(formula));
  }
  return json;
}

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
  if (holds_floats(unit.format)) json["exponent"] = unit.exponent;
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

Json to_json(const Rate& rate) {
  return {{"agreeing", rate.agreeing}, {"of", rate.of}};
}

Json to_json(const Trait& trait) {
  Json json = {{"id", text_of(trait.id)},
               {"follows", trait.alternative},
               {"agreement", to_json(trait.rate)}};
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

// The rules of a cluster, for the case file of its smallest scene.
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
               {"situations", cluster.situations},
               {"disagreements", cluster.disagreements},
               {"scenes", cluster.cases},
               {"smallest", scene_text(found.smallest)},
               {"pixel", {cluster.x, cluster.y}}};
  add_case(json, found.smallest, title_of(cluster), rules_of(cluster));
  return json;
}

Json to_json(const SurfaceProfile& surface);

// An array with the JSON of each item.
template <class Items>
Json list_of(const Items& items) {
  Json json = Json::array();
  for (const auto& item : items) json.push_back(to_json(item));
  return json;
}

}  // namespace

nlohmann::ordered_json value_errors_json(std::span<const ValueErrors> rows) {
  return list_of(rows);
}

nlohmann::ordered_json level_residuals_json(std::span<const LevelResiduals> rows) {
  return list_of(rows);
}

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

nlohmann::ordered_json output_profile_json(const OutputProfile& output) {
  return {{"random_scenes", output.random_scenes},
          {"codes", list_of(output.codes)},
          {"offset_units", list_of(output.units)},
          {"blending", list_of(output.blending)}};
}

namespace {

Json to_json(const SurfaceProfile& surface) {
  Json json = {{"surface", name_of(surface.surface)}};
  if (!surface.unavailable.empty()) {
    json["unavailable"] = surface.unavailable;
    return json;
  }
  const SurfaceFindings& findings = surface.findings;
  json["scenes"] = findings.drawn.scenes;
  json["not_drawn"] = findings.drawn.not_drawn;
  if (findings.drawn.not_drawn > 0) json["first_failure"] = findings.drawn.first_failure;
  json["random_scenes"] = findings.random_scenes;
  json["with_ties"] = findings.with_ties;
  json["illegal_scenes"] = surface.illegal_scenes;
  json["traits"] = list_of(findings.traits);
  json["tables"] = list_of(findings.tables);
  json["values"] = value_errors_json(findings.values);
  json["levels_of_detail"] = level_residuals_json(findings.levels);
  json["samples"] = sample_profile_json(findings.samples);
  json["output"] = output_profile_json(findings.output);
  json["clusters"] = list_of(surface.clusters);
  return json;
}

// If a rule is probed in another way, a renderer may follow another alternative than the policy's:
// " Of texture.nearest-level:lod it follows even-at-ties."; empty if it does not.
std::string other_ways_of(const std::vector<Trait>& traits) {
  std::string text;
  for (const Trait& trait : traits) {
    if (trait.id.rule == RuleId::none || trait.id.is_rule() || trait.rate.of == 0) continue;
    const auto main = std::ranges::find(traits, TraitId(trait.id.rule), &Trait::id);
    if (main != traits.end() && main->alternative != trait.alternative && !trait.is_undecided())
      text += fmt::format(" Of {} it follows {}.", text_of(trait.id), trait.alternative);
  }
  return text;
}

// "line" of line.snap, "line.width"; empty: its rate is omitted.
std::string rate_name_of(const TraitId& id) {
  switch (id.is_rule() ? id.rule : RuleId::none) {
    case RuleId::point_snap:
    case RuleId::line_snap:
    case RuleId::triangle_snap:
      return std::string(name_of(id.rule), std::string_view(name_of(id.rule)).find('.'));
    case RuleId::line_width:
      return name_of(id.rule);
    default:
      return "";
  }
}

// "fbo: triangle.snap 100 %, line.snap 98.20 %; window: …"
std::string why_of(const Profile& profile) {
  std::vector<std::string> surfaces;
  std::string other_ways;
  for (const SurfaceProfile& surface : profile.surfaces) {
    if (!surface.unavailable.empty()) continue;
    if (other_ways.empty()) other_ways = other_ways_of(surface.findings.traits);
    std::vector<std::string> rates;
    for (const Trait& trait : surface.findings.traits)
      if (const std::string name = rate_name_of(trait.id); !name.empty())
        rates.push_back(fmt::format("{} {}", name, percent(trait.rate)));
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

// Bytes of names and messages that are not UTF-8 are replaced, never fatal.
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
