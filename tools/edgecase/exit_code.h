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
  nothing_drawn = 6,  // a renderer supports none of the cases that it was asked for
};

// The code to report if both apply: 3 before 2, 4, 1, 6, 5 and 0.
constexpr ExitCode worse(ExitCode a, ExitCode b) {
  constexpr int kRank[] = {0, 3, 5, 6, 4, 1, 2};  // by code
  return kRank[static_cast<int>(a)] >= kRank[static_cast<int>(b)] ? a : b;
}

}  // namespace edgecase
