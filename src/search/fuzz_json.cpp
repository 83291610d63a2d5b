// SPDX-License-Identifier: MIT
#include "search/fuzz_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <exception>
#include <stdexcept>
#include <utility>

#include "model/names.h"
#include "results/shallow_json.h"
#include "rules/all_rules.h"
#include "search/find_file.h"
#include "search/scene_size.h"
#include "search/trial.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

// The texts of a signature, with their names in JSON.
constexpr std::pair<const char*, std::string Signature::*> kWords[] = {
    {"cause", &Signature::cause},         {"rule", &Signature::rule},
    {"kind", &Signature::kind},           {"surface", &Signature::surface},
    {"situation", &Signature::situation}, {"attribute", &Signature::attribute},
    {"failure", &Signature::failure}};

Json signature_json(const Signature& signature) {
  Json json = Json::object();
  for (const auto& [name, member] : kWords)
    if (!(signature.*member).empty()) json[name] = signature.*member;
  json["legality"] = edgecase::name_of(signature.legality);
  return json;
}

Json find_json(const Find& find, std::uint64_t seed, const std::string& path) {
  const SceneSize size = size_of(find.scene);
  Json answers = Json::object();
  for (const FindAnswer& answer : find.answers) answers[answer.renderer] = answer.words;
  Json json = {{"renderer", find.renderer},
               {"verdict", edgecase::name_of(find.verdict)},
               {"title", title_of(find)},
               {"rule", rule_of(find)},
               {"signature", signature_json(find.key.signature)},
               {"geometry", find.key.geometry},
               {"primitives", size.primitives},
               {"target", {find.scene.target.width, find.scene.target.height}},
               {"bits", size.fraction_bits},
               {"least_bits", find.least_bits},
               {"scenes", find.scenes},
               {"asks", find.asks},
               {"minimized", name_of(find.end)},
               {"origin", describe(find.origin, seed)},
               {"answers", std::move(answers)}};
  if (!path.empty()) json["file"] = path;
  const FindFile file = find_file(find, seed, "");
  if (file.diagnostics.empty()) json["case"] = Json::parse(file.text);
  return json;
}

FindKey key_from(const nlohmann::json& find) {
  FindKey key;
  const nlohmann::json& signature = find.at("signature");
  for (const auto& [name, member] : kWords)
    if (signature.contains(name)) key.signature.*member = signature.at(name).get<std::string>();
  const auto legality = signature.at("legality").get<std::string>();
  if (!parse_name(legality, key.signature.legality))
    throw std::runtime_error(fmt::format("\"{}\" is no legality", legality));
  key.geometry = find.at("geometry").get<std::string>();
  return key;
}

}  // namespace

std::string fuzz_json(const FuzzReport& report, const FuzzWords& words) {
  Json renderers = Json::array();
  for (std::size_t r = 0; r < report.renderers.size(); ++r) {
    const FuzzedRenderer& renderer = report.renderers[r];
    renderers.push_back({{"name", words.renderers.at(r)},
                         {"version", renderer.info.version},
                         {"drawn", renderer.drawn},
                         {"not_drawn", renderer.not_drawn},
                         {"known", renderer.known}});
    if (renderer.failure) renderers.back()["first_failure"] = renderer.failure->reason;
  }
  Json families = Json::object();
  for (const auto& [name, scenes] : report.by_family) families[name] = scenes;
  Json finds = Json::array();
  for (std::size_t i = 0; i < report.finds.size(); ++i)
    finds.push_back(
        find_json(report.finds[i], words.seed, i < words.files.size() ? words.files[i] : ""));
  const Json json = {{"tool", words.tool},
                     {"policy", words.policy},
                     {"seed", words.seed},
                     {"scenes", report.scenes},
                     {"families", std::move(families)},
                     {"renderers", std::move(renderers)},
                     {"finds", std::move(finds)}};
  // Renderer names come from the command line: bytes that are not UTF-8 are replaced, never fatal.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::variant<KnownKeys, std::string> read_known_finds(const std::string& text) {
  try {
    KnownKeys known;
    const nlohmann::json json = parse_shallow(text);
    for (const nlohmann::json& find : json.at("finds"))
      known[find.at("renderer").get<std::string>()].push_back(key_from(find));
    return known;
  } catch (const std::exception& error) {
    return fmt::format("no finds of `edgecase fuzz --json` ({})", error.what());
  }
}

}  // namespace edgecase
