// SPDX-License-Identifier: MIT
//
// The HTML report: one file for reviewers that works from disk, without a network.
//
// The page's style and scripts live in reports/viewer as plain files; embed_viewer.py joins them
// into the library at build time, with a Content-Security-Policy that lets exactly these run. What
// a run found is one block of JSON data in the page (report_data.h says what it holds); the viewer
// shows every text of it as text, never as markup.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "results/results.h"

namespace edgecase {

// One rule as a reviewer reads it; reports know no rule, so the caller brings the words.
struct RuleText {
  std::string id;  // "line.diamond-exit"
  std::string title;
  std::string spec;      // section of the specification
  std::string latitude;  // what the specification leaves open
};

// One numbered ruling, in a sentence or two.
struct RulingText {
  int number = 0;
  std::string text;
};

struct ReportTexts {
  std::vector<RuleText> rules;
  std::vector<RulingText> rulings;
};

// Writes the page in UTF-8; the same results give the same bytes. The caller checks the stream's
// state afterwards.
void write_html(const Results& results, const ReportTexts& texts, std::ostream& out);

}  // namespace edgecase
