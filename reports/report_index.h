// SPDX-License-Identifier: MIT
//
// The index of the HTML report as JSON: its first page and the list of cases.
//
// {"tool", "policy", "interrupted", "left_out", "verdicts", "judged", "renderers", "rules",
// "rulings", "diagnostics", "faults", "names", "heads", "outcomes", "cases", "order", "untrue",
// "unexpected"}. "verdicts" are those of verdict_looks.h by name, with "rank", "path" and "means";
// "judged" says by legality which is that of a difference without a cause and with one. Many cases
// share parts, which are stored once: "names" are ids of rules, "heads" the common parts of a
// file's cases, "outcomes" are [verdict, standing, [index of a rule, worst verdict under it, ...]].
// A case is [head, rest of its id, fragments, indices of outcomes by renderer, details or absent, 1
// if it has levels of detail along a row]; "details" is the number of its line, counted over all
// blocks (report_data.h). "order" are the indices of cases in which something differs, the worst
// first (results/clusters.h). "untrue" are hand-drawn expectations that exact does not meet, [case,
// texts]. "unexpected" are the answers to be decided on: [case, renderer, cluster of the renderer
// that the answer is told by, or the name of its failure, fingerprint]. A fault has its "smallest"
// case of those in which it shows. A renderer has its "clusters" (results/clusters.h) in their
// order, with "at", the number of the smallest case's disagreement counted from 1; "values", the
// sums over all cases by attribute, with histograms of errors; and "scenes", the pixels of whole
// scenes by kind.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/case_heads.h"
#include "reports/html.h"

namespace edgecase {

// The line with the details of each case, and with the text of each head; -1: none.
struct DetailLines {
  std::vector<long> of_case;
  std::vector<long> of_head;
};

nlohmann::ordered_json report_index(const Results& results, const ReportTexts& texts,
                                    const CaseHeads& heads, const DetailLines& lines);

}  // namespace edgecase
