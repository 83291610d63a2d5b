// SPDX-License-Identifier: MIT
//
// Textures and their lookups as a case file says them: the inverse of casefile/texture_reader.h and
// casefile/sampler_reader.h.
#pragma once

#include <array>
#include <vector>

#include "casefile/json_layout.h"
#include "model/texture.h"

namespace edgecase {

// An item of "textures". Images of more than a few texels are written as the pattern that makes
// them, where there is one. A chain that is neither generated, nor made by boxes, nor flat level by
// level cannot be said: its first level is written alone.
JsonPiece texture_piece(const Texture& texture);

// "texture", and "sampler" and "lookup" where they are not the defaults. `dimensions` are the
// texture's.
std::vector<JsonPiece> texture_use_pieces(const TextureUse& use, int dimensions);

// "uv".
JsonPiece uv_piece(const std::array<float, 2>& coordinates, int dimensions);

}  // namespace edgecase
