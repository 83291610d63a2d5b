// SPDX-License-Identifier: MIT
#include "results/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <utility>

#include "rules/all_rules.h"

namespace edgecase {
namespace {

void add_fact(const std::string& what, const std::string& before, const std::string& after,
              std::vector<FactChange>& facts) {
  if (before != after) facts.push_back({what, before, after});
}

std::string words_on_completeness(const Results& results) {
  if (results.shard)
    return fmt::format("shard {} of {}", results.shard->index + 1, results.shard->count);
  return results.interrupted ? fmt::format("interrupted, {} cases missing", results.left_out)
                             : "complete";
}

std::vector<FactChange> compare_facts(const Results& before, const Results& after) {
  std::vector<FactChange> facts;
  add_fact("tool", before.tool, after.tool, facts);
  add_fact("policy", before.policy, after.policy, facts);
  add_fact("latitude", name_of(before.latitude), name_of(after.latitude), facts);
  add_fact("choices of policy and profiles, digest", before.policy_digest, after.policy_digest,
           facts);
  add_fact("run", words_on_completeness(before), words_on_completeness(after), facts);
  add_fact("case files that cannot be loaded", std::to_string(before.diagnostics.size()),
           std::to_string(after.diagnostics.size()), facts);
  return facts;
}

std::vector<FactChange> compare_claims(const RendererInfo& before, const RendererInfo& after) {
  std::vector<FactChange> facts;
  add_fact("name", before.name, after.name, facts);
  add_fact("vendor", before.vendor, after.vendor, facts);
  add_fact("version", before.version, after.version, facts);
  add_fact("device", before.device, after.device, facts);
  add_fact("subpixel bits", std::to_string(before.subpixel_bits),
           std::to_string(after.subpixel_bits), facts);
  std::set<std::string> names;
  for (const auto& [name, value] : before.traits) names.insert(name);
  for (const auto& [name, value] : after.traits) names.insert(name);
  const auto value_of = [](const RendererInfo& info, const std::string& name) {
    const auto found = info.traits.find(name);
    return found != info.traits.end() ? found->second : std::string();
  };
  for (const std::string& name : names)
    add_fact(name, value_of(before, name), value_of(after, name), facts);
  return facts;
}

// Rules that both were asked about, and of which other alternatives remain.
void compare_rules(const std::map<std::string, std::string>& before,
                   const std::map<std::string, std::string>& after,
                   std::vector<FactChange>& facts) {
  for (const auto& [rule, remaining] : before)
    if (const auto found = after.find(rule); found != after.end())
      add_fact(rule, remaining, found->second, facts);
}

// Nothing if the two answers are the same.
std::optional<ChangeKind> change_of(const Judgement& before, const Judgement& after) {
  if (before == after) return std::nullopt;
  const bool ran = before.verdict != Verdict::not_run;
  const bool runs = after.verdict != Verdict::not_run;
  if (ran != runs) return ran ? ChangeKind::not_run : ChangeKind::runs;
  if (before.verdict == after.verdict) return ChangeKind::changed;
  if (before.verdict == Verdict::agree) return ChangeKind::new_disagreement;
  if (after.verdict == Verdict::agree) return ChangeKind::fixed;
  return before.verdict < after.verdict ? ChangeKind::worse : ChangeKind::better;
}

// True if the later results show the reason for a change; otherwise the earlier ones do.
bool shows_after(ChangeKind change) {
  switch (change) {
    case ChangeKind::new_disagreement:
    case ChangeKind::worse:
    case ChangeKind::not_run:
    case ChangeKind::changed:
    case ChangeKind::appeared:
      return true;
    case ChangeKind::disappeared:
    case ChangeKind::runs:
    case ChangeKind::better:
    case ChangeKind::fixed:
      return false;
  }
  return true;
}

class Clusters {
 public:
  void add(const std::string& id, ChangeKind change, const Result& result) {
    id_ = id;
    seen_.clear();
    if (result.failure) count(change, "not-run", name_of(result.failure->kind), 1);
    for (const Disagreement& d : result.disagreements)
      count(change, name_of(d.rule), text_of(d.cause), 1);
    for (const CountedDisagreements& d : result.counted)
      count(change, name_of(d.rule), text_of(d.cause), d.count());
    for (const ValueAggregate& values : result.values)
      count(change, name_of(values.rule), text_of(values.cause), values.differing.size());
  }

  std::vector<ChangeCluster> take() const {
    std::vector<ChangeCluster> list;
    for (const auto& [key, cluster] : clusters_) list.push_back(cluster);
    std::ranges::stable_sort(list, [](const ChangeCluster& a, const ChangeCluster& b) {
      return std::tie(a.change, b.cases, b.disagreements) <
             std::tie(b.change, a.cases, a.disagreements);
    });
    return list;
  }

