// SPDX-License-Identifier: MIT
//
// The report's page without its data, as embed_viewer.py makes it from reports/viewer.
#pragma once

#include <string_view>

namespace edgecase {

// The data, JSON without '<', goes between the two.
extern const std::string_view kPageBeforeData;
extern const std::string_view kPageAfterData;

}  // namespace edgecase
