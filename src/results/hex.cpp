// SPDX-License-Identifier: MIT
#include "results/hex.h"

#include <fmt/format.h>

#include <stdexcept>

namespace edgecase {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  throw std::runtime_error(fmt::format("'{}' is no lower-case hexadecimal digit", c));
}

}  // namespace

std::string to_hex(const std::vector<std::uint8_t>& bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text(2 * bytes.size(), '0');
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    text[2 * i] = kDigits[bytes[i] >> 4];
    text[2 * i + 1] = kDigits[bytes[i] & 15];
  }
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
