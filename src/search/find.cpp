// SPDX-License-Identifier: MIT
#include "search/find.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "casefile/case_writer.h"
#include "casefile/json/text.h"
#include "diff/verdicts.h"
#include "results/shallow_json.h"
#include "rules/all_rules.h"
#include "search/fuzz.h"
#include "search/minimize.h"
#include "search/scene_size.h"

namespace edgecase {
namespace {

std::string shape_of(const ScenePrimitive& primitive) {
  const Fixed one = Fixed::from_integer(1);
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return primitive.state->point_size == one ? "point" : "large point";
    case PrimitiveKind::line:
      return primitive.state->line_width == one ? "line" : "wide line";
    case PrimitiveKind::triangle:
      break;
  }
  return "triangle";
}

// The geometry of each primitive of a scene, and of a whole pixel.
class Geometry {
 public:
  explicit Geometry(const Scene& scene) {
    if (scene.target.samples > 1) samples_ = fmt::format(", {} samples", scene.target.samples);
    for (const ScenePrimitive& primitive : primitives_of(scene))
      shapes_.push_back(shape_of(primitive));
  }
  std::string of(int primitive) const {
    const bool is_one = primitive >= 0 && primitive < static_cast<int>(shapes_.size());
    return (is_one ? shapes_[static_cast<std::size_t>(primitive)] : "whole pixel") + samples_;
  }

 private:
  std::string samples_;
  std::vector<std::string> shapes_;
};

}  // namespace

std::vector<Shown> shown_by(const Scene& scene, const Result& result, Latitude latitude) {
  const Surface surface = scene.target.surface;
  if (result.failure) {
    std::vector<Shown> shown;
    for (Signature& signature : signatures_of(result, surface))
      shown.push_back({{std::move(signature), "scene"}, Verdict::not_run});
    return shown;
  }
  const Geometry geometry(scene);
  std::map<FindKey, Verdict> found;
  const auto add = [&](Signature signature, int primitive, Verdict verdict) {
    Verdict& worst = found[{std::move(signature), geometry.of(primitive)}];
    worst = std::max(worst, verdict);
  };
  // Those that are only counted show nothing that those in full do not.
  for (const Disagreement& d : result.disagreements)
    add(signature_of(d, surface), d.primitive, verdict_of(d, latitude));
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty())
      add(signature_of(values, surface), values.worst.primitive, verdict_of(values, latitude));
  std::vector<Shown> shown;
  for (auto& [key, verdict] : found) shown.push_back({key, verdict});
  std::ranges::stable_sort(shown, std::greater<>(), &Shown::verdict);
  return shown;
}

std::string describe(const Result& result) {
  constexpr std::size_t kMost = 4;  // pixels that are listed
  std::string words = name_of(result.verdict);
  if (result.failure) return fmt::format("{}, {}", words, result.failure->reason);
  const std::size_t count = count_disagreements(result);
  for (std::size_t i = 0; i < std::min(result.disagreements.size(), kMost); ++i) {
    const Disagreement& d = result.disagreements[i];
    words += fmt::format(", {} ({}, {})", name_of(d.kind), d.x, d.y);
  }
  if (count > kMost) words += fmt::format(" and {} more", count - kMost);
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty())
      words += fmt::format(", {} of {} fragments", values.attribute, values.differing.size());
  return words;
}

std::string title_of(const Find& find) {
  return fmt::format("{} ({})", title_of(find.key.signature), find.key.geometry);
}

namespace {

// The disagreement that represents the find; null for values and failures.
const Disagreement* first_disagreement(const Find& find) {
  Surface surface = Surface::fbo;
  parse_name(find.key.signature.surface, surface);
  for (const Disagreement& d : find.result.disagreements)
    if (signature_of(d, surface) == find.key.signature) return &d;
  return nullptr;
}

}  // namespace

