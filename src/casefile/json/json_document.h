// SPDX-License-Identifier: MIT
//
// A JSON text as a tree that retains what was written: every value has its line, a number keeps its
// digits (0.1 must be refused as a coordinate, and a double no longer shows whether it was 0.1),
// and objects keep the order of their members and detect duplicate keys.
//
// nlohmann's SAX parser does the parsing; its messages, which describe parser states, are replaced.
// The readers of cases and policies interpret the values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/case.h"

namespace edgecase {

enum class JsonKind { null, boolean, number, string, array, object };

struct JsonNode {
  JsonKind kind = JsonKind::null;
  int line = 0;                    // from 1; of an array or object, where it opens
  std::string name;                // key, if the parent is an object
  int name_line = 0;               // line of the key
  bool duplicate = false;          // an earlier member has the same name
  std::string text;                // a number as written, a string's value
  bool truth = false;              // a boolean's value
  std::vector<JsonNode> children;  // items of an array, members of an object, as written

  // The first member of this name, or null. Only for objects.
  const JsonNode* find(std::string_view member) const;
};

struct JsonDocument {
  std::optional<JsonNode> root;  // nothing if the text cannot be parsed to its end
  std::vector<Diagnostic> diagnostics;
};

// Limits against hostile files. There is room for all vertices of a case, written with all their
// digits.
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 24;
constexpr std::size_t kMaxNesting = 32;  // arrays and objects within each other, the root included

// Parses a text. Refuses more than kMaxFileBytes, malformed UTF-8, a byte order mark, syntax errors
// and nesting beyond kMaxNesting. Duplicate keys are diagnosed, and the tree returned.
JsonDocument parse_json(std::string_view text, const std::string& file);

// A key or index as a part of a JSON pointer: '~' and '/' escaped, RFC 6901.
std::string escape_pointer(std::string_view part);

// "the string \"abc\"", "the number 3", "an array": for messages.
std::string describe(const JsonNode& node);

// A syntax error in JSON, explained: what is wrong, and the remedy.
struct SyntaxError {
  std::size_t offset = 0;  // byte where the error starts; text.size() for the end
  std::string message;
  std::string remedy;
};

// Where a parser stopped, and in which state.
struct ParserStop {
  std::size_t consumed = 0;    // including the offending one; beyond the text at its end
  bool broken_string = false;  // inside a malformed string
  bool complete = false;       // after a whole document
};

SyntaxError explain_syntax_error(std::string_view text, ParserStop stop);

// JSON pointers (RFC 6901) into the tree of a case file, as used by sweeps.
//
// A pointer addresses the normalized case. /draws/I/vertices/J/x (y, z, w) is a coordinate in any
// form of vertex: [x, y], "at", "clip" or "object" (which has no w); z and w of a window position
// exist even if the file omits them. /draws/I/vertices/J/s and t are its texture coordinates, if it
// has them. Everything else is addressed as written.
using Tokens = std::vector<std::string>;

// The unescaped parts of a pointer; nothing if `text` is no pointer, or that of the whole document.
std::optional<Tokens> split_pointer(std::string_view text);

// Whether it is /draws/I/vertices/J.
bool is_vertex_pointer(const Tokens& tokens);

// The member with the position of a vertex written as an object: "at", "clip" or "object"; or null.
JsonNode* find_position(JsonNode& vertex);

// For a pointer to something missing: do nothing, or create missing members of objects (never items
// of arrays). A created value is an empty object with the line of the object round it.
enum class Missing { stays, is_created };

// The value that a pointer addresses, or null. A vertex written as an array becomes an object if
// its "at", "color" or "uv" is addressed. The result is valid until the tree is changed.
JsonNode* find_at(JsonNode& root, const Tokens& tokens, Missing missing);

}  // namespace edgecase
