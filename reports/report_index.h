// SPDX-License-Identifier: MIT
//
// The index of the HTML report as JSON: its first page and the list of cases.
//
// {"tool", "policy", "interrupted", "left_out", "renderers", "rules", "rulings", "diagnostics",
// "faults", "names", "heads", "outcomes", "cases", "order", "untrue"}. Many cases share parts,
// which are stored once: "names" are ids of rules, "heads" the common parts of a file's cases,
// "outcomes" are [verdict, standing, [index of a rule, worst verdict under it, ...]]. A case is
// [head, rest of its id, fragments, indices of outcomes by renderer, details or absent, 1 if it has
// levels of detail along a row]; "details" is the number of its line, counted over all blocks
// (report_data.h). "order" are the indices of cases in which something differs, the worst first
// (results/clusters.h). "untrue" are hand-drawn expectations that exact does not meet, [case,
// texts]. A renderer has its "clusters" (results/clusters.h) in their order, with "at", the number
// of the smallest case's disagreement counted from 1; "values", the sums over all cases by
// attribute, with histograms of errors; and "scenes", the pixels of whole scenes by kind.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/html.h"

namespace edgecase {

// The line with the details of each case, and with the text of each head; -1: none.
struct DetailLines {
  std::vector<long> of_case;
  std::vector<long> of_head;
};

// The heads, and the index of each case's.
struct CaseHeads {
  std::vector<std::size_t> of_case;
  std::vector<CaseResults> list;  // the first case of each, without what was drawn and found
};

CaseHeads heads_of(const Results& results);

nlohmann::ordered_json report_index(const Results& results, const ReportTexts& texts,
                                    const CaseHeads& heads, const DetailLines& lines);

}  // namespace edgecase
