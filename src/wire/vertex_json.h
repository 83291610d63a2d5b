// SPDX-License-Identifier: MIT
//
// A vertex as JSON: where it lands in the window, the clip coordinates that take it there, and its
// attribute. For src/wire alone.
#pragma once

#include "wire/json_values.h"

namespace edgecase::wire {

// Only a textured draw's vertices have texture coordinates.
void write_vertex(Output out, const Vertex& vertex, bool is_textured);

// A vertex, with clip coordinates that are exact in float32 where its w is not 1, and a position
// that belongs to the clip coordinates where it has some. Texture coordinates are required of a
// textured draw, and refused elsewhere.
Vertex read_vertex(const nlohmann::json& value, const Path& path, const Viewport& viewport,
                   bool is_textured);

}  // namespace edgecase::wire
