// SPDX-License-Identifier: MIT
//
// Opens a report in the desktop's browser.
#pragma once

#include <string>

namespace edgecase {

// Hands the file to xdg-open, and waits a moment for a failure. Returns the reason for failing,
// such as "there is no xdg-open here", or empty if none is known.
std::string open_in_browser(const std::string& path);

}  // namespace edgecase
