// SPDX-License-Identifier: MIT
#include "results/decisions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "results/shallow_json.h"
#include "results/standing.h"

namespace edgecase {
namespace {

using Json = nlohmann::json;

constexpr int kFormat = 2;

void check_keys(const Json& object, const std::set<std::string>& known) {
  if (!object.is_object()) throw std::runtime_error("this is no object");
  for (const auto& [key, value] : object.items())
    if (!known.contains(key)) throw std::runtime_error(fmt::format("unknown key \"{}\"", key));
}

// A required text that must not be empty.
std::string text_of(const Json& object, const char* key) {
  if (!object.contains(key)) throw std::runtime_error(fmt::format("\"{}\" is missing", key));
  if (!object.at(key).is_string()) throw std::runtime_error(fmt::format("\"{}\" is no text", key));
  std::string text = object.at(key);
  if (text.empty()) throw std::runtime_error(fmt::format("\"{}\" is empty", key));
  return text;
}

std::string optional_text_of(const Json& object, const char* key) {
  return object.contains(key) ? text_of(object, key) : "";
}

Judgement to_answer(const Json& object) {
  Judgement answer;
  const std::string verdict = text_of(object, "verdict");
  if (!parse_name(verdict, answer.verdict))
    throw std::runtime_error(fmt::format("\"{}\" is no verdict", verdict));
  // An answer that agrees has an empty one.
  if (!object.contains("fingerprint") || !object.at("fingerprint").is_string())
    throw std::runtime_error("\"fingerprint\" is missing");
  answer.fingerprint = object.at("fingerprint");
  return answer;
}

Decision to_decision(const Json& object, const std::string& renderer) {
  check_keys(object, {"case", "renderer", "verdict", "fingerprint", "decision", "reason", "link"});
  Decision decision;
  decision.id = text_of(object, "case");
  decision.renderer = object.contains("renderer") ? text_of(object, "renderer") : renderer;
  if (decision.renderer.empty())
    throw std::runtime_error("\"renderer\" is missing, here and of the file");
  decision.seen = to_answer(object);
  const std::string word = text_of(object, "decision");
  if (word != "accept" && word != "reject")
    throw std::runtime_error(fmt::format("\"{}\" is no decision; write accept or reject", word));
  decision.accepts = word == "accept";
  decision.reason = text_of(object, "reason");
  decision.link = optional_text_of(object, "link");
  return decision;
}

const ResultOutline* find_answer(const Results& results, std::size_t index, const std::string& id) {
  const auto found = results.cases.find(id);
  return found ? &results.cases.outline(*found).answers[index] : nullptr;
}

// The reason why a decision does not hold any more; empty if it holds.
std::string refusal_of(const Decision& decision, const ResultOutline* answer) {
  if (answer == nullptr) return "the results have no such case";
  if (answer->again) return "the answer changes when it is asked for again: nothing to decide on";
  if (judgement_of(*answer) != decision.seen)
    return fmt::format("it was made on {}, and the results have {}", describe(decision.seen),
                       describe(judgement_of(*answer)));
  if (decision.accepts && answer->standing == Standing::known)
    return fmt::format("it is known by now: {}", fmt::join(answer->faults, ", "));
  if (decision.accepts && answer->standing != Standing::unexpected)
    return fmt::format("a result that is {} needs no known fault", name_of(answer->standing));
  return "";
}

}  // namespace

std::variant<std::vector<Decision>, std::string> parse_decisions(const std::string& text) {
  std::string where = "the file";
  try {
    const Json json = parse_shallow(text);
    check_keys(json, {"edgecase_decisions", "renderer", "decisions"});
    if (!json.contains("edgecase_decisions") || json.at("edgecase_decisions") != kFormat)
      throw std::runtime_error(fmt::format("\"edgecase_decisions\" must be {}", kFormat));
    const std::string renderer = optional_text_of(json, "renderer");
    if (!json.contains("decisions") || !json.at("decisions").is_array())
      throw std::runtime_error("\"decisions\" is no list");
    std::vector<Decision> decisions;
    std::map<std::pair<std::string, std::string>, std::size_t> seen;
    for (const Json& item : json.at("decisions")) {
      const std::size_t at = decisions.size();
      where = fmt::format("/decisions/{}", at);
      if (item.is_object() && item.contains("case") && item.at("case").is_string())
        where += fmt::format(" (case {})", item.at("case").get<std::string>());
      decisions.push_back(to_decision(item, renderer));
      const auto [twin, is_new] =
          seen.emplace(std::pair(decisions.back().renderer, decisions.back().id), at);
      if (!is_new)
        throw std::runtime_error(
            fmt::format("/decisions/{} is on the same case and renderer", twin->second));
    }
    return decisions;
  } catch (const std::exception& error) {
    return fmt::format("{}: {}", where, fault_of(error));
  }
}

std::vector<DecisionOutcome> weigh_decisions(const Results& results, std::size_t index,
                                             std::span<const Decision> decisions) {
  std::vector<DecisionOutcome> outcomes;
  for (const Decision& decision : decisions)
    if (decision.renderer == results.renderers[index].name)
      outcomes.push_back(
          {&decision, refusal_of(decision, find_answer(results, index, decision.id))});
  return outcomes;
}

std::vector<FaultChange> plan_decisions(const Results& results, std::size_t index,
                                        const KnownFaults& current,
                                        std::span<const DecisionOutcome> outcomes) {
  std::map<std::pair<std::string, std::string>, std::set<std::string>> accepted;
  for (const DecisionOutcome& outcome : outcomes)
    if (outcome.refusal.empty() && outcome.decision->accepts)
      accepted[{outcome.decision->reason, outcome.decision->link}].insert(outcome.decision->id);
  KnownFaults known = current;
  std::vector<FaultChange> changes;
  for (const auto& [words, cases] : accepted) {
    const std::set<std::string>& ids = cases;  // a lambda captures no structured binding
    const auto is_wanted = [&ids](const std::string& id) { return ids.contains(id); };
    const auto planned =
        plan_blessing(results, index, known, {is_wanted, words.first, words.second});
    known = with_changes(known, planned);
    changes.insert(changes.end(), planned.begin(), planned.end());
  }
  return changes;
}

}  // namespace edgecase
