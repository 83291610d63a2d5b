// SPDX-License-Identifier: MIT
//
// Textures as a case file says them: the inverse of casefile/texture_reader.h.
#pragma once

#include "casefile/json_layout.h"
#include "model/texture.h"

namespace edgecase {

// An item of "textures". Images of more than a few texels are written as the pattern that makes
// them, where there is one. A chain that is neither generated, nor made by boxes, nor flat level by
// level cannot be said: its first level is written alone.
JsonPiece texture_piece(const Texture& texture);

}  // namespace edgecase
