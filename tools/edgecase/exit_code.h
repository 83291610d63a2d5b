// SPDX-License-Identifier: MIT
//
// Exit codes, the same for every subcommand.
#pragma once

namespace edgecase {

enum class ExitCode {
  as_expected = 0,
  unexpected = 1,  // anything unexpected
  usage = 2,       // usage or case error
  internal = 3,    // input, output or internal error
  renderer = 4,    // a renderer missing, crashed or timed out and not known to
  nothing_selected = 5,
};

// The code to report if both apply: 3 before 2, 4, 1, 5 and 0.
constexpr ExitCode worse(ExitCode a, ExitCode b) {
  constexpr int kRank[] = {0, 2, 4, 5, 3, 1};  // by code
  return kRank[static_cast<int>(a)] >= kRank[static_cast<int>(b)] ? a : b;
}

}  // namespace edgecase
