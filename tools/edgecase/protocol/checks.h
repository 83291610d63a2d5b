// SPDX-License-Identifier: MIT
//
// Checks whether a program keeps reference/PROTOCOL.md; each check is about one sentence of it.
//
// They judge the form of answers, never the rasterization, which `edgecase run` judges. A program
// may refuse features, but must not ignore them: a picture that shows so fails. What can only be
// seen in a scene that the program draws is not asked before it has drawn one.
//
// One mistake may fail many checks. Such roots are told before the checks that follow from them.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <string>
#include <vector>

#include "model/names.h"
#include "processes/child_process.h"
#include "tools/edgecase/protocol/pictures.h"

namespace edgecase {

enum class CheckOutcome { pass, fail, not_supported, not_asked };
template <>
inline constexpr auto kNames<CheckOutcome> =
    std::to_array<Named<CheckOutcome>>({{CheckOutcome::pass, "pass"},
                                        {CheckOutcome::fail, "fail"},
                                        {CheckOutcome::not_supported, "not supported"},
                                        {CheckOutcome::not_asked, "not asked"}});

struct ProtocolCheck {
  int number = 0;    // from 1, in the order of the list
  std::string name;  // the required behaviour: "answers an empty scene"
  CheckOutcome outcome = CheckOutcome::pass;
  std::string finding;   // the observation, without full stop; empty: pass
  std::string remedy;    // of `fail`, without full stop
  std::string feature;   // "points", if the check is about one that may be refused
  bool follows = false;  // of `fail`: may follow from a root
};

struct ProtocolExamination {
  bool started = false;  // the program has answered; otherwise there is at most one check
  std::vector<Fault> roots;
  std::vector<ProtocolCheck> checks;
  std::size_t count(CheckOutcome outcome) const;
};

// Examines a program. `patience`: the time for each answer. `stop` may be null; once it is true,
// the remaining checks are omitted.
ProtocolExamination examine_protocol(const Command& command, std::chrono::milliseconds patience,
                                     const std::atomic<bool>* stop);

}  // namespace edgecase
