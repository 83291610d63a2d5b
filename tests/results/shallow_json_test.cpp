// SPDX-License-Identifier: MIT
//
// What is nested deeper than the library's own calls may go is refused by every reader of results,
// and brackets in strings are no nesting.
#include "results/shallow_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "results/decisions.h"
#include "results/known_faults.h"
#include "results/results_json.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

// More levels than a stack of megabytes has calls.
constexpr std::size_t kDeep = 200'000;

std::string nested(std::size_t levels) {
  return std::string(levels, '[') + std::string(levels, ']');
}

std::string refusal(const std::string& text) {
  try {
    parse_shallow(text);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(ShallowJson, HasAHundredLevels) {
  EXPECT_EQ(parse_shallow(nested(kMostLevels)).dump(), nested(kMostLevels));
  EXPECT_THAT(refusal(nested(kMostLevels + 1)), HasSubstr("deeper than 100 levels"));
  EXPECT_THAT(refusal(std::string(kMostLevels + 1, '[')), HasSubstr("deeper"));
  // Objects count, and what is closed does not.
  std::string objects;
  for (std::size_t i = 0; i <= kMostLevels; ++i) objects += "{\"a\":";
  EXPECT_THAT(refusal(objects), HasSubstr("deeper"));
  std::string beside = "[";
  for (std::size_t i = 0; i < 3 * kMostLevels; ++i) beside += "[],{},";
  EXPECT_EQ(refusal(beside + "0]"), "");
}

TEST(ShallowJson, HasAMillionValues) {
  std::string text = "[0";
  for (int i = 2; i < 1 << 20; ++i) text += ",0";
  EXPECT_EQ(refusal(text + "]"), "");
  EXPECT_THAT(refusal(text + ",0,0]"), HasSubstr("more than 1048576 values"));
  EXPECT_NO_THROW(parse_line(text + ",0,0]"));
}

TEST(ShallowJson, TakesBracketsInStringsForText) {
  const std::string brackets(3 * kMostLevels, '[');
  for (const std::string& text :
       {brackets, "\\\"" + brackets, brackets + "\\\\", "\\\\\\\"" + brackets, "]" + brackets}) {
    const std::string whole = "[\"" + text + "\",[]]";
    EXPECT_EQ(refusal(whole), "") << whole;
  }
  // Behind a string that ends they are none.
  EXPECT_THAT(refusal("[\"\\\\\"," + brackets), HasSubstr("deeper"));
  EXPECT_THAT(refusal("[\"\"," + brackets), HasSubstr("deeper"));
  // What is no JSON is refused by the library.
  for (const char* broken : {"", "]", "\"", "\"\\", "[\"a]", "}{"}) EXPECT_NE(refusal(broken), "");
}

TEST(ShallowJson, NoReaderGoesDeeper) {
  const std::string deep = nested(kDeep);
  const auto results = read_results("{\"edgecase_results\":" + deep + "}");
  EXPECT_THAT(std::get<std::string>(results), HasSubstr("deeper"));
  const auto decisions = parse_decisions("{\"edgecase_decisions\":" + deep + "}");
  EXPECT_THAT(std::get<std::string>(decisions), HasSubstr("deeper"));
  for (const char* key : {"id", "reason", "rule"}) {
    const auto known = parse_known_faults("{\"driver\":\"a\",\"faults\":[{\"" + std::string(key) +
                                          "\":" + deep + "}]}");
    EXPECT_TRUE(std::holds_alternative<std::string>(known)) << key;
  }
}

}  // namespace
}  // namespace edgecase
