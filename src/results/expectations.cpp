// SPDX-License-Identifier: MIT
#include "results/expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "model/digest.h"
#include "results/shallow_json.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

Expectation parse_entry(const Json& json) {
  Expectation entry;
  const std::string verdict = json.at("verdict");
  if (!parse_name(verdict, entry.verdict))
    throw std::runtime_error(fmt::format("\"{}\" is no verdict", verdict));
  entry.fingerprint = json.at("fingerprint");
  entry.reason = json.at("reason");
  entry.link = json.value("link", "");
  if (entry.reason.empty()) throw std::runtime_error("an expectation needs a reason");
  for (const auto& [key, value] : json.items())
    if (key != "case" && key != "verdict" && key != "fingerprint" && key != "reason" &&
        key != "link")
      throw std::runtime_error(fmt::format("unknown key \"{}\"", key));
  return entry;
}

// Entries are taken as they are read, and no tree of all of them is ever made: a suite's are tens
// of thousands.
class ExpectationsReader {
 public:
  explicit ExpectationsReader(const WantedRenderer& wanted) : wanted_(wanted) {}

  // Throws std::runtime_error, naming the place.
  Expectations read(const std::string& text) {
    try {
      const Json rest = Json::parse(text, [this](int depth, Json::parse_event_t event, Json& json) {
        return take(depth, event, json);
      });
      result_.renderer = rest.at("renderer");
      result_.measured = rest.at("measured");
      for (const auto& [key, value] : rest.items())
        if (key != "renderer" && key != "measured" && key != "expectations")
          throw std::runtime_error(fmt::format("unknown key \"{}\"", key));
      if (!rest.at("expectations").is_array())
        throw std::runtime_error("\"expectations\" is no list");
      for (const Json& item : rest.at("expectations")) add(item);
    } catch (const Unwanted&) {
      result_.cases.clear();
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}: {}", where_, fault_of(error)));
    }
    return std::move(result_);
  }

 private:
  struct Unwanted {};

  // Whether what was read is to be kept in the tree.
  bool take(int depth, Json::parse_event_t event, const Json& json) {
    using Event = Json::parse_event_t;
    if (depth == 1 && event == Event::key) key_ = json.get<std::string>();
    if (depth == 1 && event == Event::value && key_ == "renderer" && json.is_string()) {
      result_.renderer = json.get<std::string>();
      if (wanted_ && !wanted_(result_.renderer)) throw Unwanted();
    }
    if (depth == 1 && event == Event::array_start) is_list_ = key_ == "expectations";
    if (depth == 1 && event == Event::array_end) is_list_ = false;
    if (!is_list_ || depth != 2 || event != Event::object_end) return true;
    add(json);
    return false;
  }

  void add(const Json& item) {
    where_ = fmt::format("expectation {}", result_.cases.size());
    const std::string id = item.at("case");
    where_ = fmt::format("expectation of {}", id);
    if (!result_.cases.emplace(id, parse_entry(item)).second)
      throw std::runtime_error("the case has two entries");
    where_ = "the file";
  }

  const WantedRenderer& wanted_;
  Expectations result_;
  std::string where_ = "the file";
  std::string key_;  // of the file's object, the latest
  bool is_list_ = false;
};

// Bytes that are no UTF-8 are replaced, never fatal.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Which of the two legal verdicts the same fingerprint gets depends on what else the run holds: a
// cause that the whole run refutes may be the likeliest one of a shard.
bool is_permitted_or_convention(Verdict verdict) {
  return verdict == Verdict::convention || verdict == Verdict::permitted;
}

bool same_answer(const Expectation& entry, const Result& result) {
  if (entry.fingerprint != result.fingerprint) return false;
  return entry.verdict == result.verdict || (is_permitted_or_convention(entry.verdict) &&
                                             is_permitted_or_convention(result.verdict));
}

std::string words_of(const Judgement& answer) {
  return answer.fingerprint.empty()
             ? std::string(name_of(answer.verdict))
             : fmt::format("{} {}", name_of(answer.verdict), answer.fingerprint);
}

// Of an answer that its entry, or that there is none, does not expect.
void set_unexpected(bool has_entry, KnownResult& result) {
  const bool agrees = result.verdict == Verdict::agree;
  result.standing = !has_entry ? Standing::unexpected
                    : agrees   ? Standing::unexpected_agreement
                               : Standing::changed;
}

// What is expected of an answer, if anything.
void set_standing(const Expectation* entry, KnownResult& result) {
  const bool agrees = result.verdict == Verdict::agree;
  result.expected.reset();
  if (entry != nullptr) result.expected = {entry->verdict, entry->fingerprint};
  if (result.again) {
    result.standing = Standing::flake;
    result.expectation = fmt::format("it answered {}, and when asked again {}",
                                     words_of(judgement_of(result)), words_of(*result.again));
    return;
  }
  if (entry == nullptr && agrees) {
    result.standing = Standing::expected;
    result.expectation = "";
    return;
  }
  if (entry != nullptr && same_answer(*entry, result)) {
    result.standing = Standing::expected;
    result.expectation = entry->reason;
    return;
  }
  if (result.verdict == Verdict::contested)
    result.standing = Standing::tolerated;
  else
    set_unexpected(entry != nullptr, result);
  result.expectation = entry == nullptr
                           ? "no expectation says that it differs"
                           : fmt::format("expected {} {} ({})", name_of(entry->verdict),
                                         entry->fingerprint, entry->reason);
}

}  // namespace

