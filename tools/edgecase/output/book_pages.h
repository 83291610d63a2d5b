// SPDX-License-Identifier: MIT
//
// From the catalogue and the worked scenes to the rule book.
#pragma once

#include <filesystem>
#include <optional>

#include "reports/rule_book.h"

namespace edgecase {

// The book, its scenes drawn by policy `opengl`; `suite` holds their cases. Prints what is wrong
// with a case and returns nothing.
std::optional<RuleBook> rule_book(const std::filesystem::path& suite);

}  // namespace edgecase
