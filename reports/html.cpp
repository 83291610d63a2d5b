// SPDX-License-Identifier: MIT
#include "reports/html.h"

#include <ostream>

#include "reports/page.h"
#include "reports/report_data.h"

namespace edgecase {

void write_html(const Results& results, const ReportTexts& texts, std::ostream& out) {
  out << kPageBeforeData << report_data(results, texts) << kPageAfterData;
}

}  // namespace edgecase
