// SPDX-License-Identifier: MIT
#include "casefile/json/json_layout.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace edgecase {
namespace {

JsonPiece numbers(std::size_t count, const std::string& digits) {
  return json_array(std::vector<JsonPiece>(count, json_scalar(digits)));
}

TEST(JsonLayout, PutsWhatFitsOnOneLine) {
  EXPECT_EQ(lay_out(json_object({named("a", numbers(2, "1")), named("b", json_object({}))})),
            "{\"a\": [1, 1], \"b\": {}}\n");
  EXPECT_EQ(lay_out(json_string("a\"\n\xC3\xA9")), "\"a\\\"\\n\xC3\xA9\"\n");
}

TEST(JsonLayout, BreaksWhereItIsToldTo) {
  JsonPiece piece = json_object({named("a", numbers(2, "1")), named("b", json_scalar("2"))});
  piece.broken = true;
  EXPECT_EQ(lay_out(piece), "{\n  \"a\": [1, 1],\n  \"b\": 2\n}\n");
  // What stands round a broken value is broken, too.
  EXPECT_EQ(lay_out(json_array({piece})), "[\n  {\n    \"a\": [1, 1],\n    \"b\": 2\n  }\n]\n");
  JsonPiece empty = json_array({});
  empty.broken = true;
  EXPECT_EQ(lay_out(empty), "[]\n");
}

TEST(JsonLayout, LinesHaveAHundredCharactersAtMost) {
  // 24 numbers of two digits: 24 * 4 - 2 characters and two brackets.
  JsonPiece fits = numbers(24, "12");
  fits.children.back().text = "123456";  // 100 characters
  EXPECT_EQ(lay_out(fits).find('\n'), 100U);
  fits.children.back().text = "1234567";
  fits.together = 10;
  const std::string text = lay_out(fits);
  EXPECT_EQ(text.substr(0, 45), "[\n  12, 12, 12, 12, 12, 12, 12, 12, 12, 12,\n ");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
  // A comma behind the value counts.
  JsonPiece list = numbers(24, "12");
  list.children.back().text = "1234";  // 98 characters at an indent of two
  const JsonPiece both = json_array({list, list});
  EXPECT_NE(lay_out(both).substr(2, 5), "  [12");
}

}  // namespace
}  // namespace edgecase
