// SPDX-License-Identifier: MIT
//
// Random scenes of one primitive or few, for searches.
//
// Each depends only on its seed and index, on every machine: integers from our own generator,
// nothing from <random>. Sizes are uniform in their logarithms; coordinates lie on grids from whole
// pixels to 2^-16, including those halfway between the steps of common sub-pixel grids. A random
// fine coordinate would never lie on a boundary, so half of the scenes are built round a tie.
//
// Every target is square, with a power of two from 4 to 256 as its size and a viewport of the same
// size, and every vertex lies strictly inside. So OpenGL gets the exact numbers: |x - centre| < 2^7
// with 16 fraction bits has 23 significant bits, x itself 24 (see casefile/scene/viewport.h). Depth
// is 0.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "model/names.h"
#include "model/scene.h"

namespace edgecase {

// RandomSource: the numbers of random scenes. They depend only on the arguments of its constructor;
// the standard library's distributions differ between machines.
//
// The generator is splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number
// generators", 2014): a counter and a mixing of its bits.

class RandomSource {
 public:
  // `stream` separates generators of one seed.
  RandomSource(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
      : state_(mixed(mixed(mixed(seed) + stream) + index)) {}

  std::uint64_t next() { return mixed(state_ += kStep); }

  // From 0 to count - 1; count is 1 to 2^40. The bias of the remainder is at most 2^-24.
  std::int64_t below(std::int64_t count) {
    return static_cast<std::int64_t>(next() % static_cast<std::uint64_t>(count));
  }
  // Both ends inclusive.
  std::int64_t between(std::int64_t low, std::int64_t high) { return low + below(high - low + 1); }
  // True with probability 1 / many.
  bool one_in(int many) { return below(many) == 0; }
  std::int64_t sign() { return one_in(2) ? 1 : -1; }
  // From 1 to 2^octaves: octaves are equally likely, and values uniform within one.
  std::int64_t log_uniform(int octaves) {
    const std::int64_t low = std::int64_t{1} << below(octaves);
    return between(low, 2 * low);
  }
  // From 0 to less than 1, with 24 bits.
  double fraction() { return static_cast<double>(below(1 << 24)) * 0x1p-24; }
  template <class T>
  const T& one_of(std::span<const T> values) {
    return values[static_cast<std::size_t>(below(static_cast<std::int64_t>(values.size())))];
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;
  static constexpr std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

constexpr int kLeastRandomTarget = 4;   // pixels
constexpr int kMostRandomExtent = 256;  // pixels, of a primitive's bounding rectangle
// For multisampled targets, whose answers contain every sample.
constexpr int kMostMultisampledTarget = 64;  // pixels

struct PrimitiveScenes {
  std::uint64_t seed = 1;
  PrimitiveKind kind = PrimitiveKind::triangle;
  Surface surface = Surface::fbo;
};

// One draw of one primitive: a line of width 1, or a point of size 1 or, less often, up to 64, a
// multiple of 1/16. The triangle may be a sliver thinner than a sub-pixel or, rarely, have no area;
// a line may have length 0.
//
// The sides of points of such sizes meet samples if the vertex is a multiple of 1/32, so some snaps
// draw all of these points alike, whatever the scenes. With right and top sides owned: none and any
// truncation to 2^-5 or finer; rounding half up and half even to 2^-6 or finer. With left and
// bottom sides owned: rounding half up to 2^-b and truncation to 2^-(b+1), b at least 5.
Scene random_scene(const PrimitiveScenes& of, std::uint64_t index);

// One line, 1.25 to 16 pixels wide, a multiple of 1/4.
Scene random_wide_line(std::uint64_t seed, Surface surface, std::uint64_t index);

// Two triangles in one draw, on opposite sides of an edge with bit-identical ends. In at least half
// of the scenes the edge passes through pixel centres.
Scene shared_edge_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

// The primitives drawn to a multisampled target.
enum class MultisampledKind { triangle, line, wide_line };

// One triangle, line of width 1, or line of another width (1.25 to 16 pixels, a multiple of 1/4) on
// a target with these sample positions. Ties involve samples: on an edge of the triangle, or on an
// end or a side of the line's rectangle.
Scene random_multisampled_scene(std::uint64_t seed, MultisampledKind kind,
                                const SamplePositions& samples, std::uint64_t index);

// Random scenes of primitives that share vertices, and of vertices near the steps of sub-pixel
// grids, for searches in addition to the single primitives above.
//
// Each depends only on its seed and index, on the same targets, with coordinates that reach OpenGL
// unrounded. Most are built round a tie, many of them nudged off it.
constexpr int kMostCompoundTarget = 64;  // pixels

// A chain of two to six segments, each starting bit-identically where the previous one ends: a
// strip, a loop or separate lines in one draw. Half of them keep one major axis and direction, the
// others turn at joints, some turn back. One in eight is wider than a pixel.
Scene random_joint_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

// Triangles that share vertices, in one draw: all or part of the way round an inner vertex, along a
// strip, down to slivers, or with a vertex of two on the edge of a third (a T-junction). As a fan
// or strip, or as separate triangles with their vertices in any order.
Scene random_fan_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

// A point, line or triangle with vertices at multiples of 2^-b pixel (b is 4 or 8, sometimes 2 to
// 12), halfway between two, or 2^-16 beside either, so near to a tie that the snapping of vertices
// decides it.
Scene random_snap_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

// Random scenes of triangles with fragment operations. Each depends only on its seed and index,
// too.
enum class OutputKind {
  depth_tested,  // intersecting, and of equal depth
  blended,       // any equation and factors
  offset,        // each drawn again with a polygon offset, depth-tested
  stencilled,    // both facings, any function, operations and masks
};
template <>
inline constexpr auto kNames<OutputKind> =
    std::to_array<Named<OutputKind>>({{OutputKind::depth_tested, "depth-tested"},
                                      {OutputKind::blended, "blended"},
                                      {OutputKind::offset, "offset"},
                                      {OutputKind::stencilled, "stencilled"}});

struct RandomOutputScenes {
  std::uint64_t seed = 1;
  OutputKind kind = OutputKind::depth_tested;
  Surface surface = Surface::fbo;
  DepthFormat depth = DepthFormat::depth24;  // unused for `blended`
};

// Two to six flat triangles, a draw each, on a target of at most kMostMultisampledTarget pixels.
Scene random_output_scene(const RandomOutputScenes& of, std::uint64_t index);

}  // namespace edgecase
