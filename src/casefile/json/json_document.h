// SPDX-License-Identifier: MIT
//
// A JSON text as a tree that still knows what the person wrote: every value carries its line, a
// number keeps its digits (0.1 must be refused as a coordinate, and a double has forgotten whether
// it was 0.1), objects keep the order of their members and notice a key that stands twice.
//
// nlohmann's SAX parser does the parsing; its messages are replaced by our own, since they speak of
// parser states. What a value means is left to the readers of cases and policies.
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
  std::string name;                // key, when the parent is an object
  int name_line = 0;               // line of the key
  bool duplicate = false;          // a member of the same name stands before
  std::string text;                // a number as written, a string's value
  bool truth = false;              // a boolean's value
  std::vector<JsonNode> children;  // items of an array, members of an object, as written

  // The first member of this name, or null. Only for objects.
  const JsonNode* find(std::string_view member) const;
};

struct JsonDocument {
  std::optional<JsonNode> root;  // none when the text cannot be parsed to its end
  std::vector<Diagnostic> diagnostics;
};

// Limits that keep a hostile file harmless.
// Room for all vertices that a case may have, written out with every digit of theirs.
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 24;
constexpr std::size_t kMaxNesting = 32;  // arrays and objects within each other, the root included

// Parses a text. Refused: more than kMaxFileBytes, malformed UTF-8, a byte order mark, nesting
// beyond kMaxNesting, syntax errors. Duplicate keys are diagnosed, and the tree still returned.
JsonDocument parse_json(std::string_view text, const std::string& file);

// A key or index as a part of a JSON pointer: '~' and '/' escaped, RFC 6901.
std::string escape_pointer(std::string_view part);

// "the string \"abc\"", "the number 3", "an array": for messages.
std::string describe(const JsonNode& node);

// Words for a syntax error in JSON: what stands there, and how to put it right.
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

// JSON pointers (RFC 6901) into the tree of a case file, as sweeps use them.
//
// A pointer addresses the normalised case. /draws/I/vertices/J/x (y, z, w) is a coordinate in
// whatever form the vertex is written: [x, y], "at", "clip" or "object" (which has no w); z and w
// of a window position exist even where the file leaves them out. /draws/I/vertices/J/s and t are
// its texture coordinates, where it has them. Everything else is addressed as in the file.
using Tokens = std::vector<std::string>;

// The parts of a pointer, unescaped; none when `text` is no pointer, or that of the whole document.
std::optional<Tokens> split_pointer(std::string_view text);

// Is it /draws/I/vertices/J?
bool is_vertex_pointer(const Tokens& tokens);

// The member of a vertex, written as an object, that gives its place: "at", "clip" or "object"; or
// null.
JsonNode* find_position(JsonNode& vertex);

// What a pointer that leads nowhere does: nothing, or create the missing members of objects (never
// items of arrays). A created value is an empty object, its line that of the object round it.
enum class Missing { stays, is_created };

// The value that a pointer addresses, or null. A vertex written as an array is made an object when
// its "at", "color" or "uv" is asked for. The result lives until the tree is changed.
JsonNode* find_at(JsonNode& root, const Tokens& tokens, Missing missing);

}  // namespace edgecase
