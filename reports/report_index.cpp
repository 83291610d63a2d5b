// SPDX-License-Identifier: MIT
#include "reports/report_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/threads.h"
#include "reports/case_details.h"
#include "reports/text.h"
#include "reports/verdict_looks.h"
#include "results/clusters.h"
#include "results/standing.h"
#include "results/worst_first.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kScenes = "scenes/";  // ids of cases that draw whole scenes

// Numbers distinct texts in the order in which they are added.
class Names {
 public:
  std::size_t number(const std::string& name) {
    const auto [found, is_new] = numbers_.try_emplace(name, list_.size());
    if (is_new) list_.push_back(name);
    return found->second;
  }
  const Json& list() const { return list_; }

 private:
  std::map<std::string, std::size_t> numbers_;
  Json list_ = Json::array();
};

// Rule -> the worst verdict under it in one answer.
using Findings = std::map<std::string, Verdict>;

class FindingsOf {
 public:
  FindingsOf(Latitude latitude, const ReportTexts& texts) : latitude_(latitude), texts_(&texts) {}

  Findings operator()(const Result& result) const {
    Findings found;
    for_each_class(result, [&](const DisagreementClass& d) {
      add(found, name_of(d.rule), verdict(d.legality, d.cause));
    });
    for (const ValueAggregate& values : result.values)
      if (!values.differing.empty())
        add(found, name_of(values.rule), verdict(Legality::legal, values.cause));
    return found;
  }

 private:
  static void add(Findings& found, const std::string& rule, Verdict verdict) {
    Verdict& worst = found[rule];
    worst = std::max(worst, verdict);
  }

  Verdict verdict(Legality legality, const Cause& cause) const {
    const bool is_open = !cause.empty() && texts_->is_open_choice && texts_->is_open_choice(cause);
    return verdict_of(legality, is_open, latitude_);
  }

  Latitude latitude_;
  const ReportTexts* texts_;
};

Json head_json(const CaseResults& one, Names& rules, long line) {
  Json json = {{"stem", stem_of(one.id)}, {"title", one.title},  {"why", one.why},
               {"rules", Json::array()},  {"spec", one.spec},    {"origin", one.origin},
               {"tags", one.tags},        {"file", one.file},    {"surface", one.surface},
               {"width", one.width},      {"height", one.height}};
  for (const std::string& rule : one.rules) json["rules"].push_back(rules.number(rule));
  if (line >= 0) json["source"] = line;
  return json;
}

// What the answer of a renderer comes to in the list.
struct Outcome {
  Verdict verdict = Verdict::agree;
  Standing standing = Standing::expected;
  Findings findings;
  friend auto operator<=>(const Outcome&, const Outcome&) = default;
};

Json outcome_json(const Outcome& outcome, Names& rules) {
  Json found = Json::array();
  for (const auto& [rule, verdict] : outcome.findings) {
    found.push_back(rules.number(rule));
    found.push_back(name_of(verdict));
  }
  return Json::array({name_of(outcome.verdict), name_of(outcome.standing), std::move(found)});
}

// The distinct outcomes of cases.
class Outcomes {
 public:
  std::size_t number(const Outcome& outcome) {
    const auto [found, is_new] = numbers_.try_emplace(outcome, list_.size());
    if (is_new) list_.push_back(&found->first);
    return found->second;
  }
  Json json(Names& rules) const {
    Json list = Json::array();
    for (const Outcome* outcome : list_) list.push_back(outcome_json(*outcome, rules));
    return list;
  }

 private:
  std::map<Outcome, std::size_t> numbers_;
  std::vector<const Outcome*> list_;  // keys of the map
};

// Indices of the cases of these answers, each once.
Json cases_of(const std::vector<AnswerPlace>& answers) {
  Json order = Json::array();
  std::set<std::size_t> seen;
  for (const AnswerPlace& place : answers)
    if (seen.insert(place.one).second) order.push_back(place.one);
  return order;
}

// The values of one attribute over all cases.
struct ValueSum {
  std::uint64_t compared = 0;
  std::uint64_t differing = 0;
  std::map<int, std::uint64_t> histogram;
};

// What the answers of one renderer come to, over all cases.
class RendererSums {
 public:
  RendererSums(const Results& results, std::size_t renderer)
      : portrait(portrait_of(results, renderer)), clusters_(results, renderer) {}
  const Portrait portrait;
  void add(const CaseResults& one, const Result& result) {
    clusters_.add(one, result);
    for (const ValueAggregate& values : result.values) {
      ValueSum& sum = values_[values.attribute];
      sum.compared += values.compared;
      sum.differing += values.differing.size();
      for (const auto& [exponent, count] : values.ulp_histogram) sum.histogram[exponent] += count;
    }
    if (one.id.starts_with(kScenes) && !result.failure) add_scene(result.pixel_counts);
  }

  std::vector<Cluster> take_clusters() { return clusters_.take(); }
  Json values() const;
  Json scenes() const {
    Json json = pixel_counts_json(scenes_);
    json["drawn"] = drawn_;
    return json;
  }

