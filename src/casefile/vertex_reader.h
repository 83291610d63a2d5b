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

// [x, y], [x, y, z], [x, y, z, w], or an object with "at", "clip" or "object", and "color".
VertexFields read_vertex(const Place& place, const std::optional<Color>& draw_color,
                         Findings& findings);

// The vertices of a mesh, in object space; `place` is the mesh's in the file.
std::vector<VertexFields> mesh_vertices(const Mesh& mesh, const Place& place,
                                        const std::optional<Color>& draw_color);

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
