// SPDX-License-Identifier: MIT
//
// A made-up run of many cases that all fail, for tests of what reports of large runs take.
#pragma once

#include <cstddef>

#include "results/results.h"

namespace edgecase::sample {

// `cases` cases of one renderer, each with `disagreements` disagreements whose sentences are as
// long as those of the suite (300 characters) and hold what markup has to escape.
Results large_run(std::size_t cases, int disagreements);

}  // namespace edgecase::sample
