// SPDX-License-Identifier: MIT
#include "casefile/number_pieces.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "casefile/float_numeral.h"

namespace edgecase {

JsonPiece integer_piece(int value) {
  return json_scalar(std::to_string(value));
}

JsonPiece component_piece(float value) {
  return json_scalar(short_decimal(value + 0.0F));
}

JsonPiece color_piece(const std::array<float, 4>& color) {
  std::vector<JsonPiece> components;
  const std::size_t count = color[3] == 1 ? 3 : 4;  // alpha is 1 if not said
  for (std::size_t i = 0; i < count; ++i) components.push_back(component_piece(color[i]));
  return json_array(std::move(components));
}

JsonPiece exact_piece(float value) {
  return json_scalar(exact_decimal(value + 0.0F));
}

JsonPiece exact_list(std::span<const float> values) {
  std::vector<JsonPiece> items;
  for (const float value : values) items.push_back(exact_piece(value));
  return json_array(std::move(items));
}

}  // namespace edgecase
