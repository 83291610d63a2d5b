// SPDX-License-Identifier: MIT
//
// Opening a report in the browser that the desktop has.
#pragma once

#include <string>

namespace edgecase {

// Hands the file to xdg-open, and waits a moment for it to say that it cannot. Empty when the file
// is open, as far as can be told; else why it is not: "there is no xdg-open here".
std::string open_in_browser(const std::string& path);

}  // namespace edgecase
