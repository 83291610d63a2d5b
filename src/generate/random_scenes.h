// SPDX-License-Identifier: MIT
//
// Random scenes by which a renderer's rules are measured.
//
// Each is a function of its seed and index alone, on every machine: integers of our own generator,
// nothing of <random>. Sizes spread evenly over their logarithms, coordinates over grids from whole
// pixels to 2^-16, among them those halfway between the steps of usual sub-pixel grids. Left to
// chance, a fine coordinate never lies on a boundary; so half of the scenes are built round a tie.
//
// Every target is square, its size a power of two from 4 to 256, its viewport as large, and every
// vertex lies strictly inside. So OpenGL gets the very numbers: |x - centre| < 2^7 with 16 fraction
// bits has 23 significant bits, x itself 24 (see casefile/scene/viewport.h). Depth is 0.
#pragma once

#include <cstdint>

#include "model/scene.h"

namespace edgecase {

constexpr int kLeastRandomTarget = 4;   // pixels
constexpr int kMostRandomTarget = 256;  // pixels
constexpr int kMostRandomExtent = 256;  // pixels, of the rectangle that holds a primitive
// Of multisampled targets, whose answers tell every sample.
constexpr int kMostMultisampledTarget = 64;  // pixels

struct PrimitiveScenes {
  std::uint64_t seed = 1;
  PrimitiveKind kind = PrimitiveKind::triangle;
  Surface surface = Surface::fbo;
};

// One draw of one primitive: a line of width 1, a point of a size mostly 1, else up to 64, a
// multiple of 1/16. The triangle may be a sliver thinner than a sub-pixel or, rarely, have no area;
// a line may have no length.
//
// The sides of points of such sizes meet samples where the vertex is a multiple of 1/32, and so
// some snaps draw all of these points alike, whatever the scenes are. With right and top sides
// owned: none and any truncation to 2^-5 or finer; rounding half up and half even to 2^-6 or finer.
// With left and bottom sides owned: rounding half up to 2^-b and truncation to 2^-(b+1), b at
// least 5.
Scene random_scene(const PrimitiveScenes& of, std::uint64_t index);

// One line, 1.25 to 16 pixels wide, a multiple of 1/4.
Scene random_wide_line(std::uint64_t seed, Surface surface, std::uint64_t index);

// Two triangles in one draw, on opposite sides of an edge with bit-identical ends, which in half of
// the scenes or more passes through pixel centres.
Scene shared_edge_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

// The primitives drawn to a multisampled target.
enum class MultisampledKind { triangle, line, wide_line };

// One triangle, line of width 1, or line of other width (1.25 to 16 pixels, a multiple of 1/4), on
// a target whose samples lie at these positions. Ties are with samples: on an edge of the triangle,
// on an end or a side of the line's rectangle.
Scene random_multisampled_scene(std::uint64_t seed, MultisampledKind kind,
                                const SamplePositions& samples, std::uint64_t index);

// Is a pixel or sample of the scene decided by a tie: does a primitive cover others when all
// boundaries are open than when all are closed? Vertices are not snapped, lines follow the
// diamond-exit rule or, of multisampled targets, are rectangles. `samples`: where they lie.
bool has_tie(const Scene& scene, const SamplePositions& samples = {});

// Random scenes of primitives that share vertices, and of vertices round the steps of sub-pixel
// grids: a search looks at them as well as at the single primitives above.
//
// Each is a function of its seed and index alone, on the same targets, with coordinates that reach
// OpenGL unrounded. Most are built round a tie, many of them nudged off it.
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

// Random scenes of triangles that meet fragment operations, by which a profile is held against the
// renderer that it is of. Each is a function of its seed and index alone, too.
enum class OutputKind {
  depth_tested,  // crossing one another, and of one depth
  blended,       // any equation and factors
  offset,        // each followed by itself with a polygon offset, depth-tested
  stencilled,    // either facing, any function, operations and masks
};
constexpr int kOutputKinds = 4;
const char* name_of(OutputKind kind);  // "depth-tested", …

struct RandomOutputScenes {
  std::uint64_t seed = 1;
  OutputKind kind = OutputKind::depth_tested;
  Surface surface = Surface::fbo;
  DepthFormat depth = DepthFormat::depth24;  // of blended ones none is there
};

// Two to six flat triangles, a draw each, on a target of at most kMostMultisampledTarget pixels.
Scene random_output_scene(const RandomOutputScenes& of, std::uint64_t index);

}  // namespace edgecase
