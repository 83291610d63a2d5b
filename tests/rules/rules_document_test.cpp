// SPDX-License-Identifier: MIT
#include "rules/rules_document.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "rules/all_rules.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

std::string committed() {
  std::ifstream stream(EDGECASE_ROOT "/src/rules/RULINGS.md", std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The first line in which two texts differ, of both.
std::string first_difference(const std::string& a, const std::string& b) {
  std::istringstream left(a);
  std::istringstream right(b);
  std::string x;
  std::string y;
  for (int line = 1;; ++line) {
    const bool more = static_cast<bool>(std::getline(left, x));
    const bool others = static_cast<bool>(std::getline(right, y));
    if (!more && !others) return "none";
    if (more != others || x != y)
      return "line " + std::to_string(line) + "\n  committed: " + (more ? x : "(end)") +
             "\n  generated: " + (others ? y : "(end)");
  }
}

TEST(RulesDocument, IsTheCommittedFile) {
  EXPECT_TRUE(committed() == rules_document())
      << "src/rules/RULINGS.md is not what the rules say; renew it, from the repository's root, "
         "by\n"
      << "  build/release/bin/edgecase rules --markdown > src/rules/RULINGS.md\n"
      << "First difference: " << first_difference(committed(), rules_document());
}

TEST(RulesDocument, HoldsEveryRuleAndEveryRulingInOrder) {
  const std::string text = rules_document();
  std::size_t at = text.find("\n## Rulings\n");
  std::set<int> numbers;
  for (const Rule& rule : all_rules())
    for (const Ruling& ruling : rule.rulings) numbers.insert(ruling.number);
  for (const int number : numbers) {
    const std::size_t next = text.find("\n### Ruling " + std::to_string(number) + "\n", at);
    ASSERT_NE(next, std::string::npos) << number;
    at = next;
  }
  at = text.find("\n## Rules\n", at);
  for (const Rule& rule : all_rules()) {
    const std::size_t next = text.find(std::string("\n### ") + name_of(rule.id) + "\n", at);
    ASSERT_NE(next, std::string::npos) << name_of(rule.id);
    at = next;
    for (const Alternative& alternative : rule.alternatives)
      EXPECT_NE(text.find("`" + alternative.name + "`"), std::string::npos) << alternative.name;
  }
}

}  // namespace
}  // namespace edgecase
