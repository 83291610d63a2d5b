// SPDX-License-Identifier: MIT
#include "casefile/json/json_document.h"

#include <gtest/gtest.h>

#include <string>

namespace edgecase {
namespace {

TEST(JsonDocument, KeepsLinesOrderAndDigits) {
  const JsonDocument document = parse_json(
      "{\n"
      "  \"b\": [1,\n"
      "         -0.10e2,\n"
      "         \"x\\ny\"\n"
      "  ],\n"
      "  \"a\":\n"
      "    {\"t\": true, \"n\": null\n"
      "}}",
      "f.json");
  ASSERT_TRUE(document.root.has_value());
  EXPECT_TRUE(document.diagnostics.empty());
  const JsonNode& root = *document.root;
  ASSERT_EQ(root.children.size(), 2U);
  EXPECT_EQ(root.line, 1);
  const JsonNode& b = root.children[0];
  EXPECT_EQ(b.name, "b");
  EXPECT_EQ(b.line, 2);
  ASSERT_EQ(b.children.size(), 3U);
  EXPECT_EQ(b.children[0].text, "1");
  EXPECT_EQ(b.children[0].line, 2);
  EXPECT_EQ(b.children[1].text, "-0.10e2");
  EXPECT_EQ(b.children[1].line, 3);
  EXPECT_EQ(b.children[2].text, "x\ny");
  EXPECT_EQ(b.children[2].line, 4);
  const JsonNode* a = root.find("a");
  ASSERT_NE(a, nullptr);
  EXPECT_EQ(a->name_line, 6);
  EXPECT_EQ(a->line, 7);
  EXPECT_TRUE(a->children[0].truth);
  EXPECT_EQ(a->children[1].kind, JsonKind::null);
  EXPECT_EQ(root.find("c"), nullptr);
}

TEST(JsonDocument, NumberAtEndOfLineHasItsOwnLine) {
  const JsonDocument document = parse_json("[1\n,2\n\n\n]\n", "f.json");
  ASSERT_TRUE(document.root.has_value());
  EXPECT_EQ(document.root->children[0].line, 1);
  EXPECT_EQ(document.root->children[1].line, 2);
  const JsonDocument alone = parse_json("18446744073709551616123", "f.json");
  ASSERT_TRUE(alone.root.has_value());
  EXPECT_EQ(alone.root->text, "18446744073709551616123");
}

TEST(JsonDocument, NamesEveryDuplicateKeyByItsPointer) {
  const JsonDocument document =
      parse_json("{\"a/b\": [0, {\"x\": 1,\n\"x\": 2, \"x\": 3}], \"a/b\": 4}", "f.json");
  ASSERT_TRUE(document.root.has_value());
  ASSERT_EQ(document.diagnostics.size(), 3U);
  EXPECT_EQ(document.diagnostics[0].pointer, "/a~1b/1/x");
  EXPECT_EQ(document.diagnostics[0].line, 2);
  EXPECT_EQ(document.diagnostics[1].pointer, "/a~1b/1/x");
  EXPECT_EQ(document.diagnostics[2].pointer, "/a~1b");
  EXPECT_EQ(document.root->find("a/b")->kind, JsonKind::array);
}

std::string nested(std::size_t depth) {
  return std::string(depth, '[') + std::string(depth, ']');
}

TEST(JsonDocument, LimitsNestingAndSize) {
  EXPECT_TRUE(parse_json(nested(kMaxNesting), "f.json").root.has_value());
  EXPECT_FALSE(parse_json(nested(kMaxNesting + 1), "f.json").root.has_value());
  EXPECT_FALSE(parse_json(nested(400000), "f.json").root.has_value());
  const std::string space(kMaxFileBytes - 2, ' ');
  EXPECT_TRUE(parse_json("[]" + space, "f.json").root.has_value());
  const JsonDocument large = parse_json("[]" + space + " ", "f.json");
  EXPECT_FALSE(large.root.has_value());
  ASSERT_EQ(large.diagnostics.size(), 1U);
  EXPECT_EQ(large.diagnostics[0].line, 0);
}

// Whatever is cut off or garbled: exactly one finding, with a place and a remedy, and no crash.
TEST(JsonDocument, SurvivesEveryTruncationAndEveryForeignByte) {
  const std::string text = R"({"a": [1.5e3, "\u00e9\n", true], "b": {"c": null, "d": -0}})";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const JsonDocument cut = parse_json(text.substr(0, i), "f.json");
    EXPECT_FALSE(cut.root.has_value());
    EXPECT_EQ(cut.diagnostics.size(), 1U);
    for (const char foreign : {'x', '"', '\\', '{', '}', ']', ',', ':', '0', '-', '\n', '\x01',
                               '\'', '/', '#', '\x7f'}) {
      std::string garbled = text;
      garbled[i] = foreign;
      const JsonDocument document = parse_json(garbled, "f.json");
      if (document.root) continue;
      ASSERT_EQ(document.diagnostics.size(), 1U) << garbled;
      EXPECT_GT(document.diagnostics[0].line, 0);
      EXPECT_FALSE(document.diagnostics[0].remedy.empty());
    }
  }
}

}  // namespace
}  // namespace edgecase
