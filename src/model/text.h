// SPDX-License-Identifier: MIT
//
// Short texts: counts with their nouns, and digests of other texts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "model/fnv.h"

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

// A hash of texts (model/fnv.h). The boundaries between them matter.
class Digest {
 public:
  Digest& add(std::string_view text) {
    hash_ = fnv_of(text, hash_);
    for (std::size_t size = text.size(), i = 0; i < sizeof size; ++i, size >>= 8)
      hash_ = fnv_step(hash_, size & 0xff);
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
  std::uint64_t hash_ = kFnvStart;
};

inline std::string digest_of_text(std::string_view text) {
  return Digest().add(text).text();
}

}  // namespace edgecase
