// SPDX-License-Identifier: MIT
//
// The rules in the order in which they are taught: chapters by family, and in them a section for
// each essay. An essay is the comment on top of the header that declares its rules or, if a header
// has several sections, the comment there that begins with "Essay: " and the title.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "model/rule_id.h"

namespace edgecase {

struct Section {
  std::string_view title;
  std::string_view header;    // path below src/rules without suffix: "coverage/snap"
  std::vector<RuleId> rules;  // at least one
};

struct Chapter {
  std::string_view name;  // of its page: lower case, no spaces
  std::string_view title;
  std::string_view about;  // one sentence
  std::vector<Section> sections;
};

// Every rule of the catalogue stands in exactly one section.
std::span<const Chapter> chapters();

// The text without comment marks; a line that starts with a space belongs to a table, formula or
// drawing.
std::string_view essay_of(const Section& section);

}  // namespace edgecase
