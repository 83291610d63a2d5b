// SPDX-License-Identifier: MIT
//
// Standing: how results stand to the known faults of their drivers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/known_faults.h"

namespace edgecase {

// Sets standing, its reason and faults of every result, and Results::faults, by the files of their
// drivers. Without latitude nothing is known: such a run asks for the exact side's own answer, and
// not what the specification allows.
void apply_known_faults(Results& results, std::span<const KnownFaults> known);

// As --strict has it: what is contested and not known becomes unexpected.
void hold_contested(Results& results);

// The faults, of those that a renderer may have, that account for something in its answer.
std::vector<const KnownFault*> faults_behind(const CaseResults& one, const Result& result,
                                             std::span<const KnownFault* const> faults);

// Is some known fault seen in more cases than its file says? That is red.
bool has_grown(const Results& results);

// The faults of a renderer's driver; null where there is no file.
const KnownFaults* faults_about(std::span<const KnownFaults> known, const RendererInfo& info);

// Is it a difference that makes the answer's verdict what it is, a violation or contested? For
// these a fault must account.
bool needs_fault(const Result& result, const Disagreement& d);

// What a run found, in short: the reason that a new entry gets where nobody gives one, and what
// messages say of an unexpected answer.
std::string reason_from(const Result& result);

}  // namespace edgecase
