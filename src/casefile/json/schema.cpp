// SPDX-License-Identifier: MIT
#include "casefile/json/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "casefile/json/json_document.h"

namespace edgecase {

namespace {

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || c == '_';
}

const JsonPiece& find_blank(std::string_view name, const Pieces& blanks) {
  const auto found = std::ranges::find(blanks, name, &JsonPiece::name);
  if (found == blanks.end())
    throw std::logic_error(fmt::format("a schema has @{}, which nothing fills in", name));
  return *found;
}

// Joins a line that ends on a backslash with the next one, without the latter's indentation.
std::string joined(std::string_view text) {
  std::string result;
  while (true) {
    const std::size_t end = text.find("\\\n");
    result += text.substr(0, end);
    if (end == text.npos) return result;
    text.remove_prefix(text.find_first_not_of(' ', end + 2));
  }
}

// A string with its placeholders filled in.
std::string filled_text(std::string_view text, const Pieces& blanks) {
  std::string result;
  while (!text.empty()) {
    const auto blank = std::ranges::find(text, '@');
    result.append(text.begin(), blank);
    if (blank == text.end()) break;
    const auto end = std::find_if_not(blank + 1, text.end(), is_of_name);
    const std::string& piece = find_blank({blank + 1, end}, blanks).text;
    double number = 0;
    const char* const last = piece.data() + piece.size();
    const bool is_number = std::from_chars(piece.data(), last, number).ptr == last;
    result += is_number ? number_text(number) : piece;
    text = {end, text.end()};
  }
  return result;
}

bool is_blank(std::string_view text) {
  return text.size() > 1 && text[0] == '@' && std::ranges::all_of(text.substr(1), is_of_name);
}

JsonPiece filled(const JsonNode& node, const Pieces& blanks);

Pieces filled_children(const JsonNode& node, const Pieces& blanks) {
  Pieces children;
  for (const JsonNode& child : node.children) {
    if (!is_blank(child.name)) {
      children.push_back(named(child.name, filled(child, blanks)));
      continue;
    }
    const Pieces& members = find_blank(child.name.substr(1), blanks).children;
    children.insert(children.end(), members.begin(), members.end());
  }
  return children;
}

JsonPiece filled(const JsonNode& node, const Pieces& blanks) {
  switch (node.kind) {
    case JsonKind::null:
      return json_scalar("null");
    case JsonKind::boolean:
      return json_scalar(node.truth ? "true" : "false");
    case JsonKind::number:
      return json_scalar(node.text);
    case JsonKind::string:
      if (is_blank(node.text)) return find_blank(std::string_view(node.text).substr(1), blanks);
      return json_string(filled_text(node.text, blanks));
    case JsonKind::array:
      return json_array(filled_children(node, blanks));
    case JsonKind::object:
      return json_object(filled_children(node, blanks));
  }
  return json_scalar("null");
}

}  // namespace

Pieces schema_pieces(std::string_view text, const Pieces& blanks) {
  const JsonDocument document = parse_json(joined(text), "a schema");
  if (!document.root || !document.diagnostics.empty() || document.root->kind != JsonKind::object)
    throw std::logic_error(fmt::format("a part of a schema is no object: {}", text));
  return filled_children(*document.root, blanks);
}

std::string number_text(double value) {
  int exponent = 0;
  const bool is_power = std::fabs(std::frexp(value, &exponent)) == 0.5;
  if (is_power && std::abs(exponent - 1) >= 20)
    return fmt::format("{}2^{}", value < 0 ? "-" : "", exponent - 1);
  return schema_number(value).text;
}

JsonPiece schema_number(double value) {
  if (value == std::floor(value)) return json_scalar(fmt::format("{:.0f}", value));
  return json_scalar(fmt::format("{}", value));
}

}  // namespace edgecase
