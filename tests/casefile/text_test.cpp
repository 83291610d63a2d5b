// SPDX-License-Identifier: MIT
#include "casefile/json/text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace edgecase {
namespace {

TEST(Text, KnowsWellFormedUtf8) {
  for (const char* good : {"", "abc", "\xC3\xA4", "\xE2\x82\xAC", "\xED\x9F\xBF", "\xEE\x80\x80",
                           "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_FALSE(find_invalid_utf8(good).has_value()) << good;
  for (const char* bad :
       {"\x80", "\xC0\x80", "\xC1\xBF", "\xC3", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xE2\x82",
        "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"})
    EXPECT_EQ(find_invalid_utf8(bad), 0U) << bad;
  EXPECT_EQ(find_invalid_utf8("ab\xFF"), 2U);
  EXPECT_EQ(count_characters("a\xC3\xA4\xE2\x82\xAC"), 3U);
}

TEST(Text, QuotesAndCutsBetweenCharacters) {
  EXPECT_EQ(quote("ab"), "\"ab\"");
  std::string text = "a";  // so that the cut would fall inside a character
  for (int i = 0; i < 60; ++i) text += "\xC3\xA4";
  const std::string quoted = quote(text);
  EXPECT_FALSE(find_invalid_utf8(quoted).has_value());
  EXPECT_TRUE(quoted.ends_with("...\""));
}

TEST(Text, CleansALineOfBytesAndControls) {
  EXPECT_EQ(clean_line("plain \xC3\xA4 \xF0\x90\x80\x80"), "plain \xC3\xA4 \xF0\x90\x80\x80");
  EXPECT_EQ(clean_line("a\x1B[2J\n\t\x7F"), "a?[2J???");
  EXPECT_EQ(clean_line("\xFF\xC3(\xED\xA0\x80\xE2\x82"), "?\?(?????");
  EXPECT_EQ(clean_line(std::string("\0", 1)), "?");
}

TEST(Text, CutsBetweenCharacters) {
  EXPECT_EQ(beginning_of("abc", 3), "abc");
  EXPECT_EQ(beginning_of("abc", 2), "ab");
  EXPECT_EQ(beginning_of("a\xE2\x82\xAC", 4), "a\xE2\x82\xAC");
  for (const std::size_t most : {1U, 2U, 3U}) EXPECT_EQ(beginning_of("a\xE2\x82\xAC", most), "a");
}

TEST(Text, NamesWhatMayHaveBeenMeant) {
  const std::vector<std::string> names{"width", "height", "samples"};
  EXPECT_EQ(nearest_name("widht", names), "width");
  EXPECT_EQ(nearest_name("hight", names), "height");
  EXPECT_EQ(nearest_name("sample", names), "samples");
  EXPECT_EQ(nearest_name("w", names), "width");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name("x", names), "");
  EXPECT_EQ(nearest_name("colour", names), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'w'), names), "");
  EXPECT_EQ(suggest_names("widht", names),
            "did you mean \"width\"? Allowed are width, height, samples");
  std::vector<std::string> many(31, "other");
  many.back() = "width";
  EXPECT_EQ(suggest_names("widht", many), "did you mean \"width\"?");
}

}  // namespace
}  // namespace edgecase
