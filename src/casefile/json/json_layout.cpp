// SPDX-License-Identifier: MIT
#include "casefile/json/json_layout.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace edgecase {

namespace {

constexpr std::size_t kLineLength = 100;

std::string in_quotes(std::string_view text) {
  return nlohmann::json(text).dump();
}

std::string key_of(const JsonPiece& piece) {
  return piece.name.empty() ? "" : in_quotes(piece.name) + ": ";
}

char opening(const JsonPiece& piece) {
  return piece.kind == JsonPiece::Kind::array ? '[' : '{';
}

char closing(const JsonPiece& piece) {
  return piece.kind == JsonPiece::Kind::array ? ']' : '}';
}

bool has_broken_part(const JsonPiece& piece) {
  return piece.broken || std::ranges::any_of(piece.children, has_broken_part);
}

// The value on one line, without its key.
std::string on_one_line(const JsonPiece& piece) {
  if (piece.kind == JsonPiece::Kind::scalar) return piece.text;
  std::string text(1, opening(piece));
  for (const JsonPiece& child : piece.children) {
    if (text.size() > 1) text += ", ";
    text += key_of(child) + on_one_line(child);
  }
  return text + closing(piece);
}

// Appends the value, without its key. `column`: characters before it on its line; `after`:
// characters behind it on its last line.
void append(const JsonPiece& piece, std::size_t indent, std::size_t column, std::size_t after,
            std::string& text) {
  const std::string line = has_broken_part(piece) ? "" : on_one_line(piece);
  if (piece.kind == JsonPiece::Kind::scalar || piece.children.empty() ||
      (!line.empty() && column + line.size() + after <= kLineLength)) {
    text += line.empty() ? on_one_line(piece) : line;
    return;
  }
  text += opening(piece);
  const std::size_t inner = indent + 2;
  for (std::size_t i = 0; i < piece.children.size(); ++i) {
    const JsonPiece& child = piece.children[i];
    const bool new_line = i % piece.together == 0;
    if (i != 0) text += new_line ? "," : ", ";
    if (new_line) text += '\n' + std::string(inner, ' ');
    const std::string key = key_of(child);
    text += key;
    append(child, inner, inner + key.size(), 1, text);
  }
  text += '\n' + std::string(indent, ' ') + closing(piece);
}

}  // namespace

JsonPiece json_scalar(std::string text) {
  JsonPiece piece;
  piece.text = std::move(text);
  return piece;
}

JsonPiece json_string(std::string_view text) {
  return json_scalar(in_quotes(text));
}

JsonPiece json_array(std::vector<JsonPiece> items) {
  JsonPiece piece;
  piece.kind = JsonPiece::Kind::array;
  piece.children = std::move(items);
  return piece;
}

JsonPiece json_strings(std::span<const std::string> texts) {
  Pieces items;
  for (const std::string& text : texts) items.push_back(json_string(text));
  return json_array(std::move(items));
}

JsonPiece json_object(std::vector<JsonPiece> members) {
  JsonPiece piece;
  piece.kind = JsonPiece::Kind::object;
  piece.children = std::move(members);
  return piece;
}

JsonPiece named(std::string name, JsonPiece piece) {
  piece.name = std::move(name);
  return piece;
}

std::string lay_out(const JsonPiece& piece) {
  std::string text;
  append(piece, 0, 0, 0, text);
  return text + '\n';
}

namespace {

// The line where a child begins; a member begins with its key.
int first_line(const JsonNode& child) {
  return child.name_line > 0 ? child.name_line : child.line;
}

// The number of children on the line of the first.
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
    case JsonKind::null:
    case JsonKind::array:
    case JsonKind::object:
      break;
  }
  return json_scalar("null");
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
