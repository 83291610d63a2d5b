// SPDX-License-Identifier: MIT
#include "casefile/policy_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace edgecase {
namespace {

const std::vector<KnownRule> kKnown{{"triangle.fill-rule", {"left-top", "left-bottom"}},
                                    {"line.snap", {"none", "8-half-even"}}};

LoadedPolicy load(const std::string& text) {
  return load_policy_text(text, "p.json", kKnown);
}

struct Fault {
  const char* text;
  int line;
  const char* pointer;
  const char* message;
  const char* remedy;
};

TEST(PolicyReader, ReadsEveryField) {
  const LoadedPolicy loaded = load(R"({"$schema": "x", "why": "because", "name": "mine",
    "latitude": "none", "rules": {"triangle.fill-rule": "left-bottom"},
    "surfaces": {"fbo": {"line.snap": "none"}, "window": {"line.snap": "8-half-even"}}})");
  ASSERT_TRUE(loaded.value.has_value());
  EXPECT_EQ(loaded.value->name, "mine");
  EXPECT_EQ(loaded.value->latitude, Latitude::none);
  EXPECT_EQ(loaded.value->rules, (Choices{{"triangle.fill-rule", "left-bottom"}}));
  EXPECT_EQ(loaded.value->surfaces.at(Surface::fbo), (Choices{{"line.snap", "none"}}));
  EXPECT_EQ(loaded.value->surfaces.at(Surface::window), (Choices{{"line.snap", "8-half-even"}}));
}

TEST(PolicyReader, LeavesDefaults) {
  const LoadedPolicy loaded = load(R"({"name": "plain"})");
  ASSERT_TRUE(loaded.value.has_value());
  EXPECT_EQ(loaded.value->latitude, Latitude::opengl);
  EXPECT_TRUE(loaded.value->rules.empty());
  EXPECT_TRUE(loaded.value->surfaces.empty());
  EXPECT_TRUE(load_policy_text(R"({"name": "n", "rules": {"any.rule": "any"}})", "p.json", {})
                  .value.has_value());
}

TEST(PolicyReader, NamesEachFault) {
  const Fault faults[] = {
      {"[]", 1, "", "must be an object", "{"},
      {"{}", 1, "", "lacks \"name\"", "add"},
      {"{\"name\": 5}", 1, "/name", "must be a string", "quotes"},
      {"{\"name\": \"\"}", 1, "/name", "0 characters", "1 to 100"},
      {"{\"name\": \"a\",\n\"lattitude\": \"none\"}", 2, "/lattitude", "no key",
       "did you mean \"latitude\"?"},
      {"{\"name\": \"a\",\n\"latitude\": \"wide\"}", 2, "/latitude", "cannot be", "opengl, none"},
      {"{\"name\": \"a\", \"rules\": []}", 1, "/rules", "must be an object", "{"},
      {"{\"name\": \"a\", \"rules\": {\"Fill\": \"left-top\"}}", 1, "/rules/Fill", "no rule's id",
       "line.diamond-exit"},
      {"{\"name\": \"a\", \"rules\": {\"triangle.fillrule\": \"left-top\"}}", 1,
       "/rules/triangle.fillrule", "there is no rule", "did you mean \"triangle.fill-rule\"?"},
      {"{\"name\": \"a\", \"rules\": {\"line.snap\": 8}}", 1, "/rules/line.snap",
       "must be a string", "quotes"},
      {"{\"name\": \"a\", \"rules\": {\"line.snap\": \"nope\"}}", 1, "/rules/line.snap",
       "no alternative \"nope\"", "none"},
      {"{\"name\": \"a\", \"surfaces\": {\"windows\": {}}}", 1, "/surfaces/windows", "no key",
       "did you mean \"window\"?"},
      {"{\"name\": \"a\", \"surfaces\": {\"window\": {\"line.snap\": \"no\"}}}", 1,
       "/surfaces/window/line.snap", "no alternative \"no\"", "none"},
      {"{\"name\": \"a\", \"surfaces\": {\"fbo\": {\"line.snap\": \"non\"}}}", 1,
       "/surfaces/fbo/line.snap", "no alternative", "did you mean \"none\"?"},
      {"{\"name\": \"a\", \"name\": \"b\"}", 1, "/name", "stands twice", "keep one"},
      {"{\"name\": \"a\"", 1, "", "the text ends", "close"},
  };
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.text);
    const LoadedPolicy loaded = load(fault.text);
    EXPECT_FALSE(loaded.value.has_value());
    ASSERT_EQ(loaded.diagnostics.size(), 1U);
    EXPECT_EQ(loaded.diagnostics[0].line, fault.line);
    EXPECT_EQ(loaded.diagnostics[0].pointer, fault.pointer);
    EXPECT_NE(loaded.diagnostics[0].message.find(fault.message), std::string::npos)
        << loaded.diagnostics[0].message;
    EXPECT_NE(loaded.diagnostics[0].remedy.find(fault.remedy), std::string::npos)
        << loaded.diagnostics[0].remedy;
  }
}

TEST(PolicyReader, CollectsAllFaults) {
  EXPECT_EQ(load(R"({"latitude": 1, "rules": {"x.y": "z", "line.snap": "q"}, "extra": 0})")
                .diagnostics.size(),
            5U);
}

TEST(PolicyReader, ReportsAMissingFile) {
  const LoadedPolicy loaded = load_policy("no/such/policy.json", kKnown);
  EXPECT_FALSE(loaded.value.has_value());
  ASSERT_EQ(loaded.diagnostics.size(), 1U);
  EXPECT_EQ(loaded.diagnostics[0].file, "no/such/policy.json");
}

}  // namespace
}  // namespace edgecase
