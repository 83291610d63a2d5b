// SPDX-License-Identifier: MIT
#include "reports/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "reports/text.h"

namespace edgecase {
namespace {

// A failure's body lists this many disagreements; the results file has all of them.
constexpr std::size_t kMaxListed = 20;

struct Counts {
  int tests = 0;
  int failures = 0;
  int errors = 0;
  int skipped = 0;
};

// One test suite under construction; counts are written when it is closed.
class Suite {
 public:
  Suite(pugi::xml_node root, const std::string& name) : node_(root.append_child("testsuite")) {
    node_.append_attribute("name") = name.c_str();
  }

  // Adds a test case that passes until one of the functions below is called for it. A name that
  // the suite already has gets a number, so that no consumer merges two test cases.
  pugi::xml_node add(const std::string& class_name, const std::string& name) {
    std::string unique = name;
    for (int n = 2; !names_.insert(unique).second; ++n) unique = fmt::format("{} ({})", name, n);
    pugi::xml_node test = node_.append_child("testcase");
    test.append_attribute("classname") = class_name.c_str();
    test.append_attribute("name") = unique.c_str();
    ++counts_.tests;
    return test;
  }

  void fail(pugi::xml_node test, const std::string& message, const std::string& body) {
    report(test, "failure", message, body);
    ++counts_.failures;
  }

  void error(pugi::xml_node test, const std::string& message, const std::string& body) {
    report(test, "error", message, body);
    ++counts_.errors;
  }

  void skip(pugi::xml_node test, const std::string& message) {
    report(test, "skipped", message, "");
    ++counts_.skipped;
  }

  void close(Counts& total) {
    node_.append_attribute("tests") = counts_.tests;
    node_.append_attribute("failures") = counts_.failures;
    node_.append_attribute("errors") = counts_.errors;
    node_.append_attribute("skipped") = counts_.skipped;
    total.tests += counts_.tests;
    total.failures += counts_.failures;
    total.errors += counts_.errors;
    total.skipped += counts_.skipped;
  }

 private:
  static void report(pugi::xml_node test, const char* kind, const std::string& message,
                     const std::string& body) {
    pugi::xml_node node = test.append_child(kind);
    node.append_attribute("message") = one_line(message).c_str();
    if (!body.empty()) node.append_child(pugi::node_pcdata).set_value(xml_text(body).c_str());
  }

  pugi::xml_node node_;
  std::set<std::string> names_;
  Counts counts_;
};

// "lines/diamond/tip" -> "RENDERER.lines.diamond".
std::string class_of(const std::string& suite, const std::string& id) {
  const std::size_t slash = id.rfind('/');
  if (slash == std::string::npos) return suite;
  std::string folder = one_line(id.substr(0, slash));
  std::replace(folder.begin(), folder.end(), '/', '.');
  return suite + "." + folder;
}

std::string failure_body(const Result& result, int samples) {
  std::string body;
  const std::size_t listed = std::min(kMaxListed, result.disagreements.size());
  for (std::size_t i = 0; i < listed; ++i)
    body += describe(result.disagreements[i], samples) + "\n";
  if (listed < result.disagreements.size())
    body += fmt::format("and {} more, see results\n", result.disagreements.size() - listed);
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty()) body += describe(values) + "\n";
  if (!result.expectation.empty()) body += "expectation: " + result.expectation + "\n";
  return body;
}

void write_result(Suite& suite, pugi::xml_node test, const Result& result, int samples) {
  const bool expected = result.standing == Standing::expected;
  if (result.verdict != Verdict::not_run) {
    if (!expected) suite.fail(test, headline(result), failure_body(result, samples));
    return;
  }
  const std::string reason = result.failure ? result.failure->reason : "no reason given";
  if (expected)
    suite.skip(test, fmt::format("{}: {}", headline(result), reason));
  else
    suite.error(test, headline(result), reason + "\n" + failure_body(result, samples));
}

void write_renderer(pugi::xml_node root, const Results& results, std::size_t index,
                    const std::string& name, Counts& total) {
  Suite suite(root, name);
  for (const CaseResults& one : results.cases) {
    if (index >= one.results.size()) continue;
    const pugi::xml_node test = suite.add(class_of(name, one.id), one_line(one.id));
    write_result(suite, test, one.results[index], one.samples.samples);
  }
  suite.close(total);
}

// One error per file, with all that is wrong with it.
void write_diagnostics(pugi::xml_node root, const Results& results, Counts& total) {
  if (results.diagnostics.empty()) return;
  std::vector<std::string> order;
  std::map<std::string, std::string> bodies;
  for (const Diagnostic& diagnostic : results.diagnostics) {
    std::string& body = bodies[diagnostic.file];
    if (body.empty()) order.push_back(diagnostic.file);
    body += to_string(diagnostic) + "\n";
  }
  Suite suite(root, "case files");
  for (const std::string& file : order)
    suite.error(suite.add("case files", one_line(file)), "the case file cannot be loaded",
                bodies[file]);
  suite.close(total);
}

void write_expect_failures(pugi::xml_node root, const Results& results, Counts& total) {
  const auto failed = [](const CaseResults& one) { return !one.expect_failures.empty(); };
  if (std::none_of(results.cases.begin(), results.cases.end(), failed)) return;
  Suite suite(root, "hand-drawn expectations");
  for (const CaseResults& one : results.cases)
    for (const std::string& failure : one.expect_failures)
      suite.fail(suite.add(class_of("hand-drawn expectations", one.id), one_line(one.id)),
                 "the exact rendering is not what the case's author drew", failure);
  suite.close(total);
}

void write_missing(pugi::xml_node root, const Results& results, Counts& total) {
  if (results.missing.empty()) return;
  Suite suite(root, "expectations");
  for (const MissingCase& missing : results.missing) {
    const std::string name = one_line(missing.renderer);
    suite.fail(suite.add("expectations." + name, one_line(missing.id)),
               fmt::format("missing: {} is expected of {}, and the suite has no such case",
                           name_of(missing.expected.verdict), name),
               "`edgecase bless --apply` removes the expectation: " + missing.reason);
  }
  suite.close(total);
}

void write_totals(pugi::xml_node root, const Counts& total) {
  root.append_attribute("tests") = total.tests;
  root.append_attribute("failures") = total.failures;
  root.append_attribute("errors") = total.errors;
  root.append_attribute("skipped") = total.skipped;
}

// A run that was stopped must not look like a small one that passed.
void write_interruption(pugi::xml_node root, const Results& results, Counts& total) {
  Suite suite(root, "run");
  suite.error(suite.add("run", "complete"), words_of_interruption(results), "");
  suite.close(total);
}

}  // namespace

void write_junit(const Results& results, std::ostream& out) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("testsuites");
  root.append_attribute("name") = one_line(results.tool + ", policy " + results.policy).c_str();
  Counts total;
  std::set<std::string> suites;
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const std::string base = one_line(results.renderers[r].name);
    std::string name = base;
    for (int n = 2; !suites.insert(name).second; ++n) name = fmt::format("{} ({})", base, n);
    write_renderer(root, results, r, name, total);
  }
  write_diagnostics(root, results, total);
  write_expect_failures(root, results, total);
  write_missing(root, results, total);
  if (results.interrupted) write_interruption(root, results, total);
  write_totals(root, total);
  document.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
}

}  // namespace edgecase
