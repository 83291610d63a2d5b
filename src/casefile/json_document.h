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

}  // namespace edgecase
