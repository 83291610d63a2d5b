// SPDX-License-Identifier: MIT
//
// The members of a case file that are words, as they are written: what it is called, why it is
// there, and what it is about.
#pragma once

#include <string>

#include "casefile/case_writer.h"
#include "casefile/json_layout.h"

namespace edgecase {

// Adds the member, unless the word is empty.
void add_word(const char* name, const std::string& word, Pieces& members);

// Those of all words that there are, in the order of case files.
Pieces word_pieces(const CaseWords& words);

}  // namespace edgecase
