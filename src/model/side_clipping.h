// SPDX-License-Identifier: MIT
//
// Points and lines at the sides of the view volume, where OpenGL and OpenGL ES differ.
//
// OpenGL clips lines at all six planes, and lets a point be discarded whose vertex lies outside of
// any (GL 4.6 core, 13.7). OpenGL ES clips both at the near and the far plane alone (3.2, 12.5): a
// point "is passed unchanged" between them, and to a line clipping "does nothing". So a wide point
// with its vertex beside the viewport reaches into it, and a wide line is not cut off at a right
// angle to its major axis where it leaves. Triangles are clipped at all six planes by both.
//
// A scene is OpenGL's. Of a renderer that is OpenGL ES the same scene is compared without sides.
#pragma once

#include <optional>

#include "model/scene.h"

namespace edgecase {

// Whether a vertex of a point or a line lies beyond a side of the viewport, or behind the eye.
bool leaves_sides(const ScenePrimitive& primitive);

// Whether a point or a line of the scene may be drawn differently by the two APIs.
bool leaves_sides(const Scene& scene);

// The point or line as the other API has it. Nothing if that is OpenGL ES, and a vertex or a cut
// end is then not exact: farther away than Fixed::kMaxCoordinate pixels, or no quotient of integers
// up to 2^32.
std::optional<ScenePrimitive> of_other_api(const ScenePrimitive& primitive);

// A scene by the rules of a renderer's API.
class SceneOfApi {
 public:
  // `scene` must outlive it.
  SceneOfApi(const Scene& scene, bool is_es);
  const Scene& scene() const { return own_ ? *own_ : *given_; }
  // Whether it is not the given one, so that exact draws it anew.
  bool is_own() const { return own_.has_value(); }
  // False if a point or a line is not exact, as above: nobody can be judged by it.
  bool is_exact() const { return is_exact_; }

 private:
  const Scene* given_;
  std::optional<Scene> own_;
  bool is_exact_ = true;
};

inline constexpr const char* kBeyondExactSides =
    "OpenGL ES does not clip points and lines at the viewport's sides, and the scene has some that "
    "reach farther than exact coordinates do";

}  // namespace edgecase
