// SPDX-License-Identifier: MIT
#include "reports/test_outcomes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <string>

#include "reports/explain_command.h"
#include "reports/text.h"
#include "results/worst_first.h"

namespace edgecase {
namespace {

// Details list at most this many disagreements; the results file has more of them.
constexpr std::size_t kMostListed = 20;
// The longest line of a disagreement in bytes. Our own sentences are shorter; a renderer's may be
// of any length.
constexpr std::size_t kMostOfLine = 1000;

constexpr std::size_t kMostBytes = 24'000'000;  // of XML, of all tests
constexpr std::size_t kMarkup = 160;            // at most, around the texts of one test

constexpr std::size_t kProperties = 120;  // at most, of a test with a group, without its title

// Bytes that the text takes in an attribute or element of XML.
std::size_t size_in_xml(std::string_view text) {
  std::size_t size = text.size();
  for (const char c : text) {
    if (c == '&' || c == '"') size += 5;
    if (c == '<' || c == '>') size += 3;
  }
  return size;
}

std::string line_of(const std::string& text) {
  return xml_text(shortened(text, kMostOfLine)) + "\n";
}

// The lines below the disagreements.
std::string ending_of(const CaseResults& one, const Result& result, const Results& results,
                      const RendererInfo& renderer) {
  std::string text;
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty()) text += line_of(describe(values));
  if (!result.standing_reason.empty()) text += line_of("standing: " + result.standing_reason);
  ExplainCommand command{one.file, one.id, asked_as(renderer), results.policy, {}};
  if (!result.disagreements.empty()) {
    const Disagreement& worst = *worst_first(result).front();
    command.pixel = {worst.x, worst.y};
  }
  return text + line_of("explained by: " + command_line(command));
}

// The title, the reason for a missing answer, as many disagreements as fit, and the lines below
// them; empty if nothing fits. `most`: bytes of XML.
std::string details_of(const CaseResults& one, const Result& result, const std::string& ending,
                       std::size_t most) {
  std::string text = one.title.empty() ? "" : line_of(one.title);
  if (result.failure) text += line_of(result.failure->reason);
  std::size_t size = size_in_xml(text) + size_in_xml(ending) + 40;  // "and … more"
  if (size > most) return "";
  const std::vector<const Disagreement*> disagreements = worst_first(result);
  std::size_t listed = 0;
  for (; listed < std::min(kMostListed, result.disagreements.size()); ++listed) {
    const std::string line = line_of(describe(*disagreements[listed], one.samples.samples));
    size += size_in_xml(line);
    if (size > most) break;
    text += line;
  }
  if (const std::size_t left = count_disagreements(result) - listed; left > 0)
    text += fmt::format("and {} more, see results\n", left);
  return text + ending;
}

// "lines/diamond/tip" -> "lines", "diamond".
void append_folders(const std::string& id, std::vector<std::string>& suite) {
  std::size_t begin = 0;
  for (std::size_t end = id.find('/'); end != std::string::npos; end = id.find('/', begin)) {
    if (end > begin) suite.push_back(one_line(id.substr(begin, end - begin)));
    begin = end + 1;
  }
}

// True if the test has a message: neither expected nor known results have one.
bool is_told(const ResultOutline& answer) {
  return answer.standing != Standing::expected && answer.standing != Standing::known;
}

// The line that "FILE:LINE: …" names, or 0.
int line_named(const std::string& text, const std::string& file) {
  if (!text.starts_with(file + ":")) return 0;
  int line = 0;
  std::from_chars(text.data() + file.size() + 1, text.data() + text.size(), line);
  return line;
}

// What all answers of each renderer come to, where some are not as expected.
struct RunCauses {
  explicit RunCauses(const Results& results) {
    if (count_unexpected(results) == 0) return;
    clusters = clusters_of(results);
    for (std::size_t r = 0; r < results.renderers.size(); ++r)
      portraits.push_back(portrait_of(results, r));
  }
  const Cluster* of(const CaseResults& one, std::size_t renderer) const {
    const Result& result = one.results[renderer];
    return renderer < portraits.size() && is_unexpected(result.standing)
               ? told_by(one, result, portraits[renderer], clusters[renderer])
               : nullptr;
  }

  std::vector<std::vector<Cluster>> clusters;
  std::vector<Portrait> portraits;
};

class Visit {
 public:
  // `most`: bytes of XML for the details of one test.
  Visit(const Results& results, const RunCauses& causes, std::size_t most, const TestSink& sink)
      : results_(results), causes_(causes), most_(most), sink_(sink) {}

  void all() {
    for (std::size_t r = 0; r < results_.renderers.size(); ++r) visit_renderer(r);
    visit_diagnostics();
    visit_expect_failures();
    visit_grown_faults();
    visit_run();
  }

 private:
  // Adds a number to a name that is already used.
  static std::string unique(const std::string& name, std::set<std::string>& names) {
    std::string result = name;
    for (int n = 2; !names.insert(result).second; ++n) result = fmt::format("{} ({})", name, n);
    return result;
  }

  void begin(const std::string& suite) {
    suite_ = unique(one_line(suite), suites_);
    names_.clear();
  }

  TestOutcome test(const std::string& name) {
    TestOutcome outcome;
    outcome.suite = {suite_};
    outcome.name = unique(one_line(name), names_);
    return outcome;
  }

  TestOutcome test_of(const CaseResults& one) {
    TestOutcome outcome = test(one.id);
    append_folders(one.id, outcome.suite);
    outcome.file = one.file;
    return outcome;
  }

