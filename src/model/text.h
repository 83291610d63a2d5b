// SPDX-License-Identifier: MIT
//
// Short texts: counts with their nouns, and digests of other texts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace edgecase {

// Numbers with their nouns, as text for people.

// Digits in groups of three: "30,718".
inline std::string grouped(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, 1, ',');
  return text;
}

// "1 case", "30,718 cases".
inline std::string counted(std::size_t count, const char* one, const char* several) {
  return grouped(count) + " " + (count == 1 ? one : several);
}

// A digest by which texts can be compared without keeping them: FNV-1a of 64 bits. It guards
// against mistakes, not against attacks.

class Digest {
 public:
  // Adds a text. The boundary between texts matters.
  Digest& add(std::string_view text) {
    for (const char c : text) step(static_cast<unsigned char>(c));
    for (std::size_t size = text.size(), i = 0; i < sizeof size; ++i, size >>= 8) step(size & 0xff);
    return *this;
  }

  std::uint64_t number() const { return hash_; }
  // The number as 16 hexadecimal digits.
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
