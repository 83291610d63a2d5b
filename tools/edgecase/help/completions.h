// SPDX-License-Identifier: MIT
//
// Completion scripts for shells: subcommands, options, values of options with a list of them, and
// otherwise file names.
#pragma once

#include <span>
#include <string>

#include "tools/edgecase/commands/command_words.h"

namespace edgecase {

// For bash 4.3 or newer; needs nothing of the package bash-completion.
std::string bash_completion(std::span<const CommandWords> commands);

// For fish 3.
std::string fish_completion(std::span<const CommandWords> commands);

}  // namespace edgecase
