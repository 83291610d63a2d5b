// SPDX-License-Identifier: MIT
//
// The data of the HTML report: an index that is read at once, and blocks of details that are read
// when a case is opened.
//
// A block is some lines of JSON, deflated (results/deflate.h) and in base64. A line is what
// case_details.h says of a case, or, as a string, the text of a case file. The cases most worth a
// look come first: where a report is too large for one file, they are in it. The index
// (report_index.h) has "blocks", the number of each block's first line, and "key", a digest of all:
// reports with the same key say the same.
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

// Of blocks of about `most` bytes in all; lines that are left out have numbers beyond those.
ReportData report_data(const Results& results, const ReportTexts& texts,
                       std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace edgecase
