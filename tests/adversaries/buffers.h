// SPDX-License-Identifier: MIT
//
// What an adversary stores (GL 4.6 core, 17.3, 17.4 and 18.3.1).
#pragma once

#include <array>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "tests/adversaries/values.h"

namespace edgecase::adversary {

class Buffers {
 public:
  // `samples`: of the whole target.
  Buffers(const Scene& scene, const Freedoms& freedoms, std::size_t samples);

  // A fragment meets the sample at an index.
  void meet(std::size_t index, const Draw& draw, bool front, const Values4& color, double depth);
  // Fills in pixels, depths, stencils and hits.
  void tell(Rendering& rendering) const;

 private:
  Values4 blended(const Blending& blending, Values4 source, const Values4& stored) const;
  double in_codes(double number) const;
  double stored_depth(double depth, int draw_luck) const;

  const Scene& scene_;
  const Freedoms& freedoms_;
  std::vector<Values4> colors_;
  std::vector<double> depths_;
  std::vector<std::uint8_t> stencils_;
  std::vector<std::uint32_t> hits_;
  int meetings_ = 0;
};

}  // namespace edgecase::adversary
