// SPDX-License-Identifier: MIT
//
// Messages on invalid command lines: the error, a suggestion, and the help to read.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace edgecase {

// One line for standard error, with its line break. A surplus word is reported before a missing
// option, since the missing one is usually misspelt.
std::string usage_error(const CLI::App& app, const CLI::Error& error);

// "did you mean run? ", or empty if no subcommand is similar.
std::string nearest_subcommand(const CLI::App& app, const std::string& name);

}  // namespace edgecase
