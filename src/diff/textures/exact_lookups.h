// SPDX-License-Identifier: MIT
//
// The exact lookups of a rendering's fragments under a policy, and the texels that they use.
//
// A generated chain that the renderer reports is used as it is: compare_mip_chains reports its
// differences, once.
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

// A lookup in the form that Rendering has.
struct LookedUp {
  std::array<double, 2> level_of_detail{};  // as FragmentDetail::level_of_detail
  std::array<double, 4> color{};
};

class ExactLookups {
 public:
  // Everything referred to must outlive this. `exact`: the context's policy, in part or whole.
  ExactLookups(const ValueContext& context, const Rendering& exact, const Rendering& rendered);

  // The texels of the scene's textures in which the renderer looked up.
  const DecodedTexture& decoded(std::size_t texture) const;

  // The exact lookup of a fragment of a textured draw; its level of detail only if the renderer
  // reports one. Taken from exact's fragment if there is one with the same texels; else computed.
  LookedUp look_up(const Fragment& fragment);

 private:
  const Fragment* drawn(const Fragment& fragment) const;
  TexturedPrimitive& primitive_of(const Fragment& fragment);
  std::size_t texture_of(const Fragment& fragment) const;
  bool reports_level(const Fragment& fragment) const;

  const ValueContext& context_;
  const Rendering& exact_;
  const Rendering& rendered_;
  TextureStage stage_;
  std::set<std::size_t> changed_;  // textures with the renderer's chains in place of exact's
  // The renderer's chains whose sizes are wrong, by texture index.
  std::map<std::size_t, DecodedTexture> own_;
  std::vector<std::unique_ptr<TexturedPrimitive>> primitives_;  // for lookups computed here
};

}  // namespace edgecase
