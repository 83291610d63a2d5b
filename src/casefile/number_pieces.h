// SPDX-License-Identifier: MIT
//
// Numbers and colours as a case file has them.
#pragma once

#include <array>
#include <span>

#include "casefile/json_layout.h"

namespace edgecase {

JsonPiece integer_piece(int value);

// A colour's component: the shortest decimal whose nearest float32 it is; -0 is written as 0.
JsonPiece component_piece(float value);

// Red, green, blue and, where it is not 1, alpha.
JsonPiece color_piece(const std::array<float, 4>& color);

// A finite float32 number with all its digits; -0 is written as 0.
JsonPiece exact_piece(float value);
JsonPiece exact_list(std::span<const float> values);

}  // namespace edgecase
