// SPDX-License-Identifier: MIT
//
// What the HTML report needs before a case is opened, as JSON: the first page and the list.
//
// {"tool", "policy", "interrupted", "left_out", "renderers", "rules", "rulings", "diagnostics",
// "faults", "names", "heads", "outcomes", "cases", "order", "untrue"}. Cases are many and much
// alike, so that what they share stands once: "names" are ids of rules, "heads" what cases of one
// file share, "outcomes" are [verdict, standing, [index of a rule, worst verdict by it, ...]]. A
// case is [head, rest of its id, fragments, outcomes' indices by renderer, details or absent, 1
// where it has levels of detail along a row]: "details" is the number of its line, counted over all
// blocks (report_data.h). "order" are the indices of cases in which something differs, the worst
// first (results/worst_first.h). "untrue" are hand-drawn truths that exact does not meet, [case,
// texts]. A renderer holds its "clusters" (results/clusters.h) in their order, with "at", the
// number of the smallest case's disagreement counted from 1; "values", per attribute the sum of all
// cases, with the histogram of errors; and "scenes", how the pixels of whole scenes fare.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/html.h"

namespace edgecase {

// The line of the details that each case has, and of the text that each head has; -1: none.
struct DetailLines {
  std::vector<long> of_case;
  std::vector<long> of_head;
};

// Which cases share their words: by case, the index of its head; and of each head its first case.
struct CaseHeads {
  std::vector<std::size_t> of_case;
  std::vector<std::size_t> first_case;
};

CaseHeads heads_of(const Results& results);

nlohmann::ordered_json report_index(const Results& results, const ReportTexts& texts,
                                    const CaseHeads& heads, const DetailLines& lines);

}  // namespace edgecase
