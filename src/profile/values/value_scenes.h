// SPDX-License-Identifier: MIT
//
// Random scenes for measuring values: colours, depths, derivatives, depth buffers.
//
// Each depends only on its seed and index, like those of generate/random_scenes.h, with the same
// shapes and grids. The inputs of interpolation vary as well: colours in 0 to 1 and beyond, through
// zero, of tiny and of huge ranges, constant; any depths; equal w or ratios up to 2^16.
//
// OpenGL gets the exact numbers: (window position - centre) / (size / 2) * w is a float32 number,
// and so is z * w. Every w is a power of two times 1, 3, 5 or 7, and just a power of two if the odd
// factor would take bits that the coordinates need.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "generate/random_source.h"
#include "model/scene.h"

namespace edgecase {

// A primitive and its interpolation; errors are counted separately for each mode.
struct ValueMode {
  PrimitiveKind kind = PrimitiveKind::triangle;  // a triangle or lines
  Interpolation interpolation = Interpolation::smooth;
  bool perspective = false;  // the w of a primitive differ
};

// Triangles, then lines.
std::span<const ValueMode> all_value_modes();
// "triangle smooth", "line noperspective, w differ", …
std::string name_of(const ValueMode& mode);

// Scenes of different purposes are independent.
enum class ValuePurpose { traits, errors };

struct ValueScenes {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  ValueMode mode;
  ValuePurpose purpose = ValuePurpose::errors;
};

// One draw: a triangle, or kLinesPerScene separate lines, all with extent. If the w differ and
// colours are noperspective, gl_FragCoord is requested.
constexpr int kLinesPerScene = 24;
Scene value_scene(const ValueScenes& of, std::uint64_t index);

// A triangle of some hundred pixels with ratios of w from 4 up, so that derivative methods differ;
// requests the derivatives. The target's height is even or odd.
Scene derivative_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

// A large triangle with depths spread over 0 to 1, on a target with a depth buffer.
Scene depth_scene(std::uint64_t seed, Surface surface, DepthFormat format, std::uint64_t index);

}  // namespace edgecase
