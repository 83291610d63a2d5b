// SPDX-License-Identifier: MIT
//
// Seams that pass pixel centres at a hair.
//
// Triangles that share an edge hit each centre beside it once (GL 4.6 core, corollary 8 of appendix
// B). Rasterizers whose edge functions round miss some of the centres nearest to the edge, or hit
// them twice. Random seams hardly ever come so near to one; these are constructed.
//
// On a grid of b bits all edge functions are multiples of 2^-2b, a unit. From a vertex at the
// vector u from the centre, the edge goes to the vertex at v, where
//
//   u.x v.y - u.y v.x = k,   k = -3, -2, -1, 1, 2, 3 units
//
// Euclid's algorithm solves this equation if u's components have no common divisor. Its solutions
// differ by multiples of u, so one lies about any number of times as far beyond the centre.
#pragma once

#include <cstdint>
#include <optional>

#include "generate/random_shapes.h"
#include "model/scene.h"

namespace edgecase {

constexpr int kMostSeamTarget = 1024;  // pixels
constexpr int kMostSeamUnits = 3;

// The vector v nearest to -times * u with turn(u, v) = k; all are in steps of a grid, u of up to
// 2^24 of them, |k| at most 3. Nothing if u's components have a common divisor.
std::optional<RawVector> beyond_centre(RawVector u, std::int64_t k, std::int64_t times);

// Two triangles with a common edge, slivers among them, or an open or closed fan, in one draw, of
// either winding. Each edge that two of them share passes a pixel's centre at 1 to 3 units of the
// grid that holds all vertices: of 8, 12 or 16 bits or, less often, any other number from 4 to 16.
//
// Targets are squares of 8 to kMostSeamTarget pixels, a power of two, such that terms of the edge
// functions can have more bits than single precision holds; shapes lie anywhere on them. On targets
// beyond 256 pixels, which are rare, all triangles are slivers. The rest is as in random_scenes.h.
Scene seam_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

}  // namespace edgecase
