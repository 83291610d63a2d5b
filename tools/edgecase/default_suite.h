// SPDX-License-Identifier: MIT
//
// The default suite.
#pragma once

#include <filesystem>
#include <string>

namespace edgecase {

// The suite that was installed with the running program: a folder named `cases`; empty if there is
// none, as for a program in a build folder.
std::filesystem::path installed_suite();

// `cases` in the working folder, or else the installed suite. If neither exists, `cases`, for the
// error message.
std::string default_suite();

}  // namespace edgecase
