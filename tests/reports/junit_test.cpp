// SPDX-License-Identifier: MIT
#include "reports/junit.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>

#include "reports/ctrf.h"
#include "tests/reports/sample.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

std::string junit_of(const Results& results) {
  std::ostringstream out;
  write_junit(results, {}, out);
  return out.str();
}

// One renderer, one case with the given result.
Results single(const Result& result) {
  Results results;
  results.tool = "edgecase";
  results.policy = "opengl";
  results.renderers.resize(1);
  results.renderers[0].name = "osmesa:llvmpipe";
  CaseResults one;
  one.id = "lines/a/tip";
  one.results = {result};
  results.cases.push_back(one);
  return results;
}

pugi::xml_document parse(const std::string& text) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_string(text.c_str());
  EXPECT_TRUE(parsed) << parsed.description();
  return document;
}

pugi::xml_node first_test(const pugi::xml_document& document) {
  return document.child("testsuites").child("testsuite").child("testcase");
}

Result result_of(Verdict verdict, Standing standing) {
  Result result;
  result.verdict = verdict;
  result.standing = standing;
  if (verdict == Verdict::not_run)
    result.failure = Failure{FailureKind::timed_out, "no answer in 5 s"};
  return result;
}

TEST(Junit, ParsesWithUniqueNamesAndRightCounts) {
  const Results results = sample::results();
  const pugi::xml_document document = parse(junit_of(results));
  std::set<std::string> names;
  int tests = 0, failures = 0, errors = 0, skipped = 0;
  const pugi::xml_node root = document.child("testsuites");
  for (pugi::xml_node suite : root.children("testsuite"))
    for (pugi::xml_node test : suite.children("testcase")) {
      ++tests;
      failures += !test.child("failure").empty();
      errors += !test.child("error").empty();
      skipped += !test.child("skipped").empty();
      const std::string name = test.attribute("classname").as_string() + std::string("\n") +
                               test.attribute("name").as_string();
      EXPECT_TRUE(names.insert(name).second) << name;
    }
  // Every case and renderer, the two broken files and the two unmet hand-drawn truths.
  EXPECT_EQ(tests, static_cast<int>(results.cases.size()) * 4 + 2 + 2);
  EXPECT_EQ(root.attribute("tests").as_int(), tests);
  EXPECT_EQ(root.attribute("failures").as_int(), failures);
  EXPECT_EQ(root.attribute("errors").as_int(), errors);
  EXPECT_EQ(root.attribute("skipped").as_int(), skipped);
  EXPECT_GT(failures, 0);
  EXPECT_GT(errors, 2);
  EXPECT_GT(skipped, 0);
}

TEST(Junit, ExpectedResultsPassWhateverTheirVerdict) {
  for (Verdict verdict :
       {Verdict::agree, Verdict::convention, Verdict::permitted, Verdict::violation}) {
    const auto document = parse(junit_of(single(
        result_of(verdict, verdict == Verdict::violation ? Standing::known : Standing::expected))));
    EXPECT_TRUE(first_test(document).first_child().empty()) << name_of(verdict);
  }
}

TEST(Junit, EverythingElseFails) {
  for (Standing standing : {Standing::unexpected, Standing::flake}) {
    const Verdict verdict = Verdict::violation;
    const auto document = parse(junit_of(single(result_of(verdict, standing))));
    const std::string message =
        first_test(document).child("failure").attribute("message").as_string();
    EXPECT_NE(message.find(name_of(standing)), std::string::npos) << message;
    EXPECT_NE(message.find(name_of(verdict)), std::string::npos) << message;
  }
}

TEST(Junit, SkippedOnlyWhenNotSupportedOrKnownNotToRun) {
  for (Standing standing : {Standing::known, Standing::tolerated}) {
    const auto known = parse(junit_of(single(result_of(Verdict::not_run, standing))));
    const std::string reason = first_test(known).child("skipped").attribute("message").as_string();
    EXPECT_NE(reason.find("no answer in 5 s"), std::string::npos) << reason;
  }
  for (Standing standing : {Standing::unexpected, Standing::flake}) {
    const auto document = parse(junit_of(single(result_of(Verdict::not_run, standing))));
    EXPECT_TRUE(first_test(document).child("skipped").empty());
    EXPECT_NE(std::string(first_test(document).child("error").text().get()).find("no answer"),
              std::string::npos);
  }
}

TEST(Junit, ListsTwentyDisagreementsAndCountsTheRest) {
  Result result = result_of(Verdict::violation, Standing::unexpected);
  for (int x = 0; x < 25; ++x)
    result.disagreements.push_back(sample::disagreement(x, 0, DisagreementKind::extra, false));
  const auto document = parse(junit_of(single(result)));
  const std::string body = first_test(document).child("failure").text().get();
  EXPECT_NE(body.find("Pixel (19, 0) differs."), std::string::npos);
  EXPECT_EQ(body.find("Pixel (20, 0) differs."), std::string::npos);
  EXPECT_NE(body.find("and 5 more, see results"), std::string::npos);
}

