// SPDX-License-Identifier: MIT
//
// Random scenes whose vertices lie inside and outside of the clip volume, behind the eye too.
#pragma once

#include <random>

#include "model/scene.h"

namespace edgecase {

class ClippedScenes {
 public:
  explicit ClippedScenes(unsigned seed) : random_(seed) {}

  int between(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  // Clip coordinates that are small integers, so that vertices lie on planes and edges run through
  // samples.
  Vertex vertex();
  // All of them in front of the eye, and between -w and w.
  Vertex vertex_inside();
  // Of 8 x 8 pixels, seen through `viewport`.
  Scene scene(Primitive primitive, std::size_t vertices, const Viewport& viewport);

 private:
  std::mt19937_64 random_;
};

Vertex clip_vertex(const ClipPosition& clip);

}  // namespace edgecase
