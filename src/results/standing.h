// SPDX-License-Identifier: MIT
//
// Standing: whether results are expected, by the known faults of their drivers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/known_faults.h"

namespace edgecase {

// Sets standing, its reason and faults of every result, and Results::faults, by the files of their
// drivers. Without latitude no fault is known: such a run requires the exact side's own answer,
// whatever the specification allows.
void apply_known_faults(Results& results, std::span<const KnownFaults> known);

// The standing that a judged answer to a case of this id and surface has, by the faults that its
// renderer may have.
Standing standing_of(const CaseResults& one, Result result,
                     std::span<const KnownFault* const> faults, Latitude latitude);

// For --strict: contested answers without a known fault become unexpected.
void hold_contested(Results& results);

// Those of a renderer's possible faults that account for something in its answer.
std::vector<const KnownFault*> faults_behind(const CaseResults& one, const Result& result,
                                             std::span<const KnownFault* const> faults);

// True if a renderer does not support so many cases of a fault that some must be among them that
// showed it, by its count on the driver's release; without one, if it supports none. Such a run
// does not tell that the fault has shrunk or is fixed.
bool is_partial(const Results& results, std::size_t renderer, const KnownFault& fault);

// The shortest id of a case in which a known fault of the renderer occurs, the first of equals;
// empty for none.
std::string shortest_case_with(const Results& results, const std::string& renderer,
                               const std::string& fault);

// True if some known fault occurs in more cases than its file says, which is red.
bool has_grown(const Results& results);

// The faults of a renderer's driver; null where there is no file.
const KnownFaults* faults_about(std::span<const KnownFaults> known, const RendererInfo& info);

// True if the difference makes the answer a violation or contested: a fault must account for it.
bool needs_fault(const Result& result, const DisagreementClass& d);

// The verdict with the fingerprint: "violation 0123456789abcdef".
std::string describe(const Judgement& answer);

// A short description of a result: the default reason of a new fault, and the text of messages
// about an unexpected answer.
std::string reason_from(const Result& result);

}  // namespace edgecase
