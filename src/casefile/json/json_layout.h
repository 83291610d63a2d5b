// SPDX-License-Identifier: MIT
//
// JSON text laid out as a person would: two spaces per level, and everything that fits on one line
// is on one. A library's printer puts each number of a vertex on its own line, or the whole file on
// one.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "casefile/json/json_document.h"

namespace edgecase {

// A value and how it may be broken into lines.
struct JsonPiece {
  enum class Kind { scalar, array, object };
  Kind kind = Kind::scalar;
  std::string name;  // the key, inside an object
  std::string text;  // a scalar as written
  std::vector<JsonPiece> children;
  bool broken = false;       // one child per line even if all of it fits on one
  std::size_t together = 1;  // children that share a line of a broken array
};
using Pieces = std::vector<JsonPiece>;

JsonPiece json_scalar(std::string text);
// Escaped and in quotes; `text` must be well-formed UTF-8.
JsonPiece json_string(std::string_view text);
JsonPiece json_array(std::vector<JsonPiece> items);
JsonPiece json_strings(std::span<const std::string> texts);  // an array
JsonPiece json_object(std::vector<JsonPiece> members);
JsonPiece named(std::string name, JsonPiece piece);

// The text, with a line break at its end. Lines have at most 100 characters if the values permit.
std::string lay_out(const JsonPiece& piece);

// The layout of case files: the values of a JSON text, laid out as all files of a suite are.
//
// An author's decisions are kept: which arrays and objects are broken into lines, how many vertices
// share one, the order of keys, the digits of numbers. Indentation, spaces and the length of lines
// are normalized.

// `root`: of a text that was parsed without fault. The result ends with a line break; laying it out
// again changes nothing.
std::string laid_out(const JsonNode& root);

}  // namespace edgecase
