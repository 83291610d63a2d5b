// SPDX-License-Identifier: MIT
//
// Random scenes of triangles that meet fragment operations, by which a profile is held against the
// renderer that it is of. See generate/random_scenes.h; each is a function of its seed and
// index alone, too.
#pragma once

#include <cstdint>

#include "model/scene.h"

namespace edgecase {

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
