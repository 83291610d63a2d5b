// SPDX-License-Identifier: MIT
//
// Makes the rule book from the catalogue and the worked scenes.
#pragma once

#include <filesystem>
#include <optional>

#include "reports/rule_book.h"

namespace edgecase {

// The book, with its scenes drawn under policy `opengl`; `suite` has their cases. Prints an error
// and returns nothing if a case cannot be loaded.
std::optional<RuleBook> rule_book(const std::filesystem::path& suite);

}  // namespace edgecase
