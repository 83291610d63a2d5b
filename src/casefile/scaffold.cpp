// SPDX-License-Identifier: MIT
#include "casefile/scaffold.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "casefile/case_writer.h"
#include "casefile/json/json_document.h"
#include "casefile/json/json_layout.h"
#include "exact/numeral.h"

namespace edgecase {
namespace {

constexpr int kLeastTarget = 8;
constexpr int kMostTarget = 4096;

// The parts of a text between separators; none of an empty text.
std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  std::size_t start = 0;
  while (true) {
    const std::size_t end = text.find(separator, start);
    parts.emplace_back(text.substr(start, end - start));
    if (end == std::string_view::npos) return parts;
    start = end + 1;
  }
}

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words = split(text, ' ');
  std::erase(words, "");
  return words;
}

// A number if JSON accepts it as one, such as 10.5; otherwise a string, such as "21/2".
JsonPiece numeral_piece(const std::string& numeral) {
  const bool is_number =
      !numeral.empty() &&
      (numeral.front() == '-' || (numeral.front() >= '0' && numeral.front() <= '9')) &&
      nlohmann::json::accept(numeral);
  return is_number ? json_scalar(numeral) : json_string(numeral);
}

JsonPiece target_piece(const Scaffold& scaffold) {
  Pieces members{named("width", json_scalar(std::to_string(scaffold.width))),
                 named("height", json_scalar(std::to_string(scaffold.height)))};
  if (scaffold.samples != 1)
    members.push_back(named("samples", json_scalar(std::to_string(scaffold.samples))));
  add_word("surface", scaffold.surface, members);
  add_word("depth", scaffold.depth, members);
  return json_object(std::move(members));
}

JsonPiece draw_piece(const ScaffoldDraw& draw) {
  Pieces vertices;
  for (const auto& numerals : draw.vertices) {
    Pieces coordinates;
    for (const std::string& numeral : numerals) coordinates.push_back(numeral_piece(numeral));
    vertices.push_back(json_array(std::move(coordinates)));
  }
  return json_object({named("primitive", json_string(draw.primitive)),
                      named("vertices", json_array(std::move(vertices)))});
}

JsonNode string_node(std::string text, int line) {
  JsonNode node;
  node.kind = JsonKind::string;
  node.line = line;
  node.text = std::move(text);
  return node;
}

// An object or array that opens on `line`, with each child on a line of its own.
JsonNode parent_node(JsonKind kind, std::string name, int line, std::vector<JsonNode> children) {
  JsonNode node;
  node.kind = kind;
  node.line = line;
  node.name = std::move(name);
  node.name_line = node.name.empty() ? 0 : line;
  node.children = std::move(children);
  return node;
}

void drop(const char* name, JsonNode& node) {
  std::erase_if(node.children, [&](const JsonNode& child) { return child.name == name; });
}

JsonNode* member(const char* name, JsonNode& node) {
  const auto found = std::ranges::find(node.children, name, &JsonNode::name);
  return found == node.children.end() ? nullptr : &*found;
}

// A vertex with nothing but its position is written as just that.
void drop_color_of_vertex(JsonNode& vertex) {
  if (vertex.kind != JsonKind::object) return;
  drop("color", vertex);
  if (vertex.children.size() != 1 || vertex.children.front().name != "at") return;
  JsonNode place = std::move(vertex.children.front());
  place.name.clear();
  place.name_line = 0;
  vertex = std::move(place);
}

}  // namespace

std::variant<ScaffoldDraw, std::string> parse_scaffold_draw(std::string_view text) {
  const std::vector<std::string> words = split_words(text);
  if (words.size() < 2)
    return fmt::format(
        "\"{}\" is no draw; write a primitive and its vertices, like "
        "\"lines 0.5,0.5 6,1+1/2\"",
        text);
  ScaffoldDraw draw;
  draw.primitive = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) {
    draw.vertices.push_back(split(words[i], ','));
    const auto& numerals = draw.vertices.back();
    if (numerals.size() < 2 || numerals.size() > 4)
      return fmt::format("\"{}\" is no vertex; write X,Y or X,Y,Z or X,Y,Z,W without spaces",
                         words[i]);
  }
  return draw;
}

int least_target(const std::vector<ScaffoldDraw>& draws) {
  int size = kLeastTarget;
  for (const ScaffoldDraw& draw : draws)
    for (const auto& numerals : draw.vertices)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto parsed = parse_numeral(numerals[axis]);
        const Fixed* value = std::get_if<Fixed>(&parsed);
        if (value == nullptr) continue;
        while (size < kMostTarget && Fixed::from_integer(size) < *value) size *= 2;
      }
  return size;
}

std::string scaffold_text(const Scaffold& scaffold) {
  const CaseWords& words = scaffold.words;
  Pieces members = word_pieces(words);
  members.push_back(named("target", target_piece(scaffold)));
  Pieces draws;
  for (const ScaffoldDraw& draw : scaffold.draws) draws.push_back(draw_piece(draw));
  JsonPiece list = json_array(std::move(draws));
  list.broken = true;
  members.push_back(named("draws", std::move(list)));
  JsonPiece piece = json_object(std::move(members));
  piece.broken = true;
  return lay_out(piece);
}

std::string with_drawing(const std::string& text, const std::vector<std::string>& rows) {
  JsonDocument document = parse_json(text, "");
  // The layout breaks lines by the nodes' line numbers, of which only the order matters.
  const int line = static_cast<int>(std::ranges::count(text, '\n')) + 1;
  std::vector<JsonNode> drawing;
  for (std::size_t row = 0; row < rows.size(); ++row)
    drawing.push_back(string_node(rows[row], line + 3 + static_cast<int>(row)));
  std::vector<JsonNode> item;
  item.push_back(parent_node(JsonKind::array, "coverage", line + 2, std::move(drawing)));
  std::vector<JsonNode> list;
  list.push_back(parent_node(JsonKind::object, "", line + 1, std::move(item)));
  document.root->children.push_back(parent_node(JsonKind::array, "expect", line, std::move(list)));
  return laid_out(*document.root);
}

std::string without_colors(const std::string& text) {
  JsonDocument document = parse_json(text, "");
  if (JsonNode* target = member("target", *document.root)) drop("clear", *target);
  if (JsonNode* draws = member("draws", *document.root))
    for (JsonNode& draw : draws->children) {
      drop("color", draw);
      if (JsonNode* vertices = member("vertices", draw))
        for (JsonNode& vertex : vertices->children) drop_color_of_vertex(vertex);
    }
  return laid_out(*document.root);
}

}  // namespace edgecase