 private:
  void add_scene(const PixelCounts& counts) {
    ++drawn_;
    for (const Verdict verdict : kDrawnVerdicts) scenes_[verdict] += counts[verdict];
    scenes_.same += counts.same;
  }

  ClusterGatherer clusters_;
  std::map<std::string, ValueSum> values_;
  std::size_t drawn_ = 0;  // whole scenes
  PixelCounts scenes_;
};

Json RendererSums::values() const {
  Json list = Json::array();
  for (const auto& [attribute, sum] : values_) {
    Json bins = Json::array();
    for (const auto& [exponent, count] : sum.histogram) bins.push_back({exponent, count});
    list.push_back({{"attribute", attribute},
                    {"compared", sum.compared},
                    {"differing", sum.differing},
                    {"histogram", std::move(bins)}});
  }
  return list;
}

// A case, and what its answers come to.
struct ReadCase {
  CaseResults one;
  std::vector<Outcome> outcomes;
};

// An answer to be decided on, and the key of what it is told by; nothing for a failure.
struct UnexpectedAnswer {
  AnswerPlace place;
  std::optional<ClusterKey> leading;
};

// Adds the cases, and sums up what the renderers answered to them.
void add_cases(Json& json, const Results& results, const ReportTexts& texts, const CaseHeads& heads,
               const DetailLines& lines, std::vector<RendererSums>& sums,
               std::vector<UnexpectedAnswer>& unexpected) {
  Names rules;
  Json head_list = Json::array();
  for (std::size_t h = 0; h < heads.list.size(); ++h)
    head_list.push_back(head_json(heads.list[h], rules, lines.of_head[h]));
  Outcomes outcomes;
  Json cases = Json::array();
  Json untrue = Json::array();
  WorstFirst differing;
  const auto add = [&](std::size_t i, const ReadCase& read) {
    const CaseResults& one = read.one;
    Json numbers = Json::array();
    for (std::size_t r = 0; r < one.results.size(); ++r) {
      numbers.push_back(outcomes.number(read.outcomes[r]));
      if (r < sums.size()) sums[r].add(one, one.results[r]);
      if (r < sums.size() && one.results[r].verdict != Verdict::agree)
        differing.add({i, r}, one.results[r]);
      if (is_unexpected(one.results[r].standing))
        unexpected.push_back({{i, r}, leading_key(one, one.results[r], sums[r].portrait)});
    }
    Json row = {heads.of_case[i], one.id.substr(stem_of(one.id).size()), one.fragments,
                std::move(numbers)};
    if (lines.of_case[i] >= 0) row.push_back(lines.of_case[i]);
    if (results.cases.outline(i).has_ramp) row.push_back(1);
    cases.push_back(std::move(row));
    if (!one.expect_failures.empty()) untrue.push_back({i, one.expect_failures});
  };
  const FindingsOf findings_of(results.latitude, texts);
  const auto read_case = [&](std::size_t i) {
    ReadCase read{results.cases[i], {}};
    for (const Result& result : read.one.results)
      read.outcomes.push_back({result.verdict, result.standing, findings_of(result)});
    return read;
  };
  make_in_order(results.cases.size(), read_case, add,
                [&](std::size_t i) { return results.cases.bytes(i); });
  Json outcome_list = outcomes.json(rules);
  json["names"] = rules.list();
  json["heads"] = std::move(head_list);
  json["outcomes"] = std::move(outcome_list);
  json["cases"] = std::move(cases);
  json["order"] = cases_of(differing.take());
  json["untrue"] = std::move(untrue);
}

// The number, counted from 1, of a cluster's first disagreement in its smallest case; 0: none.
std::size_t place_of(const Results& results, std::size_t renderer, const Cluster& cluster) {
  const auto at = results.cases.find(cluster.smallest_case);
  if (!at) return 0;
  const CaseResults one = results.cases[*at];
  const auto list = worst_first(one.results[renderer]);  // as case_details lists them
  const auto found = std::ranges::find_if(list, [&](const Disagreement* d) {
    return d->x == cluster.x && d->y == cluster.y && d->legality == cluster.legality &&
           (cluster.kind.empty() || cluster.kind == name_of(d->kind));
  });
  return found == list.end() ? 0 : static_cast<std::size_t>(found - list.begin()) + 1;
}

Json cluster_json(const Cluster& cluster, std::size_t at) {
  Json json = {{"cause", cluster.cause},
               {"rule", cluster.rule},
               {"kind", cluster.kind},
               {"situations", cluster.situations},
               {"common", cluster.common},
               {"attribute", cluster.attribute},
               {"surface", cluster.surface},
               {"legality", name_of(cluster.legality)},
               {"disagreements", cluster.disagreements},
               {"cases", cluster.cases},
               {"smallest", cluster.smallest_case}};
  if (at > 0) json["at"] = at;
  return json;
}