 private:
  using Key = std::tuple<ChangeKind, std::string, std::string>;

  void count(ChangeKind change, const std::string& rule, const std::string& cause,
             std::size_t number) {
    const Key key(change, rule, cause);
    ChangeCluster& cluster = clusters_[key];
    if (cluster.cases == 0) cluster = {change, rule, cause, 0, 0, id_};
    if (seen_.insert(key).second) ++cluster.cases;
    cluster.disagreements += number;
  }

  std::string id_;
  std::set<Key> seen_;  // of the case at hand
  std::map<Key, ChangeCluster> clusters_;
};

// Where a case stands in both results.
using Indices = std::pair<std::optional<std::size_t>, std::optional<std::size_t>>;

std::map<std::string, Indices> indices_by_id(const Results& before, const Results& after) {
  std::map<std::string, Indices> indices;
  std::size_t index = 0;
  for (const CaseOutline& one : before.cases.outlines()) indices[one.id].first = index++;
  index = 0;
  for (const CaseOutline& one : after.cases.outlines()) indices[one.id].second = index++;
  return indices;
}

std::optional<Judgement> judgement_at(const Results& results, std::size_t renderer,
                                      std::optional<std::size_t> index) {
  if (!index) return std::nullopt;
  return judgement_of(results.cases.outline(*index).answers[renderer]);
}

RendererComparison compare_answers(const Results& before, std::size_t b, const Results& after,
                                   std::size_t a) {
  RendererComparison comparison;
  comparison.before = before.renderers[b].name;
  comparison.after = after.renderers[a].name;
  comparison.facts = compare_claims(before.renderers[b], after.renderers[a]);
  compare_rules(remaining_in(before, comparison.before), remaining_in(after, comparison.after),
                comparison.facts);
  Clusters clusters;
  for (const auto& [id, indices] : indices_by_id(before, after)) {
    CaseChange one{id, ChangeKind::changed, judgement_at(before, b, indices.first),
                   judgement_at(after, a, indices.second)};
    const std::optional<ChangeKind> change = !one.before  ? ChangeKind::appeared
                                             : !one.after ? ChangeKind::disappeared
                                                          : change_of(*one.before, *one.after);
    if (!change) {
      ++comparison.same;
      continue;
    }
    one.change = *change;
    ++comparison.counts[*change];
    if (shows_after(*change))
      clusters.add(id, *change, after.cases[*indices.second].results[a]);
    else
      clusters.add(id, *change, before.cases[*indices.first].results[b]);
    comparison.cases.push_back(std::move(one));
  }
  comparison.clusters = clusters.take();
  return comparison;
}

std::optional<std::size_t> index_of(const Results& results, const std::string& name) {
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    if (results.renderers[r].name == name) return r;
  return std::nullopt;
}

std::string names_of(const Results& results) {
  std::string text;
  for (const RendererInfo& info : results.renderers) text += (text.empty() ? "" : ", ") + info.name;
  return text;
}

}  // namespace

std::map<std::string, std::string> remaining_in(const Results& results,
                                                const std::string& renderer) {
  std::map<std::string, std::string> remaining;
  const auto found = results.rules.find(renderer);
  if (found == results.rules.end()) return remaining;
  for (const auto& [surface, rules] : found->second)
    for (const RuleAnswers& answers : rules)
      remaining[fmt::format("{}, {}", name_of(answers.rule), surface)] = remaining_of(answers);
  return remaining;
}

std::variant<Comparison, std::string> compare_results(const Results& before, const Results& after) {
  Comparison comparison;
  comparison.facts = compare_facts(before, after);
  if (before.renderers.size() == 1 && after.renderers.size() == 1) {
    comparison.renderers.push_back(compare_answers(before, 0, after, 0));
    return comparison;
  }
  for (std::size_t b = 0; b < before.renderers.size(); ++b) {
    const std::string& name = before.renderers[b].name;
    if (const auto a = index_of(after, name))
      comparison.renderers.push_back(compare_answers(before, b, after, *a));
    else
      comparison.only_before.push_back(name);
  }
  for (const RendererInfo& info : after.renderers)
    if (!index_of(before, info.name)) comparison.only_after.push_back(info.name);
  if (comparison.renderers.empty())
    return fmt::format(
        "no renderer is in both: the old results are of {}, the new ones of {}; renderers are "
        "matched by name, unless each file has one alone",
        names_of(before), names_of(after));
  return comparison;
}

bool differs(const Comparison& comparison) {
  return !comparison.only_before.empty() || !comparison.only_after.empty() ||
         std::ranges::any_of(comparison.renderers, [](const RendererComparison& renderer) {
           return !renderer.cases.empty();
         });
}

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
