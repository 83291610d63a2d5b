// SPDX-License-Identifier: MIT
//
// The layout of case files: of a JSON text, the same values laid out as all files of a suite are.
//
// What a person decided stays: which arrays and objects are broken into lines, how many vertices
// share one, the order of keys, the digits of numbers. What nobody should have to think about is
// set: indentation, spaces, the length of lines.
#pragma once

#include <string>

#include "casefile/json_document.h"

namespace edgecase {

// `root`: of a text that could be parsed. The result ends with a line break; laid out again it
// stays as it is.
std::string laid_out(const JsonNode& root);

}  // namespace edgecase
