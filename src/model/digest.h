// SPDX-License-Identifier: MIT
//
// A digest by which texts can be compared without keeping them: FNV-1a of 64 bits. It guards
// against mistakes, not against attacks.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace edgecase {

class Digest {
 public:
  // Adds a text. The boundary between texts matters.
  Digest& add(std::string_view text) {
    for (const char c : text) step(static_cast<unsigned char>(c));
    for (std::size_t size = text.size(), i = 0; i < sizeof size; ++i, size >>= 8) step(size & 0xff);
    return *this;
  }

  // 16 hexadecimal digits.
  std::string text() const {
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[hash_ >> shift & 0xf];
    return digits;
  }

 private:
  void step(std::uint64_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3u; }

  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

inline std::string digest_of_text(std::string_view text) {
  return Digest().add(text).text();
}

}  // namespace edgecase
