// SPDX-License-Identifier: MIT
#include "reports/annotations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "model/text.h"
#include "reports/test_outcomes.h"
#include "reports/text.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostAnnotations = 10;
constexpr std::size_t kMostOfTitle = 200;
constexpr std::size_t kMostOfMessage = 1200;

// The failing and contested tests of one file.
struct Group {
  bool is_error = false;
  std::string file;  // empty: the run, or a case that the suite has no more
  int line = 0;
  int severity = -1;       // of the heaviest test, whose message is shown
  std::size_t weight = 0;  // its disagreements
  std::size_t disagreements = 0;
  std::size_t tests = 0;
  std::string title;
  std::string message;
};

// Tests that are no renderer's answers come first: they concern the suite or the whole run.
int severity_of(const TestOutcome& outcome) {
  const auto severity = [](Verdict verdict) { return 2 * static_cast<int>(verdict); };
  constexpr int kMost = 2 * static_cast<int>(kWorstFirst.size());
  if (outcome.result == nullptr) return outcome.status == TestStatus::error ? kMost + 1 : kMost;
  // An answer that did not come is worse than what is permitted, and than nothing else.
  if (outcome.result->verdict == Verdict::not_run) return severity(Verdict::permitted) + 1;
  return severity(outcome.result->verdict);
}

void add(const TestOutcome& outcome, Group& group) {
  const int severity = severity_of(outcome);
  const std::size_t weight = outcome.result == nullptr ? 0 : count_differences(*outcome.result);
  group.disagreements += weight;
  ++group.tests;
  if (std::tuple(severity, weight) <= std::tuple(group.severity, group.weight) && group.tests > 1)
    return;
  group.file = outcome.file;
  group.line = outcome.line;
  group.severity = severity;
  group.weight = weight;
  group.title = outcome.name + ", " + outcome.suite.front();
  group.message = outcome.message + "\n" + outcome.details;
}

std::vector<Group> groups_of(const Results& results) {
  std::map<std::string, Group> groups;
  visit_outcomes(results, [&groups](const TestOutcome& outcome) {
    const bool is_error = outcome.status >= TestStatus::failed;
    const bool is_tolerated =
        outcome.result != nullptr && outcome.result->standing == Standing::tolerated;
    if (!is_error && !is_tolerated) return;
    // An outcome without a file is its own group; no path holds a zero byte.
    std::string key = outcome.file.empty()
                          ? std::string(1, '\0') + outcome.suite.front() + outcome.name
                          : outcome.file;
    if (!is_error) key += std::string(1, '\0');
    Group& group = groups[key];
    group.is_error = is_error;
    add(outcome, group);
  });
  std::vector<Group> sorted;
  for (auto& [key, group] : groups) sorted.push_back(std::move(group));
  std::stable_sort(sorted.begin(), sorted.end(), [](const Group& a, const Group& b) {
    const auto order = [](const Group& g) {
      return std::tuple(g.is_error, g.severity, g.tests, g.disagreements);
    };
    return order(a) > order(b);
  });
  return sorted;
}

// A message in GitHub's encoding: line ends become %0A, and "%" becomes %25.
std::string escaped_data(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '%')
      escaped += "%25";
    else if (c == '\r')
      escaped += "%0D";
    else if (c == '\n')
      escaped += "%0A";
    else
      escaped += c;
  }
  return escaped;
}

// A property's value in the same encoding, in which ":" and "," are encoded, too.
std::string escaped_property(std::string_view text) {
  std::string escaped;
  for (const char c : escaped_data(text)) {
    if (c == ':')
      escaped += "%3A";
    else if (c == ',')
      escaped += "%2C";
    else
      escaped += c;
  }
  return escaped;
}

std::string place_of(const Group& group, const PathInRepository& path_of) {
  if (group.file.empty()) return "";
  return fmt::format("file={},line={},", escaped_property(xml_text(path_of(group.file))),
                     std::max(1, group.line));
}

std::string command_of(const Group& group, const PathInRepository& path_of) {
  std::string message = shortened(group.message, kMostOfMessage);
  while (message.ends_with('\n')) message.pop_back();
  const bool is_error = group.is_error;
  if (group.tests == 2)
    message += fmt::format("\nOne more test of this file {}.", is_error ? "fails" : "is contested");
  if (group.tests > 2)
    message += fmt::format("\n{} more tests of this file {}.", group.tests - 1,
                           is_error ? "fail" : "are contested");
  return fmt::format("::{} {}title={}::{}", is_error ? "error" : "warning",
                     place_of(group, path_of),
                     escaped_property(shortened(group.title, kMostOfTitle)), escaped_data(message));
}

}  // namespace

void write_annotations(const Results& results, const PathInRepository& path_of, std::ostream& out) {
  const std::vector<Group> groups = groups_of(results);
  const std::size_t listed = std::min(kMostAnnotations, groups.size());
  for (std::size_t i = 0; i < listed; ++i) out << command_of(groups[i], path_of) << '\n';
  if (listed < groups.size())
    out << fmt::format("::notice title=edgecase::{} not shown; the report has them all\n",
                       counted(groups.size() - listed, "more is", "more are"));
}

}  // namespace edgecase
