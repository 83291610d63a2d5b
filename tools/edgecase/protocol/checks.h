// SPDX-License-Identifier: MIT
//
// Does a program keep reference/PROTOCOL.md? A list of checks, each about one sentence of it.
//
// They judge the form of answers, never the rasterization: that is for `edgecase run`. What a
// program says that it does not do is not held against it; that it ignores what it was asked for
// is, wherever the picture shows it.
#pragma once

#include <atomic>
#include <chrono>
#include <string>
#include <vector>

#include "run/child_process.h"

namespace edgecase {

enum class CheckOutcome { pass, fail, not_supported };

// "pass", "fail", "not supported".
const char* name_of(CheckOutcome);

struct ProtocolCheck {
  int number = 0;    // from 1, in the order of the list
  std::string name;  // what a program is to do: "answers an empty scene"
  CheckOutcome outcome = CheckOutcome::pass;
  std::string finding;  // of `fail`, and of `not_supported`: what came, without full stop
  std::string remedy;   // of `fail`: what to do about it, without full stop
};

struct ProtocolExamination {
  bool started = false;  // the program has answered something; else there is one check at most
  std::vector<ProtocolCheck> checks;
  std::size_t count(CheckOutcome outcome) const;
};

// Examines a program. `patience`: for each answer. `stop` may be null; where it becomes true the
// checks that are left are missing.
ProtocolExamination examine_protocol(const Command& command, std::chrono::milliseconds patience,
                                     const std::atomic<bool>* stop);

}  // namespace edgecase
