// SPDX-License-Identifier: MIT
//
// JSON pointers (RFC 6901) into the tree of a case file, as sweeps use them.
//
// A pointer addresses the normalised case. /draws/I/vertices/J/x (y, z, w) is a coordinate in
// whatever form the vertex is written: [x, y], "at", "clip" or "object" (which has no w); z and w
// of a window position exist even where the file leaves them out. /draws/I/vertices/J/s and t are
// its texture coordinates, where it has them. Everything else is addressed as in the file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "casefile/json_document.h"

namespace edgecase {

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
