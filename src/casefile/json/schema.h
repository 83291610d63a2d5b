// SPDX-License-Identifier: MIT
//
// The JSON schema of a file format, put together from what code knows and from what only a person
// can say.
//
// Each noun's part is a JSON text beside the code that reads it. The text says how things are put
// together and what they mean; names and limits are left blank in it, and filled in from the tables
// and constants that the readers use, so that none is written twice.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "casefile/json/json_layout.h"
#include "model/names.h"

namespace edgecase {

// The members of an object that is written as JSON, with its blanks filled in. `blanks` are named
// pieces:
//
//   "@NAME" as a whole string   stands for the piece
//   @NAME within a string       for the piece's text, which is then a scalar: numbers in words
//   "@NAME": 0 as a member      for all members of the piece, an object
//
// A line of the text may end within a string, on a backslash: the string goes on after the blanks
// of the next line. NAME is a word of a to z and _. A name that is no blank, and a text that is no
// object, throw std::logic_error: they are mistakes in this program.
Pieces schema_pieces(std::string_view text, const Pieces& blanks = {});

// A finite number as people read it in a sentence: from 2^20 on, and up to 2^-20, a power of two is
// written as one.
std::string number_words(double value);
// With all its digits.
JsonPiece schema_number(double value);

JsonPiece schema_names(const std::vector<std::string>& names);
template <HasNames Enum>
JsonPiece schema_names() {
  return schema_names(names_of<Enum>());
}

}  // namespace edgecase
