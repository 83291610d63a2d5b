// SPDX-License-Identifier: MIT
#include "casefile/json/json_layout.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace edgecase {
namespace {

std::string formatted(std::string_view text) {
  const JsonDocument document = parse_json(text, "test");
  return document.root ? laid_out(*document.root) : "refused";
}

TEST(JsonFormat, SetsSpacesAndIndentation) {
  EXPECT_EQ(formatted("{\"a\" :[1,2,  3] ,\"b\":{}}"), "{\"a\": [1, 2, 3], \"b\": {}}\n");
  EXPECT_EQ(formatted("{\n\"a\": 1,\n      \"b\": [\n1]}"),
            "{\n  \"a\": 1,\n  \"b\": [\n    1\n  ]\n}\n");
}

TEST(JsonFormat, KeepsWhatWasBrokenAndWhatWasNot) {
  // A list of two to a line stays one; an object on one line stays there.
  const std::string text =
      "{\n  \"a\": [\n    1, 2,\n    3, 4,\n    5\n  ],\n  \"b\": {\"c\": 1, \"d\": [2]}\n}\n";
  EXPECT_EQ(formatted(text), text);
}

TEST(JsonFormat, KeepsDigitsAndTexts) {
  const std::string text =
      "[1.0, 1e2, -0, 0.10, \"21/2\", \"\xC3\xA9\\n\\\"\", true, false, null]\n";
  EXPECT_EQ(formatted(text), text);
  EXPECT_EQ(formatted("\"\\u00e9\""), "\"\xC3\xA9\"\n");
}

TEST(JsonFormat, BreaksLinesThatAreTooLong) {
  std::string list = "[1";
  for (int i = 0; i < 40; ++i) list += ", 1";
  const std::string once = formatted(list + "]");
  EXPECT_GT(std::count(once.begin(), once.end(), '\n'), 1);
  EXPECT_EQ(formatted(once), once);
}

}  // namespace
}  // namespace edgecase
