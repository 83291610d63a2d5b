// SPDX-License-Identifier: MIT
//
// The manual page edgecase(1), in the macros of man(7).
#pragma once

#include <span>
#include <string>

#include "tools/edgecase/commands/command_words.h"

namespace edgecase {

// `description`: a sentence on the whole program. Throws std::out_of_range for a subcommand without
// a help page.
std::string manual_page(const std::string& description, std::span<const CommandWords> commands);

}  // namespace edgecase
