// SPDX-License-Identifier: MIT
#include "raster/texture_stage.h"

#include <algorithm>

namespace edgecase {
namespace {

bool have_same_sizes(const std::vector<TextureLevel>& a, const std::vector<TextureLevel>& b) {
  return std::ranges::equal(a, b, [](const TextureLevel& left, const TextureLevel& right) {
    return left.width == right.width && left.height == right.height;
  });
}

}  // namespace

TextureStage::TextureStage(const Scene& scene, const RuleChoices& choices)
    : scene_(scene), choices_(choices) {
  const TextureChoice& choice = choices.textures;
  const MipmapMethod& method = choice.mipmap;
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    const Texture& texture = *scene.textures[i];
    if (texture.generated)
      chains_[i] = mip_chain(texture.levels.at(0), texture.format, choice.level_count, method);
    decoded_.push_back(decode(texture, texture.generated ? chains_[i] : texture.levels));
  }
}

void TextureStage::take_chains(const std::map<std::size_t, std::vector<TextureLevel>>& chains) {
  for (const auto& [number, levels] : chains) {
    // Levels of other sizes than the chain's are a fault of their own: nothing is looked up in
    // them.
    const auto own = chains_.find(number);
    if (own == chains_.end() || !have_same_sizes(own->second, levels)) continue;
    chains_[number] = levels;
    decoded_[number] = decode(*scene_.textures[number], levels);
  }
}

ExactLookup TextureStage::look_up(const ScenePrimitive& primitive,
                                  const PrimitiveAttributes& attributes,
                                  PixelPosition pixel) const {
  return TexturedPrimitive(*this, primitive, attributes).look_up(pixel);
}

}  // namespace edgecase
