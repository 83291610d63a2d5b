// SPDX-License-Identifier: MIT
//
// The data of the HTML report: an index, and blocks of details that are read when a case is opened.
//
// A block is some lines of JSON, deflated (results/deflate.h) and in base64 (reports/base64.h). A
// line holds the details of a case (case_details.h) or, as a string, the text of a case file. The
// most important cases come first, so that a report too large for one file has at least these in
// it. The index (report_index.h) has "blocks", the number of each block's first line, "key", a
// digest of all data, and where results of several releases were given "generations"
// (results/generations.h).
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "reports/html.h"

namespace edgecase {

struct ReportData {
  std::string key;                  // 16 hexadecimal digits
  std::string index;                // JSON, valid UTF-8, in which `<` occurs only as \u003c
  std::vector<std::string> blocks;  // base64
};

// `most`: approximate bytes of all blocks. Omitted lines have higher numbers than all others.
ReportData report_data(const Results& results, const ReportTexts& texts,
                       std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace edgecase
