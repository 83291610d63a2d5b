// SPDX-License-Identifier: MIT
//
// The beginning and end of the programs edgecase and edgecase-gtest.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "tools/edgecase/exit_code.h"

namespace edgecase {

// Prepares the process before arguments are read. Prints an error and returns false if
// EDGECASE_KERNELS names an unknown target.
bool begin_program();

// Parses the arguments and calls `run`, which returns the exit code. Prints help, the version and
// errors in arguments. A failure to write to standard output or error becomes an exit code, too.
ExitCode run_program(CLI::App& app, int argc, char** argv, const std::function<ExitCode()>& run);

}  // namespace edgecase