TEST(Junit, APropertyTellsTheGroupOfAnUnexpectedAnswer) {
  Result result = result_of(Verdict::violation, Standing::unexpected);
  result.disagreements = {sample::disagreement(1, 2, DisagreementKind::extra, false)};
  const pugi::xml_document document = parse(junit_of(single(result)));
  const pugi::xml_node property = first_test(document).child("properties").child("property");
  EXPECT_STREQ(property.attribute("name").as_string(), "group");
  EXPECT_EQ(property.attribute("value").as_string(),
            std::string(name_of(result.disagreements[0].rule)) + " extra");

  result.standing = Standing::known;
  EXPECT_FALSE(first_test(parse(junit_of(single(result)))).child("properties"));
}

TEST(Junit, ClassIsTheRendererAndTheFolder) {
  const auto document = parse(junit_of(single(result_of(Verdict::agree, Standing::expected))));
  EXPECT_STREQ(first_test(document).attribute("classname").as_string(), "osmesa:llvmpipe.lines.a");
  EXPECT_STREQ(first_test(document).attribute("name").as_string(), "lines/a/tip");
}

TEST(Junit, ARendererNamedTwiceHasTwoSuites) {
  Results results = single(result_of(Verdict::agree, Standing::expected));
  results.renderers.push_back(results.renderers[0]);
  edit(results.cases, 0)->results.push_back(results.cases[0].results[0]);
  const auto document = parse(junit_of(results));
  std::set<std::string> names;
  for (pugi::xml_node suite : document.child("testsuites").children("testsuite"))
    EXPECT_TRUE(names.insert(suite.attribute("name").as_string()).second);
  EXPECT_EQ(names.size(), 2u);
}

TEST(Junit, AnInterruptedRunIsAnError) {
  Results results = single(result_of(Verdict::agree, Standing::expected));
  results.interrupted = true;
  EXPECT_EQ(parse(junit_of(results)).child("testsuites").attribute("errors").as_int(), 1);
  results.left_out = 7;
  EXPECT_NE(junit_of(results).find("The run was interrupted; 7 cases are missing."),
            std::string::npos);
}

// Whichever of its answers agrees.
TEST(Junit, AFlakeIsAFailureOrAnError) {
  for (Verdict verdict : {Verdict::agree, Verdict::violation, Verdict::not_run}) {
    const Results results = single(result_of(verdict, Standing::flake));
    const pugi::xml_document document = parse(junit_of(results));
    const pugi::xml_node root = document.child("testsuites");
    EXPECT_EQ(root.attribute("failures").as_int() + root.attribute("errors").as_int(), 1);
  }
}

TEST(Junit, AKnownFaultThatHasGrownIsAFailure) {
  Results results = single(result_of(Verdict::agree, Standing::expected));
  results.faults = {{"osmesa:llvmpipe", "joints", "why", "", 3, 2, FaultState::grown},
                    {"osmesa:llvmpipe", "others", "why", "", 1, 2, FaultState::shrunk}};
  const pugi::xml_document document = parse(junit_of(results));
  const pugi::xml_node root = document.child("testsuites");
  EXPECT_EQ(root.attribute("failures").as_int(), 1);
  const pugi::xml_node test = root.last_child().child("testcase");
  EXPECT_STREQ(test.attribute("name").as_string(), "joints");
  EXPECT_STREQ(test.attribute("classname").as_string(), "known faults.osmesa:llvmpipe");
}

TEST(Junit, SameResultsSameBytes) {
  EXPECT_EQ(junit_of(sample::results()), junit_of(sample::results()));
}

TEST(Junit, TellsTimesWhereTheyAreKnown) {
  const Results results = sample::results();
  const std::string id = results.cases[1].id;
  const std::string renderer = results.renderers[0].name;
  std::ostringstream junit;
  write_junit(results, {{id, {{renderer, 0.25}, {"another", 7}}}}, junit);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(junit.str().c_str()));
  int times = 0;
  for (const auto& found : document.select_nodes("//testcase[@time]")) {
    ++times;
    EXPECT_EQ(std::string(found.node().attribute("time").value()), "0.250000");
    EXPECT_EQ(std::string(found.node().attribute("name").value()), id);
  }
  EXPECT_EQ(times, 1);
  EXPECT_EQ(document.child("testsuites").attribute("time").as_double(), 0.25);
  EXPECT_EQ(junit_of(results).find("time="), std::string::npos);
}

TEST(Ctrf, TellsTimesInMilliseconds) {
  const Results results = sample::results();
  std::ostringstream ctrf;
  write_ctrf(results, {{results.cases[1].id, {{results.renderers[0].name, 0.2504}}}}, ctrf);
  EXPECT_NE(ctrf.str().find("\"duration\":250,"), std::string::npos);
}

}  // namespace
}  // namespace edgecase
