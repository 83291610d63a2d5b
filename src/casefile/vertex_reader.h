// SPDX-License-Identifier: MIT
//
// Reads the vertices of a draw in the three ways to give one: where it lands in the window, as clip
// coordinates, or in object space; and makes the last ones clip coordinates.
#pragma once

#include <optional>
#include <vector>

#include "casefile/mesh.h"
#include "casefile/scene_reader.h"
#include "casefile/transform.h"

namespace edgecase {

// What a draw says of its vertices.
struct VertexDefaults {
  std::optional<Color> color;  // of those that have none of their own
  bool textured = false;       // all have texture coordinates, and none a colour
  int dimensions = 0;          // of the texture: how many coordinates; 0: not known
};

// [x, y], [x, y, z], [x, y, z, w], or an object with "at", "clip" or "object", and "color" or "uv".
VertexFields read_vertex(const Place& place, const VertexDefaults& defaults, Findings& findings);

// The vertices of a mesh, in object space; `place` is the mesh's in the file. Of a textured draw,
// colours are left out, and a mesh without texture coordinates is refused.
std::vector<VertexFields> mesh_vertices(const Mesh& mesh, const Place& place,
                                        const VertexDefaults& defaults, Findings& findings);

// Which parts of a transform had vertices to act on.
struct TransformUse {
  bool affine = false;
  bool matrix = false;
};

// Moves vertices in window coordinates and takes those in object space to clip coordinates. A null
// `transform` is one that changes nothing. Findings name vertices that cannot be drawn, of a mesh
// only the first. Call only where no vertex was found wrong.
TransformUse transform_vertices(const Transform* transform, std::vector<VertexFields>& vertices,
                                Findings& findings);

}  // namespace edgecase
