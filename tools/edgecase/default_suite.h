// SPDX-License-Identifier: MIT
//
// The suite that is meant where none is named.
#pragma once

#include <filesystem>
#include <string>

namespace edgecase {

// The suite that was installed with the running program: a folder named `cases`; empty where there
// is none, as for a program in a build folder.
std::filesystem::path installed_suite();

// `cases` in the working folder; where there is none, the installed suite; where there is none
// either, `cases` again, for the message that says so.
std::string default_suite();

}  // namespace edgecase
