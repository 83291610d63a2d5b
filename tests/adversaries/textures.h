// SPDX-License-Identifier: MIT
//
// How an adversary looks textures up (GL 4.6 core, 8.14 and 8.24).
#pragma once

#include <array>
#include <map>
#include <vector>

#include "model/scene.h"
#include "tests/adversaries/values.h"

namespace edgecase::adversary {

struct LookedUp {
  Values4 color{};
  std::array<double, 2> queried{};  // as textureQueryLod tells them
};

class Textures {
 public:
  Textures(const Scene& scene, const Freedoms& freedoms);

  // `dx`, `dy`: what s and t grow by along x and y.
  LookedUp look_up(const TextureUse& use, const Values4& at, const Values4& dx,
                   const Values4& dy) const;
  const std::map<std::size_t, std::vector<TextureLevel>>& generated() const { return generated_; }

 private:
  using Pair = std::array<double, 2>;
  std::vector<TextureLevel> chain_of(const Texture& texture) const;
  double level_base(const TextureUse& use, Pair dx, Pair dy) const;
  double biased(const TextureUse& use, double base, double by_shader) const;
  Values4 in_level(const TextureUse& use, int level, Filter filter, const Values4& at) const;
  Values4 texel(const TextureUse& use, const TextureLevel& level, int i, int j) const;
  Values4 mixed(const TextureUse& use, const Values4& a, const Values4& b, double weight) const;
  const TextureLevel& level_of(const TextureUse& use, int level) const;

  const Scene& scene_;
  const Freedoms& freedoms_;
  std::map<std::size_t, std::vector<TextureLevel>> generated_;
};

}  // namespace edgecase::adversary