Json choices_json(const ReportTexts& texts, const std::string& renderer) {
  Json json = Json::object();
  const auto found = texts.profiles.find(renderer);
  if (found == texts.profiles.end()) return json;
  for (const auto& [place, choices] : found->second)
    for (const auto& [rule, alternative] : choices) json[place][rule] = alternative;
  return json;
}

// `found`: the renderer's clusters.
Json unexpected_json(const Results& results, const UnexpectedAnswer& answer,
                     const std::vector<Cluster>& found) {
  const auto& [one, renderer] = answer.place;
  const ResultOutline& outline = results.cases.outline(one).answers[renderer];
  Json told = outline.failure ? name_of(outline.failure->kind) : "";
  if (answer.leading)
    if (const Cluster* const cluster = cluster_of(found, *answer.leading))
      told = cluster - found.data();
  return {one, renderer, std::move(told), outline.fingerprint};
}

Json renderer_json(const Results& results, const ReportTexts& texts, std::size_t index,
                   const std::vector<Cluster>& found, const RendererSums& sums) {
  const RendererInfo& info = results.renderers[index];
  Json clusters = Json::array();
  for (const Cluster& cluster : found)
    clusters.push_back(cluster_json(cluster, place_of(results, index, cluster)));
  return {{"name", info.name},
          {"vendor", info.vendor},
          {"version", info.version},
          {"device", info.device},
          {"traits", info.traits},
          {"subpixel_bits", info.subpixel_bits},
          {"portrait", sentences_of(sums.portrait)},
          {"clusters", std::move(clusters)},
          {"values", sums.values()},
          {"scenes", sums.scenes()},
          {"profile", choices_json(texts, info.name)}};
}

// The page's words and shapes, by verdict; and by legality, the verdict on a difference without a
// cause, and on one with a cause that is open.
void add_verdicts(Json& json, Latitude latitude) {
  Json& words = json["verdicts"];
  for (const VerdictLook& look : kVerdictLooks)
    words[name_of(look.verdict)] = {{"rank", kVerdictLooks.size() - 1 - words.size()},
                                    {"path", look.icon},
                                    {"means", look.meaning}};
  for (const Legality legality : values_of<Legality>())
    for (const bool is_open : {false, true})
      json["judged"][name_of(legality)].push_back(name_of(verdict_of(legality, is_open, latitude)));
}

void add_texts(Json& json, const ReportTexts& texts) {
  json["rules"] = json["rulings"] = Json::array();
  for (const RuleText& rule : texts.rules) {
    json["rules"].push_back({{"id", rule.id},
                             {"title", rule.title},
                             {"spec", rule.spec},
                             {"latitude", rule.latitude},
                             {"standard", rule.standard},
                             {"alternatives", Json::object()}});
    for (const auto& [name, meaning] : rule.alternatives)
      json["rules"].back()["alternatives"][name] = meaning;
  }
  for (const RulingText& ruling : texts.rulings)
    json["rulings"].push_back(
        {{"number", ruling.number}, {"text", ruling.text}, {"facts", ruling.facts}});
}

void add_problems(Json& json, const Results& results) {
  json["diagnostics"] = json["faults"] = Json::array();
  for (const Diagnostic& d : results.diagnostics)
    json["diagnostics"].push_back({{"file", d.file},
                                   {"line", d.line},
                                   {"pointer", d.pointer},
                                   {"message", d.message},
                                   {"remedy", d.remedy}});
  for (const FaultSeen& seen : results.faults)
    json["faults"].push_back({{"renderer", seen.renderer},
                              {"id", seen.id},
                              {"reason", seen.reason},
                              {"link", seen.link},
                              {"cases", seen.cases},
                              {"state", name_of(seen.state)},
                              {"told", describe(seen)},
                              {"smallest", shortest_case_with(results, seen.renderer, seen.id)}});
}

}  // namespace

Json report_index(const Results& results, const ReportTexts& texts, const CaseHeads& heads,
                  const DetailLines& lines) {
  Json json = {{"tool", results.tool},
               {"policy", results.policy},
               {"interrupted", results.interrupted},
               {"left_out", results.left_out},
               {"renderers", Json::array()}};
  add_verdicts(json, results.latitude);
  add_texts(json, texts);
  add_problems(json, results);
  std::vector<RendererSums> sums;
  for (std::size_t r = 0; r < results.renderers.size(); ++r) sums.emplace_back(results, r);
  std::vector<UnexpectedAnswer> unexpected;
  add_cases(json, results, texts, heads, lines, sums, unexpected);
  std::vector<std::vector<Cluster>> clusters;
  for (std::size_t i = 0; i < results.renderers.size(); ++i) {
    clusters.push_back(sums[i].take_clusters());
    json["renderers"].push_back(renderer_json(results, texts, i, clusters[i], sums[i]));
  }
  json["answers"] = results.rules;
  json["unexpected"] = Json::array();
  for (const UnexpectedAnswer& answer : unexpected)
    json["unexpected"].push_back(unexpected_json(results, answer, clusters[answer.place.renderer]));
  if (texts.since) json["since"] = Json::parse(comparison_json(*texts.since));
  return json;
}

}  // namespace edgecase
