// SPDX-License-Identifier: MIT
//
// Adds disagreements to a result: the first of a case in full, the rest counted.
//
// A disagreement in full has a sentence and a figure, some kilobytes, and a gross fault has one at
// every pixel: a blank picture of 1024 x 1024 pixels has a million. Nobody reads more than the
// first, so the rest are kept as runs of pixels of one class (DisagreementClass). Everything that
// decides a verdict is in the class, and judge() treats both alike: what is only counted is judged
// as if it were in full.
#pragma once

#include <cstddef>

#include "model/result.h"
#include "model/scene.h"

namespace edgecase {

// Far more than a report shows of an answer (reports/case_details.h), and about 30 MB.
inline constexpr std::size_t kMostInFull = 4096;
// Beyond that, the first of each kind, rule, ruling and legality are in full, so that everything
// that an answer does wrong is explained.
inline constexpr std::size_t kExamplesOfKind = 16;

// Adds a disagreement of a class at a pixel. Returns where its situation, numbers, explanation and
// figure belong, until the next one is added; null if it is only counted.
Disagreement* add_disagreement(Result& result, PixelPosition pixel, const DisagreementClass& of);

// Adds a complete one.
void add_disagreement(Result& result, Disagreement disagreement);

// Counts disagreements of a class, without examples.
void add_counted(Result& result, CountedDisagreements counted);

// Appends a pixel to runs that end with its left neighbour, or begins a run.
void append_pixel(std::vector<PixelRun>& runs, PixelPosition pixel);

}  // namespace edgecase
