// SPDX-License-Identifier: MIT
//
// The HTML report: one file for reviewers that works from disk, without a network.
//
// The page's style and scripts are plain files in reports/viewer. embed_viewer.py joins them into
// the library at build time, with a Content-Security-Policy that allows exactly these. The page
// holds the run's findings as data (report_data.h); the viewer escapes every text. A page has at
// most kMostOfPage bytes. Details beyond that are omitted, or written to scripts beside the page.
// The viewer loads such a script, even from disk, when one of its cases is opened; the policy
// allows loading only if there are such scripts.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "results/comparison.h"
#include "results/generations.h"
#include "results/results.h"

namespace edgecase {

// The texts of one rule, supplied by the caller: reports know no rules.
struct RuleText {
  std::string id;  // "line.diamond-exit"
  std::string title;
  std::string spec;      // section of the specification
  std::string latitude;  // what the specification leaves open
  std::string standard;  // the alternative of policy `opengl`, or empty
  std::vector<std::pair<std::string, std::string>> alternatives = {};  // name -> meaning
};

// One numbered ruling, in a sentence or two.
struct RulingText {
  int number = 0;
  std::string text;
  std::vector<std::pair<std::string, std::string>> facts;  // name -> what it rests on, and so on
};

// Measured choices of renderers: name -> "" or a surface -> rule -> alternative.
using ReportProfiles =
    std::map<std::string, std::map<std::string, std::map<std::string, std::string>>>;

// The texts of a report that are not in the results.
struct ReportTexts {
  std::vector<RuleText> rules;
  std::vector<RulingText> rulings;
  // Returns true if the specification leaves open every alternative of the cause. If unset, no
  // cause is open.
  std::function<bool(const Cause& cause)> is_open_choice;
  ReportProfiles profiles;
  // The text of a case's file, or empty where it cannot be shown. Unset: no text is.
  std::function<std::string(const CaseResults& one)> source_of;
  std::optional<Comparison> since;  // from earlier results to these
  Generations generations;          // known faults by release; empty: not told
};

// Limits in bytes: of a page, of the details in it, and of a script beside it.
constexpr std::size_t kMostOfPage = 10'000'000;
constexpr std::size_t kMaxInlined = 6'000'000;
constexpr std::size_t kChunk = 1'000'000;

// Where details go that do not fit into a page, those of the least important cases: they are
// omitted, except for their lines in the list, or written to scripts beside the page.
enum class Beyond { left_out, in_scripts };

struct HtmlFile {
  std::string name;  // without folders
  std::string text;
};

// The page, named `name` ("report.html"), and the scripts beside it ("report.1.js"), if any. In
// UTF-8; the same results give the same bytes.
std::vector<HtmlFile> html_files(const Results& results, const ReportTexts& texts,
                                 const std::string& name, Beyond beyond,
                                 std::size_t max_inlined = kMaxInlined);

}  // namespace edgecase
