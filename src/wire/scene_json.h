// SPDX-License-Identifier: MIT
//
// A scene as JSON, field by field (model/scene_fields.h), for use in src/wire only: request_line.h
// makes lines of it. Code here covers what the lists cannot express: forms that are not objects,
// and conditions between parts of a scene.
#pragma once

#include <string_view>

#include "model/scene.h"
#include "wire/json_values.h"

namespace edgecase::wire {

void write_scene(fmt::memory_buffer& text, const Scene& scene);

// Throws a Refusal for a scene that violates model/scene.h.
Scene read_scene(const nlohmann::json& value, const Path& path);

// The key of the passes of a supersampled scene, inside its target.
inline constexpr const char* kSupersampling = "supersampling";

// Whether a lookup of this kind has the field; all have "kind".
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

// A vertex as JSON: its window position, the clip coordinates that give it, and its attribute.

// Only vertices of textured draws have texture coordinates.
void write_vertex(Output out, const Vertex& vertex, bool is_textured);

// Reads a vertex. Clip coordinates derived from a w other than 1 must be exact in float32, and a
// position beside clip coordinates must match them. Texture coordinates are required in a textured
// draw and refused elsewhere.
Vertex read_vertex(const nlohmann::json& value, const Path& path, const Viewport& viewport,
                   bool is_textured);

}  // namespace edgecase::wire
