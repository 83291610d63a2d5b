// SPDX-License-Identifier: MIT
//
// What the programs edgecase and edgecase-gtest begin and end with.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "tools/edgecase/exit_code.h"

namespace edgecase {

// Prepares the process before arguments are read. False, with the error printed, where
// EDGECASE_KERNELS asks for what there is not.
bool begin_program();

// Parses the arguments and does what they ask for: `run` yields the exit code. Prints help, the
// version, and what is wrong with arguments; what cannot be written to standard output or error is
// an exit code, too.
ExitCode run_program(CLI::App& app, int argc, char** argv, const std::function<ExitCode()>& run);

}  // namespace edgecase
