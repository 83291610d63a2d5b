// SPDX-License-Identifier: MIT
#include "reports/ctrf.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <string>
#include <utility>

#include "reports/test_outcomes.h"
#include "reports/text.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

const char* status_of(TestStatus status) {
  switch (status) {
    case TestStatus::passed:
      return "passed";
    case TestStatus::skipped:
      return "skipped";
    case TestStatus::failed:
    case TestStatus::error:
      break;
  }
  return "failed";
}

// "edgecase 0.1.0" -> {"name": "edgecase", "version": "0.1.0"}. The name must not be empty.
Json tool_json(const std::string& tool) {
  const std::string text = tool.empty() ? "edgecase" : tool;
  const std::size_t space = text.rfind(' ');
  if (space == std::string::npos || space == 0) return {{"name", text}};
  return {{"name", text.substr(0, space)}, {"version", text.substr(space + 1)}};
}

// The rules that the case is about, and its tags.
Json tags_of(const CaseResults& one) {
  Json tags = one.rules;
  for (const std::string& tag : one.tags) tags.push_back(tag);
  return tags;
}

Json test_json(const TestOutcome& outcome, const Durations& durations) {
  Json json = {{"name", outcome.name.empty() ? "?" : outcome.name},
               {"status", status_of(outcome.status)},
               {"duration", std::llround(1000 * seconds_of(outcome, durations))},  // milliseconds
               {"suite", outcome.suite}};
  if (!outcome.message.empty()) json["message"] = outcome.message;
  if (!outcome.details.empty()) json["trace"] = outcome.details;
  if (outcome.line > 0) json["line"] = outcome.line;
  if (outcome.result != nullptr) {
    json["rawStatus"] = name_of(outcome.result->verdict);
    json["tags"] = tags_of(*outcome.one);
    json["extra"] = {{"standing", name_of(outcome.result->standing)},
                     {"fingerprint", outcome.result->fingerprint}};
    if (outcome.cluster != nullptr) json["extra"]["group"] = title_of(*outcome.cluster);
  }
  if (!outcome.file.empty()) json["filePath"] = outcome.file;
  return json;
}

Json renderer_json(const RendererInfo& info) {
  return {{"name", info.name},
          {"vendor", info.vendor},
          {"version", info.version},
          {"device", info.device}};
}

// Bytes of names and messages that are not UTF-8 are replaced.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Counts by status, all required by the format, and the number of suites.
class Summary {
 public:
  void add(const TestOutcome& outcome) {
    ++counts_[status_of(outcome.status)];
    suites_.insert(outcome.suite.front());
  }

  Json json() const {
    std::size_t tests = 0;
    Json json = {{"tests", 0}};
    for (const char* status : {"passed", "failed", "pending", "skipped", "other"}) {
      const auto found = counts_.find(status);
      const std::size_t count = found == counts_.end() ? 0 : found->second;
      json[status] = count;
      tests += count;
    }
    json["tests"] = tests;
    json["suites"] = suites_.size();
    json["start"] = 0;
    json["stop"] = 0;
    return json;
  }

 private:
  std::map<std::string, std::size_t> counts_;
  std::set<std::string> suites_;
};

}  // namespace

void write_ctrf(const Results& results, const Durations& durations, std::ostream& out) {
  out << "{\"reportFormat\":\"CTRF\",\"specVersion\":\"0.0.0\",\"generatedBy\":"
      << dump(results.tool) << ",\n\"results\":{\"tool\":" << dump(tool_json(results.tool))
      << ",\n\"tests\":[";
  Summary summary;
  const char* separator = "\n";
  visit_outcomes(results, [&](const TestOutcome& outcome) {
    out << separator << dump(test_json(outcome, durations));
    separator = ",\n";
    summary.add(outcome);
  });
  Json renderers = Json::array();
  for (const RendererInfo& info : results.renderers) renderers.push_back(renderer_json(info));
  const Json extra = {{"policy", results.policy}, {"renderers", std::move(renderers)}};
  out << "\n],\n\"summary\":" << dump(summary.json()) << ",\n\"extra\":" << dump(extra) << "}}\n";
}

}  // namespace edgecase
