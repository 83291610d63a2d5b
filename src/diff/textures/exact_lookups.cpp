// SPDX-License-Identifier: MIT
#include "diff/textures/exact_lookups.h"

#include <algorithm>

namespace edgecase {
namespace {

// True if lookups can be made in the chain, whatever its sizes.
bool is_chain(const std::vector<TextureLevel>& levels) {
  return !levels.empty() && std::ranges::all_of(levels, [](const TextureLevel& level) {
    return level.width > 0 && level.height > 0 &&
           level.texels.size() == level.index(0, level.height);
  });
}

}  // namespace

ExactLookups::ExactLookups(const ValueContext& context, const Rendering& exact,
                           const Rendering& rendered)
    : context_(context),
      exact_(exact),
      rendered_(rendered),
      stage_(context.scene, context.choices),
      primitives_(context.primitives.size()) {
  for (const auto& [number, chain] : rendered.mip_chains) {
    const auto in_force = stage_.chains().find(number);
    if (in_force == stage_.chains().end() || in_force->second == chain || !is_chain(chain))
      continue;
    stage_.take_chains({{number, chain}});
    if (in_force->second == chain)
      changed_.insert(number);
    else
      own_[number] = decode(*context.scene.textures[number], chain);
  }
}

const DecodedTexture& ExactLookups::decoded(std::size_t texture) const {
  const auto own = own_.find(texture);
  return own == own_.end() ? stage_.decoded(texture) : own->second;
}

std::size_t ExactLookups::texture_of(const Fragment& fragment) const {
  return context_.primitive_of(fragment).state->texture->texture;
}

bool ExactLookups::reports_level(const Fragment& fragment) const {
  return fragment.detail >= 0 &&
         rendered_.details[static_cast<std::size_t>(fragment.detail)].level_of_detail.has_value();
}

// The fragment of exact with the same lookup in the same texels; null if there is none.
const Fragment* ExactLookups::drawn(const Fragment& fragment) const {
  if (changed_.contains(texture_of(fragment))) return nullptr;
  const auto found = std::ranges::lower_bound(exact_.fragments, fragment, precedes);
  const bool is_there = found != exact_.fragments.end() && !precedes(fragment, *found);
  return is_there ? &*found : nullptr;
}

TexturedPrimitive& ExactLookups::primitive_of(const Fragment& fragment) {
  auto& primitive = primitives_[static_cast<std::size_t>(fragment.primitive)];
  if (!primitive)
    primitive = std::make_unique<TexturedPrimitive>(stage_, context_.primitive_of(fragment),
                                                    context_.values_of(fragment).chosen);
  return *primitive;
}

LookedUp ExactLookups::look_up(const Fragment& fragment) {
  const PixelPosition pixel{fragment.x, fragment.y};
  LookedUp result;
  if (reports_level(fragment))
    std::ranges::transform(primitive_of(fragment).queried(pixel), result.level_of_detail.begin(),
                           middle);
  if (const Fragment* own = drawn(fragment))
    result.color = own->color;
  else
    std::ranges::transform(primitive_of(fragment).look_up(pixel).color, result.color.begin(),
                           middle);
  return result;
}

}  // namespace edgecase
