// SPDX-License-Identifier: MIT
//
// A scene as JSON, field by field (model/scene_fields.h), for src/wire alone: request_line.h makes
// lines of it. What the lists do not say stands here: forms that are no objects, and what one part
// of a scene asks of another.
#pragma once

#include <string_view>

#include "model/scene.h"
#include "wire/json_values.h"

namespace edgecase::wire {

void write_scene(fmt::memory_buffer& text, const Scene& scene);

// Throws a Refusal for a scene that model/scene.h does not allow.
Scene read_scene(const nlohmann::json& value, const Path& path);

// The key of the passes of a supersampled scene, which stand in its target.
inline constexpr const char* kSupersampling = "supersampling";

// Does a lookup of this kind have the field? All have "kind".
constexpr bool takes(LookupKind kind, std::string_view key) {
  if (key == "kind") return true;
  switch (kind) {
    case LookupKind::implicit:
      return false;
    case LookupKind::bias:
    case LookupKind::lod:
      return key == "value";
    case LookupKind::gradients:
      return key != "value";
  }
  return false;
}

// A vertex as JSON: where it lands in the window, the clip coordinates that take it there, and its
// attribute. For src/wire alone.

// Only a textured draw's vertices have texture coordinates.
void write_vertex(Output out, const Vertex& vertex, bool is_textured);

// A vertex, with clip coordinates that are exact in float32 where its w is not 1, and a position
// that belongs to the clip coordinates where it has some. Texture coordinates are required of a
// textured draw, and refused elsewhere.
Vertex read_vertex(const nlohmann::json& value, const Path& path, const Viewport& viewport,
                   bool is_textured);

}  // namespace edgecase::wire