std::string rule_of(const Find& find) {
  if (!find.key.signature.rule.empty()) return find.key.signature.rule;
  if (const Disagreement* d = first_disagreement(find)) return name_of(d->rule);
  for (const ValueAggregate& values : find.result.values)
    if (text_of(values.cause) == find.key.signature.cause) return name_of(values.rule);
  return name_of(RuleId::fragment_once);
}

// -------------------------------------------------------------------------------------- case files

namespace {

constexpr std::size_t kMostWords = 500;  // bytes of a renderer's text in one answer

// FNV-1a, 32 bits.
std::uint32_t hash_of(std::string_view text) {
  std::uint32_t hash = 0x811c9dc5u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193u;
  return hash;
}

std::string sentence_of_end(const Find& find) {
  switch (find.end) {
    case MinimizeEnd::finished:
      return "No smaller scene was found that shows it.";
    case MinimizeEnd::exhausted:
      return "Smaller scenes that show it may exist.";
    case MinimizeEnd::stopped:
      return "The search for a smaller scene was interrupted.";
    case MinimizeEnd::not_reproduced:
      return "The renderer did not show it again.";
  }
  return "";
}

// Why its coordinates are as fine as they are, if that is known.
std::string sentence_of_bits(const Find& find) {
  if (find.least_bits <= kReadableBits) return "";
  return fmt::format(
      " With fewer than {} fraction bits its vertices lie on both grids, that of the policy and "
      "that of the cause, and neither moves them.",
      find.least_bits);
}

std::string explanation_of(const Find& find) {
  if (find.result.failure)
    return fmt::format("The renderer fails: {}.", text_for_file(find.result.failure->reason));
  const Disagreement* d = first_disagreement(find);
  if (d == nullptr)
    return fmt::format("Its {} differs inside what is permitted.", find.key.signature.attribute);
  return fmt::format("Pixel ({}, {}): {}", d->x, d->y, d->explanation);
}

std::string judgement_of(const Find& find) {
  const Signature& signature = find.key.signature;
  std::string text = find.result.failure                     ? ""
                     : signature.legality == Legality::legal ? "The specification allows it"
                     : signature.legality == Legality::contested
                         ? "The wording of the specification forbids it, which is contested"
                         : "The specification does not allow it";
  if (!signature.cause.empty()) text += "; cause: " + signature.cause;
  if (!signature.situation.empty()) text += "; situation: " + signature.situation;
  return text.empty() ? text : text + ". ";
}

std::string why_of(const Find& find, std::uint64_t seed) {
  std::string why = explanation_of(find) + " " + judgement_of(find);
  for (const FindAnswer& answer : find.answers)
    why += fmt::format("{}: {}. ", text_for_file(answer.renderer), text_for_file(answer.words));
  return why + fmt::format("Found by edgecase fuzz: {}. {}{}", describe(find.origin, seed),
                           sentence_of_end(find), sentence_of_bits(find));
}

}  // namespace

std::string text_for_file(const std::string& words) {
  return std::string(beginning_of(clean_line(words), kMostWords));
}

FindFile find_file(const Find& find, std::uint64_t seed, const std::string& schema) {
  const std::string rule = rule_of(find);
  CaseWords words;
  words.title =
      beginning_of(fmt::format("{}: {}", text_for_file(find.renderer), title_of(find)), kMostTitle);
  words.rules = {rule};
  const CaseText plain = case_text(find.scene, words);
  FindFile file;
  file.name = fmt::format("{}-{:08x}.json", rule, hash_of(plain.text));
  words.schema = schema;
  words.why = why_of(find, seed);
  if (const Rule* known = find_rule(rule)) words.spec = "GL 4.6 core, " + known->spec;
  words.tags = {"fuzz", find.origin.family};
  CaseText text = case_text(find.scene, words);
  file.text = std::move(text.text);
  file.diagnostics = std::move(text.diagnostics);
  return file;
}

// ----------------------------------------------------------------------------------------- reports

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
