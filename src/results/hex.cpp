// SPDX-License-Identifier: MIT
#include "results/hex.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace edgecase {
namespace {

// The two digits of each byte.
constexpr auto kDigitsOfBytes = [] {
  constexpr char kDigits[] = "0123456789abcdef";
  std::array<std::array<char, 2>, 256> digits{};
  for (std::size_t byte = 0; byte < digits.size(); ++byte)
    digits[byte] = {kDigits[byte >> 4], kDigits[byte & 15]};
  return digits;
}();

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
  for (const std::uint8_t byte : bytes) at = std::copy_n(kDigitsOfBytes[byte].begin(), 2, at);
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
