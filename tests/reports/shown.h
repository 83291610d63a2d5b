// SPDX-License-Identifier: MIT
//
// The parts of a report's data, read back.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reports/case_details.h"
#include "reports/report_data.h"
#include "results/deflate.h"

namespace edgecase::sample {

inline nlohmann::json details_of(const CaseResults& one) {
  return nlohmann::json::parse(
      case_details(one).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

inline nlohmann::json index_of(const Results& results, const ReportTexts& texts = {}) {
  return nlohmann::json::parse(report_data(results, texts).index);
}

}  // namespace edgecase::sample
