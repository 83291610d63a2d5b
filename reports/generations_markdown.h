// SPDX-License-Identifier: MIT
//
// Generations of drivers as tables, for a terminal, a page or release notes.
#pragma once

#include <string>

#include "results/generations.h"

namespace edgecase {

// A table for each driver: its known faults against its releases, in how many cases each shows, and
// which releases were the first and the last to show it. Texts from files stand on one line.
std::string generations_markdown(const Generations& generations);

// The same without the reasons, in columns.
std::string generations_text(const Generations& generations);

}  // namespace edgecase
