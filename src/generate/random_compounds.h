// SPDX-License-Identifier: MIT
//
// Random scenes of primitives that share vertices, and of vertices round the steps of sub-pixel
// grids: what a search looks at beside the single primitives of generate/random_scenes.h.
//
// Each is a function of its seed and index alone, on the same targets, with coordinates that reach
// OpenGL unrounded. Most are built round a tie, many of them nudged off it.
#pragma once

#include <cstdint>

#include "model/scene.h"

namespace edgecase {

constexpr int kMostCompoundTarget = 64;  // pixels

// Two to six segments that follow each other, each starting bit-identically where the one before
// ends: a strip, a loop or separate lines in one draw. Half of them keep one major axis and
// direction, the others turn at joints, some turn back. One in eight is wider than a pixel.
Scene random_joint_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

// Triangles that share vertices, in one draw: all round an inner vertex or part of the way, along a
// strip, down to slivers, or with a vertex of two upon the edge of a third (a T-junction). As fan
// or strip, or as separate triangles whose vertices come in any order.
Scene random_fan_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

// A point, a line or a triangle whose vertices lie at multiples of 2^-b pixel (b is 4 or 8, at
// times 2 to 12), halfway between two, or 2^-16 beside either, so near to a tie that it is decided
// by how vertices are snapped.
Scene random_snap_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

}  // namespace edgecase
