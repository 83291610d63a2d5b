// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace edgecase {

// Why a line is refused: one sentence that says what is wrong and where, no full stop at its end.
struct WireError {
  std::string message;
};

}  // namespace edgecase
