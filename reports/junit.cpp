// SPDX-License-Identifier: MIT
#include "reports/junit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ostream>
#include <pugixml.hpp>
#include <string>

#include "reports/test_outcomes.h"
#include "reports/text.h"

namespace edgecase {
namespace {

// Unknown durations are omitted.
void add_time(pugi::xml_node node, double seconds) {
  if (seconds > 0) node.append_attribute("time") = fmt::format("{:.6f}", seconds).c_str();
}

struct Counts {
  int tests = 0;
  int failures = 0;
  int errors = 0;
  int skipped = 0;
  double seconds = 0;

  void add(TestStatus status, double took) {
    seconds += took;
    ++tests;
    failures += status == TestStatus::failed;
    errors += status == TestStatus::error;
    skipped += status == TestStatus::skipped;
  }

  void write(pugi::xml_node node) const {
    node.append_attribute("tests") = tests;
    node.append_attribute("failures") = failures;
    node.append_attribute("errors") = errors;
    node.append_attribute("skipped") = skipped;
    add_time(node, seconds);
  }
};

const char* element_of(TestStatus status) {
  switch (status) {
    case TestStatus::passed:
      break;
    case TestStatus::skipped:
      return "skipped";
    case TestStatus::failed:
      return "failure";
    case TestStatus::error:
      return "error";
  }
  return "";
}

void add_property(const char* name, const std::string& value, pugi::xml_node properties) {
  pugi::xml_node property = properties.append_child("property");
  property.append_attribute("name") = name;
  property.append_attribute("value") = one_line(value).c_str();
}

// The document under construction. A suite's counts are written when the next suite begins.
class Document {
 public:
  Document(pugi::xml_node root, const Results& results, const Durations& durations)
      : root_(root), results_(results), durations_(durations) {}

  void add(const TestOutcome& outcome) {
    if (outcome.suite.front() != suite_.attribute("name").as_string()) begin(outcome);
    const double seconds = seconds_of(outcome, durations_);
    counts_.add(outcome.status, seconds);
    total_.add(outcome.status, seconds);
    pugi::xml_node test = suite_.append_child("testcase");
    test.append_attribute("classname") = fmt::format("{}", fmt::join(outcome.suite, ".")).c_str();
    test.append_attribute("name") = outcome.name.c_str();
    add_time(test, seconds);
    if (outcome.cluster != nullptr)
      add_property("group", title_of(*outcome.cluster), test.append_child("properties"));
    if (outcome.status == TestStatus::passed) {
      if (!outcome.message.empty())
        test.append_child("system-out").text().set(outcome.message.c_str());
      return;
    }
    pugi::xml_node node = test.append_child(element_of(outcome.status));
    node.append_attribute("message") = outcome.message.c_str();
    if (!outcome.details.empty())
      node.append_child(pugi::node_pcdata).set_value(outcome.details.c_str());
  }

  void end() {
    if (suite_) counts_.write(suite_);
    total_.write(root_);
  }

 private:
  void begin(const TestOutcome& outcome) {
    if (suite_) counts_.write(suite_);
    counts_ = {};
    suite_ = root_.append_child("testsuite");
    suite_.append_attribute("name") = outcome.suite.front().c_str();
    if (outcome.renderer != nullptr) add_portrait(*outcome.renderer);
  }

  // What all answers of the suite's renderer say of it.
  void add_portrait(const RendererInfo& renderer) {
    const auto index = static_cast<std::size_t>(&renderer - results_.renderers.data());
    const std::vector<std::string> sentences = sentences_of(portrait_of(results_, index));
    if (sentences.empty()) return;
    pugi::xml_node properties = suite_.append_child("properties");
    for (const std::string& sentence : sentences) add_property("portrait", sentence, properties);
  }

  pugi::xml_node root_;
  const Results& results_;
  const Durations& durations_;
  pugi::xml_node suite_;
  Counts counts_;  // of the suite
  Counts total_;
};

}  // namespace

void write_junit(const Results& results, const Durations& durations, std::ostream& out) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("testsuites");
  root.append_attribute("name") = one_line(results.tool + ", policy " + results.policy).c_str();
  Document tests(root, results, durations);
  visit_outcomes(results, [&tests](const TestOutcome& outcome) { tests.add(outcome); });
  tests.end();
  document.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
}

}  // namespace edgecase
