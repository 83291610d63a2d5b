// SPDX-License-Identifier: MIT
#include "results/hex.h"

#include <fmt/format.h>

#include <stdexcept>

namespace edgecase {
namespace {

char digit_of(std::uint8_t value) {
  return static_cast<char>(value + (value < 10 ? '0' : 'a' - 10));
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  throw std::runtime_error(fmt::format("'{}' is no lower-case hexadecimal digit", c));
}

}  // namespace

void append_hex(const std::vector<std::uint8_t>& bytes, std::string& text) {
  const std::size_t before = text.size();
  text.resize(before + 2 * bytes.size());
  char* at = text.data() + before;
  // Without a table, so that the compiler makes many digits at once.
  for (const std::uint8_t byte : bytes) {
    *at++ = digit_of(byte >> 4);
    *at++ = digit_of(byte & 15);
  }
}

std::string to_hex(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  append_hex(bytes, text);
  return text;
}

std::vector<std::uint8_t> from_hex(const std::string& text) {
  if (text.size() % 2 != 0) throw std::runtime_error("pixels have an odd number of digits");
  std::vector<std::uint8_t> bytes(text.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(16 * hex_digit(text[2 * i]) + hex_digit(text[2 * i + 1]));
  return bytes;
}

}  // namespace edgecase