std::string reason_from(const Result& result) {
  if (result.failure)
    return fmt::format("{}: {}", name_of(result.failure->kind), result.failure->reason);
  std::set<std::string> rules;
  std::set<std::string> causes;
  std::set<int> broken;
  for (const Disagreement& d : result.disagreements) {
    rules.insert(name_of(d.rule));
    causes.insert(text_of(d.cause));
    if (!is_legal(d)) broken.insert(d.ruling);
  }
  const bool unexplained = causes.erase("") > 0;
  std::string text;
  if (!rules.empty())
    text = fmt::format("{} by {}",
                       result.disagreements.size() == 1
                           ? "one difference"
                           : fmt::format("{} differences", result.disagreements.size()),
                       fmt::join(rules, ", "));
  if (!broken.empty()) text += fmt::format(", against ruling {}", fmt::join(broken, ", "));
  if (!causes.empty()) text += fmt::format("; it follows {}", fmt::join(causes, " and "));
  if (unexplained)
    text += causes.empty() ? "; no catalogued alternative draws this"
                           : "; some follow no catalogued alternative";
  for (const ValueAggregate& values : result.values)
    text += values.cause.empty()
                ? fmt::format("{}{} rounded otherwise than exactly, within what is permitted",
                              text.empty() ? "" : "; ", values.attribute)
                : fmt::format("{}{} by {}", text.empty() ? "" : "; ", values.attribute,
                              text_of(values.cause));
  return text;
}

std::variant<Expectations, std::string> parse_expectations(const std::string& text,
                                                           const WantedRenderer& wanted) {
  try {
    return ExpectationsReader(wanted).read(text);
  } catch (const std::exception& error) {
    return fault_of(error);
  }
}

std::string expectations_text(const Expectations& expectations) {
  std::string text =
      fmt::format("{{\n  \"renderer\": {},\n  \"measured\": {},\n  \"expectations\": [",
                  dump(expectations.renderer), dump(expectations.measured));
  const char* separator = "\n";
  for (const auto& [id, entry] : expectations.cases) {
    Json json = {{"case", id},
                 {"verdict", name_of(entry.verdict)},
                 {"fingerprint", entry.fingerprint},
                 {"reason", entry.reason}};
    if (!entry.link.empty()) json["link"] = entry.link;
    text += fmt::format("{}    {}", separator, dump(json));
    separator = ",\n";
  }
  return text + "\n  ]\n}\n";
}

std::string expectations_file_name(const std::string& renderer) {
  constexpr std::size_t kMostOfName = 200;  // bytes; file systems take 255
  std::string name = renderer.substr(0, kMostOfName);
  if (name.size() < renderer.size()) name += "-" + digest_of_text(renderer);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ':' || c == '/' || c == ' '; }, '-');
  return name + ".json";
}

void apply_expectations(Results& results, std::size_t index, const Expectations* expectations) {
  for (CaseResults& one : results.cases) {
    const Expectation* entry = nullptr;
    if (expectations != nullptr)
      if (const auto found = expectations->cases.find(one.id); found != expectations->cases.end())
        entry = &found->second;
    set_standing(entry, one.results[index]);
  }
}

void hold_contested(Results& results) {
  for (CaseResults& one : results.cases)
    for (KnownResult& result : one.results)
      if (result.standing == Standing::tolerated)
        set_unexpected(result.expected.has_value(), result);
}

std::vector<MissingCase> missing_cases(const Results& results, const Expectations& expectations) {
  if (!is_whole(results)) return {};
  std::set<std::string> ids;
  for (const CaseResults& one : results.cases) ids.insert(one.id);
  std::vector<MissingCase> missing;
  for (const auto& [id, entry] : expectations.cases)
    if (!ids.contains(id))
      missing.push_back(
          {expectations.renderer, id, {entry.verdict, entry.fingerprint}, entry.reason});
  return missing;
}

std::vector<ExpectationChange> plan_blessing(const Results& results, std::size_t index,
                                             const Expectations& current,
                                             const std::string& reason) {
  std::vector<ExpectationChange> changes;
  for (const CaseResults& one : results.cases) {
    const KnownResult& result = one.results[index];
    // A renderer that was never asked, or a case that a recording lacks, says nothing of it.
    if (result.failure && result.failure->kind == FailureKind::unavailable) continue;
    if (result.again) continue;
    const auto found = current.cases.find(one.id);
    const Expectation* before = found != current.cases.end() ? &found->second : nullptr;
    if (result.verdict == Verdict::agree) {
      if (before != nullptr) changes.push_back({one.id, before, std::nullopt});
      continue;
    }
    if (before != nullptr && same_answer(*before, result)) continue;
    Expectation after{result.verdict, result.fingerprint,
                      reason.empty() ? reason_from(result) : reason,
                      before != nullptr ? before->link : ""};
    changes.push_back({one.id, before, std::move(after)});
  }
  for (const MissingCase& missing : missing_cases(results, current))
    changes.push_back({missing.id, &current.cases.at(missing.id), std::nullopt});
  std::ranges::sort(changes, {}, &ExpectationChange::id);
  return changes;
}

}  // namespace edgecase
