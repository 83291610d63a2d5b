// SPDX-License-Identifier: MIT
//
// Images of a scene: other scenes of which a law says how they are drawn (GL 4.6 core, 14.2 and
// appendix A; rulings 67 and 70): at another place, with other masks, or once more.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "model/scene.h"
#include "rules/coverage/window.h"

namespace edgecase {

struct SceneImage {
  std::string text;  // what it is: "is moved by 47 pixels to the right and 45 up"
  // What it is an image of; null: the scene itself. Images that follow each other may share it.
  std::shared_ptr<const Scene> first;
  Scene second;
  // How far pixels of `second` lie right of and above those of `first`, and how far its primitives
  // come behind.
  int right = 0;
  int up = 0;
  int behind = 0;
  std::optional<PixelBounds> part;  // of `first`: nothing else is compared
  // Whether depths and colours of fragments are to be the same, and not only that they are there.
  bool has_values = false;
  bool has_pixels = false;       // whether colours of the target are
  bool has_tests = false;        // whether depths, stencils and hits are
  int ruling = kRulingOnImages;  // that judges what differs
};

// The images of a scene about which the specification speaks:
//
//   moved      by whole pixels (14.2), for scenes of one sample whose primitives lie in the target
//              and are not divided by w. Both scenes have a target of 64 or 128 pixels, whose
//              window coordinates float32 holds exactly, so that no rounding differs.
//   masked     with all colours masked and another clear colour (A.3, rule 2)
//   repeated   drawn once more (A.3, rule 1)
//   scissored  with a part of the target for a scissor box (A.3, rule 2), of a scene that has the
//              scissor test, since its enable is excepted
//   after      behind a first drawing of the same, which changes what buffers hold (A.3, rule 2)
//   blended    with other parameters of blending and a depth buffer that nothing reads: A.3 only
//              suggests it (ruling 70), so it is among them only if `suggested`
std::vector<SceneImage> images_of(const Scene& scene, bool suggested = true);

// Half the largest side, in pixels, of a target in which float32 holds the window coordinates of
// all vertices exactly, whichever way they are computed.
constexpr int kLargestMoved = 64;

bool is_whole_target(const Viewport& viewport, const Target& target);

// True if neither the primitive nor its image is cut by the sides of the target, and nothing is
// rounded as its vertices get their places.
bool lies_inside(const ScenePrimitive& primitive, const Target& target);

}  // namespace edgecase
