// SPDX-License-Identifier: MIT
//
// The HTML report: one file for reviewers that works from disk, without a network.
//
// The page's style and scripts live in reports/viewer as plain files; embed_viewer.py joins them
// into the library at build time, with a Content-Security-Policy that lets exactly these run. What
// a run found stands in the page as data (report_data.h says how); the viewer shows every text of
// it as text, never as markup. A page has at most kMostOfPage bytes. Details beyond that are left
// out, or go into scripts beside it, which the viewer loads, from disk too, when a case of theirs
// is opened; only then the policy allows the viewer to load anything.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "results/comparison.h"
#include "results/results.h"

namespace edgecase {

// One rule as a reviewer reads it; reports know no rule, so the caller brings the words.
struct RuleText {
  std::string id;  // "line.diamond-exit"
  std::string title;
  std::string spec;      // section of the specification
  std::string latitude;  // what the specification leaves open
  std::string standard;  // the alternative of policy `opengl`, or empty
};

// One numbered ruling, in a sentence or two.
struct RulingText {
  int number = 0;
  std::string text;
  std::vector<std::pair<std::string, std::string>> facts;  // name -> what it rests on, and so on
};

// What renderers are measured to follow: name -> "" or a surface -> rule -> alternative.
using ReportProfiles =
    std::map<std::string, std::map<std::string, std::map<std::string, std::string>>>;

// What a report says beyond the results.
struct ReportTexts {
  std::vector<RuleText> rules;
  std::vector<RulingText> rulings;
  // Does the specification leave open all of a cause? Unset: nothing is.
  std::function<bool(const Cause& cause)> is_open_choice;
  ReportProfiles profiles;
  std::optional<Comparison> since;  // from earlier results to these
};

// Bytes that a page may have, those of details in it, and those of a script beside it.
constexpr std::size_t kMostOfPage = 10'000'000;
constexpr std::size_t kMaxInlined = 6'000'000;
constexpr std::size_t kChunk = 1'000'000;

// What becomes of the details for which a page has no room, those of the least telling cases: the
// page has only their lines in its list, or scripts beside it hold them.
enum class Beyond { left_out, in_scripts };

struct HtmlFile {
  std::string name;  // without folders
  std::string text;
};

// The page, called `name` ("report.html"), and the scripts that belong beside it ("report.1.js"),
// if any. UTF-8; the same results give the same bytes.
std::vector<HtmlFile> html_files(const Results& results, const ReportTexts& texts,
                                 const std::string& name, Beyond beyond,
                                 std::size_t max_inlined = kMaxInlined);

// The page alone. The caller checks the stream's state afterwards.
void write_html(const Results& results, const ReportTexts& texts, std::ostream& out);

}  // namespace edgecase
