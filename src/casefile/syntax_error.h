// SPDX-License-Identifier: MIT
//
// Words for a syntax error in JSON: what stands there, and how to put it right.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace edgecase {

struct SyntaxError {
  std::size_t offset = 0;  // byte at which the trouble starts, text.size() for its end
  std::string message;
  std::string remedy;
};

// Where a parser stopped, and what it knows.
struct ParserStop {
  std::size_t consumed = 0;    // bytes read, the offending one included; beyond the text at its end
  bool broken_string = false;  // inside a string that is malformed
  bool complete = false;       // a whole document has been read before
};

SyntaxError explain_syntax_error(std::string_view text, ParserStop stop);

}  // namespace edgecase
