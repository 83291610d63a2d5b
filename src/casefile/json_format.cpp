// SPDX-License-Identifier: MIT
#include "casefile/json_format.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "casefile/json_layout.h"

namespace edgecase {
namespace {

// Where a child begins: an object's members begin with their keys.
int first_line(const JsonNode& child) {
  return child.name_line > 0 ? child.name_line : child.line;
}

// How many children stand on the line of the first.
std::size_t on_first_line(const JsonNode& node) {
  const auto next = std::ranges::find_if(node.children, [&](const JsonNode& child) {
    return first_line(child) != first_line(node.children.front());
  });
  return static_cast<std::size_t>(next - node.children.begin());
}

JsonPiece scalar_piece(const JsonNode& node) {
  switch (node.kind) {
    case JsonKind::boolean:
      return json_scalar(node.truth ? "true" : "false");
    case JsonKind::number:
      return json_scalar(node.text);
    case JsonKind::string:
      return json_string(node.text);
    default:
      return json_scalar("null");
  }
}

JsonPiece piece_of(const JsonNode& node) {
  if (node.kind != JsonKind::array && node.kind != JsonKind::object) return scalar_piece(node);
  std::vector<JsonPiece> children;
  for (const JsonNode& child : node.children) {
    JsonPiece piece = piece_of(child);
    piece.name = child.name;
    children.push_back(std::move(piece));
  }
  const bool is_array = node.kind == JsonKind::array;
  JsonPiece piece = is_array ? json_array(std::move(children)) : json_object(std::move(children));
  if (node.children.empty()) return piece;
  piece.broken = first_line(node.children.front()) > node.line;
  if (is_array && piece.broken) piece.together = on_first_line(node);
  return piece;
}

}  // namespace

std::string laid_out(const JsonNode& root) {
  return lay_out(piece_of(root));
}

}  // namespace edgecase
