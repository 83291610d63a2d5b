// SPDX-License-Identifier: MIT
//
// FNV-1a of 64 bits (Fowler, Noll, Vo): a hash by which texts can be compared without keeping them.
// It guards against mistakes, not against attacks.
#pragma once

#include <cstdint>
#include <string_view>

namespace edgecase {

inline constexpr std::uint64_t kFnvStart = 0xcbf29ce484222325u;  // the hash of nothing

// The hash with one value more: a byte as the definition has it, or a whole word as one.
constexpr std::uint64_t fnv_step(std::uint64_t hash, std::uint64_t value) {
  return (hash ^ value) * 0x100000001b3u;
}

// The hash of a text's bytes. `before` is the hash of what comes before them.
constexpr std::uint64_t fnv_of(std::string_view text, std::uint64_t before = kFnvStart) {
  for (const char c : text) before = fnv_step(before, static_cast<unsigned char>(c));
  return before;
}

}  // namespace edgecase
