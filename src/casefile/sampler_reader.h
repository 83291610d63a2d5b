// SPDX-License-Identifier: MIT
//
// Reads how a draw looks up its texture: "texture", "sampler" and "lookup" of a state.
#pragma once

#include <optional>

#include "casefile/fields.h"
#include "casefile/texture_reader.h"
#include "model/texture.h"

namespace edgecase {

constexpr float kMaxLod = 1000;          // largest magnitude of a level of detail
constexpr int kMostLevel = 1000;         // largest base_level and max_level
constexpr float kMaxGradient = 1048576;  // largest magnitude of a given gradient, per pixel

// What a state says; `use` is none without a texture, and where its number is wrong.
struct TextureState {
  bool textured = false;  // there is a "texture"
  std::optional<TextureUse> use;
  int dimensions = 0;  // of the texture; 0: it is faulty, and nothing is known of it
};

// `textures` are the case's; none: their list is faulty, so that no number can be judged.
TextureState read_texture_state(const ObjectReader& state,
                                const std::optional<TextureList>& textures, Findings& findings);

}  // namespace edgecase