  void visit_renderer(std::size_t index) {
    const std::string& name = results_.renderers[index].name;
    begin(name);
    for (const std::size_t i : order_of(index)) {
      const CaseResults one = results_.cases[i];
      const Result& result = one.results[index];
      TestOutcome outcome = test_of(one);
      outcome.one = &one;
      outcome.result = &result;
      outcome.renderer = &results_.renderers[index];
      outcome.cluster = causes_.of(one, index);
      describe_result(results_.renderers[index], outcome);
      sink_(outcome);
    }
  }

  // Indices of cases: those whose answer is not as expected, the worst first, then the others.
  std::vector<std::size_t> order_of(std::size_t renderer) const {
    std::vector<std::size_t> order;
    for (const AnswerPlace& place : told_)
      if (place.renderer == renderer) order.push_back(place.one);
    for (std::size_t i = 0; i < results_.cases.size(); ++i) {
      const std::vector<ResultOutline>& answers = results_.cases.outline(i).answers;
      if (renderer < answers.size() && !is_told(answers[renderer])) order.push_back(i);
    }
    return order;
  }

  void describe_result(const RendererInfo& renderer, TestOutcome& outcome) const {
    const Result& result = *outcome.result;
    const bool was_run = !result.failure;
    if (was_run && result.standing <= Standing::known) return;
    outcome.message = one_line(headline(result));
    if (!is_unexpected(result.standing)) {
      if (!was_run) outcome.status = TestStatus::skipped;
      const std::string why = was_run ? first_explanation(result, outcome.one->samples.samples)
                                      : result.failure->reason;
      outcome.message += ": " + one_line(shortened(why, kMostOfLine));
      return;
    }
    outcome.status = was_run ? TestStatus::failed : TestStatus::error;
    const CaseResults& one = *outcome.one;
    outcome.details = details_of(one, result, ending_of(one, result, results_, renderer), most_);
  }

  // One error per file, with all its faults.
  void visit_diagnostics() {
    std::vector<TestOutcome> files;
    std::map<std::string, std::size_t> indices;
    begin("case files");
    for (const Diagnostic& diagnostic : results_.diagnostics) {
      const auto [found, is_new] = indices.try_emplace(diagnostic.file, files.size());
      if (is_new) {
        files.push_back(test(diagnostic.file));
        files.back().status = TestStatus::error;
        files.back().message = "the case file cannot be loaded";
        files.back().file = diagnostic.file;
        files.back().line = diagnostic.line;
      }
      files[found->second].details += line_of(to_string(diagnostic));
    }
    for (const TestOutcome& file : files) sink_(file);
  }

  void visit_expect_failures() {
    begin("hand-drawn expectations");
    for (std::size_t i = 0; i < results_.cases.size(); ++i) {
      if (results_.cases.outline(i).expect_failures == 0) continue;
      const CaseResults one = results_.cases[i];
      for (const std::string& failure : one.expect_failures) {
        TestOutcome outcome = test_of(one);
        outcome.status = TestStatus::failed;
        outcome.message = "the exact rendering is not what the case's author drew";
        outcome.details = line_of(failure);
        outcome.line = line_named(failure, one.file);
        sink_(outcome);
      }
    }
  }

  void visit_grown_faults() {
    begin("known faults");
    for (const FaultSeen& seen : results_.faults) {
      if (seen.state != FaultState::grown) continue;
      TestOutcome outcome = test(seen.id);
      outcome.suite.push_back(one_line(seen.renderer));
      outcome.status = TestStatus::failed;
      outcome.message = describe(seen);
      outcome.details = line_of(seen.reason);
      sink_(outcome);
    }
  }

  // A run that was interrupted, or of which a renderer drew nothing, must not look like one that
  // passed.
  void visit_run() {
    begin("run");
    if (results_.interrupted) report_run("complete", words_of_interruption(results_));
    for (const std::size_t r : idle_renderers(results_))
      report_run(results_.renderers[r].name + " draws", words_of_idleness(results_, r));
  }

  void report_run(const std::string& name, const std::string& message) {
    TestOutcome outcome = test(name);
    outcome.status = TestStatus::error;
    outcome.message = message;
    sink_(outcome);
  }

  const Results& results_;
  const RunCauses& causes_;
  std::size_t most_;
  const TestSink& sink_;
  const std::vector<AnswerPlace> told_ = worst_first(results_, is_told);
  std::string suite_;
  std::set<std::string> suites_;
  std::set<std::string> names_;  // of the suite
};

// The bytes for the details of one test, so that all tests together stay below kMostBytes.
std::size_t share_of_details(const Results& results, const RunCauses& causes) {
  std::size_t tests = 0;
  std::size_t size = 0;
  const TestSink measure = [&](const TestOutcome& outcome) {
    for (const std::string& suite : outcome.suite) size += size_in_xml(suite) + 1;
    size += kMarkup + size_in_xml(outcome.name) + size_in_xml(outcome.message) +
            size_in_xml(outcome.details);
    if (outcome.cluster != nullptr) size += kProperties + size_in_xml(title_of(*outcome.cluster));
    if (outcome.result != nullptr && outcome.status >= TestStatus::failed) ++tests;
  };
  Visit(results, causes, 0, measure).all();
  return size < kMostBytes && tests > 0 ? (kMostBytes - size) / tests : 0;
}

}  // namespace

void visit_outcomes(const Results& results, const TestSink& sink) {
  const RunCauses causes(results);
  Visit(results, causes, share_of_details(results, causes), sink).all();
}

double seconds_of(const TestOutcome& outcome, const Durations& durations) {
  return outcome.one == nullptr ? 0
                                : seconds_of(durations, outcome.one->id, outcome.renderer->name);
}

}  // namespace edgecase
