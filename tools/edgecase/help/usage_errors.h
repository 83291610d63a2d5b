// SPDX-License-Identifier: MIT
//
// What is said of a command line that cannot be taken: what is wrong, what may have been meant, and
// which help to read.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace edgecase {

// One line for standard error, with its line break. A word that nothing takes is told before what
// is missing, since a misspelt option is the usual reason that a required one is missing.
std::string usage_error(const CLI::App& app, const CLI::Error& error);

// "did you mean run? ", or nothing where no subcommand is near.
std::string nearest_subcommand(const CLI::App& app, const std::string& name);

}  // namespace edgecase
