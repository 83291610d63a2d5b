// SPDX-License-Identifier: MIT
#include "results/json_writer.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace edgecase {
namespace {

using ErrorHandler = nlohmann::json::error_handler_t;

// True if the text needs no escapes, as nearly all texts. No branch leaves the loop, so that the
// compiler tests many characters at once.
bool is_plain(std::string_view text) {
  unsigned char others = 0;
  for (const char c : text)
    others |= static_cast<unsigned char>(c < ' ' || c > '~' || c == '"' || c == '\\');
  return others == 0;
}

}  // namespace

JsonWriter& JsonWriter::key(std::string_view name) {
  value(name);
  text_ += ':';
  needs_comma_ = false;
  return *this;
}

void JsonWriter::value(std::string_view text) {
  if (!is_plain(text))
    return literal(nlohmann::json(text).dump(-1, ' ', false, ErrorHandler::replace));
  literal("\"");
  text_ += text;
  text_ += '"';
}

// The digits are those of the JSON library, which are not always the shortest, unlike those of fmt
// and the standard library. Its public function makes a tree and a text for each number.
void JsonWriter::value(double value) {
  if (std::isnan(value)) return literal("\"nan\"");
  if (std::isinf(value)) return literal(value > 0 ? "\"inf\"" : "\"-inf\"");
  std::array<char, 64> digits;
  const char* end = nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), value);
  literal({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

}  // namespace edgecase
