// SPDX-License-Identifier: MIT
//
// An examination of a program's protocol, as text and as JSON.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/edgecase/protocol/checks.h"

namespace edgecase {

// The renderer's name, a line for each check, with finding and remedy below those that fail, and a
// line with the counts.
std::string examination_text(const std::string& renderer, const ProtocolExamination& examination);

// {"renderers": [{"name", "started", "checks": [{"number", "name", "outcome", "finding",
// "remedy"}], "summary": {"pass", "fail", "not_supported"}}]}, and a line break.
std::string examinations_json(
    const std::vector<std::pair<std::string, ProtocolExamination>>& examinations);

}  // namespace edgecase
