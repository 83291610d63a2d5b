// SPDX-License-Identifier: MIT
//
// The JSON schema of a file format, composed from names and limits in the code and from
// descriptions by a person.
//
// Each noun's part is a JSON text beside the code that reads it, with structure and meaning. Names
// and limits are placeholders, filled in from the tables and constants of the readers, so that
// nothing is written twice.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "casefile/json/json_layout.h"
#include "model/names.h"

namespace edgecase {

// The members of an object that is written as JSON, with its placeholders filled in. `blanks` are
// named pieces:
//
//   "@NAME" as a whole string   stands for the piece
//   @NAME within a string       for the text of the piece, a scalar, with numbers as number_text
//   "@NAME": 0 as a member      for all members of the piece, an object
//
// A line of the text may end within a string, on a backslash: the string continues after the
// indentation of the next line. NAME consists of a to z and _. A name without a piece, and a text
// that is no object, throw std::logic_error: they are mistakes in this program.
Pieces schema_pieces(std::string_view text, const Pieces& blanks = {});

// A finite number as people read it in a sentence: powers of two from 2^20 on, and up to 2^-20, are
// written as such.
std::string number_text(double value);
// The number with all its digits.
JsonPiece schema_number(double value);

template <HasNames Enum>
JsonPiece schema_names() {
  return json_strings(names_of<Enum>());
}

}  // namespace edgecase
