// SPDX-License-Identifier: MIT
//
// Random scenes of the values of fragments: colours and depths, of any interpolation, with equal w
// or ratios up to 2^16.
//
// Each depends only on its seed and index, like those of generate/random_scenes.h, with the same
// shapes and grids. Colours lie in 0 to 1 and beyond, go through zero, have tiny or huge ranges or
// none. Depths are any.
//
// OpenGL gets the exact numbers: (window position - centre) / (size / 2) * w is a float32 number,
// and so is z * w. Every w is a power of two times 1, 3, 5 or 7, and just a power of two if the odd
// factor would take bits that the coordinates need.
#pragma once

#include <cstdint>
#include <span>

#include "model/scene.h"

namespace edgecase {

// A primitive and its interpolation.
struct ValueMode {
  PrimitiveKind kind = PrimitiveKind::triangle;  // a triangle or lines
  Interpolation interpolation = Interpolation::smooth;
  bool perspective = false;  // the w of a primitive differ
};

// Triangles, then lines.
std::span<const ValueMode> all_value_modes();

struct ValueScenes {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  ValueMode mode;
};

// One draw: a triangle, or kLinesPerScene separate lines, all with extent. If the w differ and
// colours are noperspective, gl_FragCoord is requested.
constexpr int kLinesPerScene = 24;
Scene value_scene(const ValueScenes& of, std::uint64_t index);

}  // namespace edgecase
