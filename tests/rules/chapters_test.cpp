// SPDX-License-Identifier: MIT
#include "rules/chapters.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "rules/all_rules.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream stream(EDGECASE_ROOT "/src/rules/" + path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The comment that an essay was, line for line.
std::string as_comment(std::string_view essay) {
  std::istringstream lines{std::string(essay)};
  std::string comment;
  for (std::string line; std::getline(lines, line);)
    comment += (line.empty() ? "//" : "// " + line) + "\n";
  return comment;
}

TEST(Chapters, HoldEveryRuleOnce) {
  std::multiset<std::string> taught;
  for (const Chapter& chapter : chapters())
    for (const Section& section : chapter.sections) {
      EXPECT_FALSE(section.rules.empty()) << section.title;
      for (const RuleId rule : section.rules) taught.insert(name_of(rule));
    }
  std::multiset<std::string> known;
  for (const Rule& rule : all_rules()) known.insert(name_of(rule.id));
  EXPECT_EQ(taught, known);
}

// An essay belongs to the rules below it: the header or the file beside it names each of them, but
// where one function makes several, by their ids.
TEST(Chapters, HaveTheEssayOfTheirRules) {
  std::set<std::string_view> essays;
  for (const Chapter& chapter : chapters())
    for (const Section& section : chapter.sections) {
      const std::string header(section.header);
      EXPECT_TRUE(essays.insert(essay_of(section)).second) << section.title;
      const std::string text = content_of(header + ".h");
      const std::string comment = as_comment(essay_of(section));
      const std::string titled = "// Essay: " + std::string(section.title) + "\n//\n";
      EXPECT_TRUE(text.find(comment + "#pragma once") != std::string::npos ||
                  text.find(titled + comment) != std::string::npos)
          << header;
      EXPECT_GE(essay_of(section).size(), 200u) << header << " has hardly an essay";
      if (text.find("_rule(RuleId ") != std::string::npos) continue;
      const std::string both = text + content_of(header + ".cpp");
      for (const RuleId rule : section.rules) {
        std::string enumerator = name_of(rule);
        for (char& c : enumerator)
          if (c == '.' || c == '-') c = '_';
        EXPECT_NE(both.find("RuleId::" + enumerator), std::string::npos) << header;
      }
    }
}

TEST(Chapters, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names = {"index"};
  for (const Chapter& chapter : chapters()) {
    EXPECT_TRUE(names.insert(chapter.name).second) << chapter.name;
    EXPECT_EQ(chapter.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string::npos);
  }
}

}  // namespace
}  // namespace edgecase
