// SPDX-License-Identifier: MIT
//
// Random scenes of one textured primitive each.
#pragma once

#include "model/scene.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {

// An endless row of them, the same on every machine for the same seed: 8 by 8 pixels, textures of 1
// to 9 texels a side in all formats, all samplers and lookups, w from 1/4 to 4. Half of them have
// everything on grids, where ties are.
class TexturedScenes {
 public:
  explicit TexturedScenes(std::uint64_t seed) : numbers_(seed) {}
  Scene next();

 private:
  Texture texture();
  Sampler sampler(int levels);
  Vertex vertex(bool perspective);
  void straighten(Draw& draw);
  Draw draw(const Sampler& sampler);
  float on(double step, std::int64_t limit);
  float number(double step, std::int64_t limit);

  RandomNumbers numbers_;
  bool on_grid_ = true;
  int width_ = 1;
  int height_ = 1;
};

}  // namespace edgecase
