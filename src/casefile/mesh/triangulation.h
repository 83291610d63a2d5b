// SPDX-License-Identifier: MIT
//
// Cuts the faces of meshes into triangles, by decisions that are exact wherever a face lies.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "casefile/mesh/transform.h"

namespace edgecase {

// The triangles of a polygon in space: numbers of its corners, three of each of n - 2 triangles,
// which wind as the polygon does. It is seen along the axis that is nearest to its normal. Edges
// may touch, as those do that lead to a hole and back. Empty if two edges cross.
//
// A polygon of four corners is cut along its shorter diagonal if both lie inside. Others lose one
// ear after the other: a corner, the two beside it, and nothing else in the triangle of the three
// (Meisters, Polygons have ears, 1975). Where there is no area, triangles have none.
std::vector<std::array<std::size_t, 3>> triangles_of(std::span<const Vector> corners);

}  // namespace edgecase
