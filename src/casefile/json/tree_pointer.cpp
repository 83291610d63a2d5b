// SPDX-License-Identifier: MIT
#include "casefile/json/json_document.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <utility>

namespace edgecase {

namespace {

constexpr std::size_t kVertexDepth = 4;  // parts of /draws/I/vertices/J

// "~0" is '~', "~1" is '/'; nothing for any other '~'.
std::optional<std::string> unescape(std::string_view part) {
  std::string result;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] != '~') {
      result += part[i];
      continue;
    }
    ++i;
    if (i == part.size() || (part[i] != '0' && part[i] != '1')) return std::nullopt;
    result += part[i] == '0' ? '~' : '/';
  }
  return result;
}

// An array's index: digits without leading zeros.
std::optional<std::size_t> index_of(const std::string& token) {
  if (token.empty() || (token[0] == '0' && token.size() > 1)) return std::nullopt;
  std::size_t index = 0;
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, index);
  if (error != std::errc() || stop != end) return std::nullopt;
  return index;
}

JsonNode* find_member(JsonNode& object, const std::string& name) {
  for (JsonNode& child : object.children)
    if (child.name == name) return &child;
  return nullptr;
}

JsonNode& append(JsonNode& parent, JsonKind kind, const std::string& name) {
  JsonNode node;
  node.kind = kind;
  node.line = node.name_line = parent.line;
  node.name = name;
  return parent.children.emplace_back(std::move(node));
}

// A coordinate of a vertex; z and w that a window position omits are added to the tree.
JsonNode* coordinate_of(JsonNode& vertex, std::size_t index) {
  JsonNode* position = &vertex;
  if (vertex.kind == JsonKind::object) position = find_position(vertex);
  if (position == nullptr || position->kind != JsonKind::array) return nullptr;
  if (position->name == "clip" || position->name == "object")
    return index < position->children.size() ? &position->children[index] : nullptr;
  if (position->children.size() < 2) return nullptr;
  while (position->children.size() <= index) {
    const bool is_z = position->children.size() == 2;
    append(*position, JsonKind::number, "").text = is_z ? "0" : "1";
  }
  return &position->children[index];
}

// [x, y] becomes {"at": [x, y]}.
void make_object(JsonNode& vertex) {
  JsonNode position = std::exchange(vertex, {});
  vertex.kind = JsonKind::object;
  vertex.line = position.line;
  vertex.name_line = position.name_line;
  position.name = "at";
  position.name_line = position.line;
  vertex.children.push_back(std::move(position));
}

JsonNode* child_of(JsonNode& node, const std::string& token, Missing missing) {
  if (node.kind == JsonKind::array) {
    const std::optional<std::size_t> index = index_of(token);
    return index && *index < node.children.size() ? &node.children[*index] : nullptr;
  }
  if (node.kind != JsonKind::object) return nullptr;
  JsonNode* found = find_member(node, token);
  if (found != nullptr || missing == Missing::stays) return found;
  return &append(node, JsonKind::object, token);
}

// s or t of a vertex that has texture coordinates.
JsonNode* texture_coordinate_of(JsonNode& vertex, std::size_t index) {
  JsonNode* uv = vertex.kind == JsonKind::object ? find_member(vertex, "uv") : nullptr;
  if (uv == nullptr || uv->kind != JsonKind::array) return nullptr;
  return index < uv->children.size() ? &uv->children[index] : nullptr;
}

JsonNode* part_of_vertex(JsonNode& vertex, const std::string& token, Missing missing) {
  constexpr std::string_view kAxes = "xyzw";
  if (token.size() == 1 && kAxes.find(token[0]) != std::string_view::npos)
    return coordinate_of(vertex, kAxes.find(token[0]));
  if (token == "s" || token == "t") return texture_coordinate_of(vertex, token == "s" ? 0 : 1);
  const bool named = token == "at" || token == "color" || token == "uv";
  if (vertex.kind == JsonKind::array && named) make_object(vertex);
  return child_of(vertex, token, missing);
}

}  // namespace

std::optional<Tokens> split_pointer(std::string_view text) {
  Tokens tokens;
  if (text.empty() || text[0] != '/') return std::nullopt;
  for (std::size_t start = 1; start <= text.size();) {
    const std::size_t end = std::min(text.find('/', start), text.size());
    auto token = unescape(text.substr(start, end - start));
    if (!token) return std::nullopt;
    tokens.push_back(std::move(*token));
    start = end + 1;
  }
  return tokens;
}

JsonNode* find_position(JsonNode& vertex) {
  for (const char* name : {"at", "clip", "object"})
    if (JsonNode* found = find_member(vertex, name)) return found;
  return nullptr;
}

bool is_vertex_pointer(const Tokens& tokens) {
  return tokens.size() == kVertexDepth && tokens[0] == "draws" && tokens[2] == "vertices";
}

JsonNode* find_at(JsonNode& root, const Tokens& tokens, Missing missing) {
  JsonNode* node = &root;
  for (std::size_t i = 0; i < tokens.size() && node != nullptr; ++i) {
    const Tokens before(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(i));
    node = is_vertex_pointer(before) ? part_of_vertex(*node, tokens[i], missing)
                                     : child_of(*node, tokens[i], missing);
  }
  return node;
}

}  // namespace edgecase
