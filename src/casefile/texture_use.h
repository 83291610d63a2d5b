// SPDX-License-Identifier: MIT
//
// How a draw looks up its texture: "texture", "sampler" and "lookup" of a state, and "uv" of its
// vertices.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "casefile/fields.h"
#include "casefile/json_layout.h"
#include "casefile/texture_reader.h"
#include "model/texture.h"

namespace edgecase {

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

// The inverse: "texture", and "sampler" and "lookup" where they are not the defaults. `dimensions`
// are the texture's.
std::vector<JsonPiece> texture_use_pieces(const TextureUse& use, int dimensions);

// "uv".
JsonPiece uv_piece(const std::array<float, 2>& coordinates, int dimensions);

}  // namespace edgecase
