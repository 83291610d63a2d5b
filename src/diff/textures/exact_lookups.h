// SPDX-License-Identifier: MIT
//
// What the fragments of a rendering look up exactly under a policy, and in which texels.
//
// Generated chains are the renderer's where it tells them: what differs in them is told once, by
// compare_mip_chains.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "diff/values/value_diff.h"
#include "raster/texture_stage.h"

namespace edgecase {

// A lookup as Rendering has it.
struct LookedUp {
  std::array<double, 2> level_of_detail{};  // as FragmentDetail::level_of_detail
  std::array<double, 4> color{};
};

class ExactLookups {
 public:
  // All must outlive this. `exact`: the scene as the context's policy has it, in part or whole.
  ExactLookups(const ValueContext& context, const Rendering& exact, const Rendering& rendered);

  // The texels of the scene's textures that the renderer looked up.
  const DecodedTexture& decoded(std::size_t texture) const;

  // Of one of the rendering's fragments, of a textured draw; of the level of detail only where the
  // renderer tells it. What exact has drawn is taken from there; where exact has no such fragment,
  // or with other texels, it is looked up here.
  LookedUp look_up(const Fragment& fragment);

 private:
  const Fragment* drawn(const Fragment& fragment) const;
  TexturedPrimitive& primitive_of(const Fragment& fragment);
  std::size_t texture_of(const Fragment& fragment) const;
  bool tells_level(const Fragment& fragment) const;

  const ValueContext& context_;
  const Rendering& exact_;
  const Rendering& rendered_;
  TextureStage stage_;
  std::set<std::size_t> changed_;  // textures that look up in the renderer's chains
  // The renderer's chains whose sizes are wrong, by the texture's number.
  std::map<std::size_t, DecodedTexture> own_;
  std::vector<std::unique_ptr<TexturedPrimitive>> primitives_;  // those that were looked up here
};

}  // namespace edgecase
