// SPDX-License-Identifier: MIT
#include "casefile/salted_colors.h"

#include <algorithm>
#include <cstddef>

namespace edgecase {
namespace {

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): a bijection of 64-bit words in which each
// bit of the input flips half of the output's bits.
std::uint64_t mix(std::uint64_t word) {
  word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9U;
  word = (word ^ (word >> 27)) * 0x94D049BB133111EBU;
  return word ^ (word >> 31);
}

// The float32 nearest to level / 255.
float component(std::uint64_t level) {
  return static_cast<float>(level) / 255.0F;
}

// Value of a channel at a hue, 0 to 255; hues are in 1/2^32 of a turn. Full within a sixth of a
// turn of the channel's own hue `centre`, falling linearly to nothing over the next sixth.
std::uint64_t channel(std::uint32_t hue, std::uint32_t centre) {
  constexpr std::uint64_t kSixth = (std::uint64_t{1} << 32) / 6;
  const std::uint32_t forward = hue - centre;
  const std::uint64_t away = std::min(forward, std::uint32_t{0} - forward);
  if (away <= kSixth) return 255;
  if (away >= 2 * kSixth) return 0;
  return (2 * kSixth - away) * 255 / kSixth;
}

constexpr std::uint64_t kGoldenTurn = 0x9E3779B9;  // 2^32 / golden ratio

// Are the hues of two colours, so many steps from each other, a sixth of a turn apart or more?
bool hues_differ(std::uint64_t steps) {
  constexpr std::uint32_t kSixth = 0x2AAAAAAA;  // 2^32 / 6
  const auto turn = static_cast<std::uint32_t>(steps * kGoldenTurn);
  return std::min(turn, std::uint32_t{0} - turn) >= kSixth;
}

}  // namespace

std::uint64_t hash_of_id(std::string_view id) {
  std::uint64_t hash = 0xCBF29CE484222325U;  // FNV-1a, 64 bits
  for (const char c : id) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001B3U;
  }
  return mix(hash);
}

Color salted_clear(std::uint64_t hash) {
  return {component(hash & 63), component((hash >> 6) & 63), component((hash >> 12) & 63), 1};
}

Color salted_primitive(std::uint64_t hash, std::uint64_t primitive) {
  constexpr std::uint32_t kThird = 0x55555555;  // 2^32 / 3
  const auto hue = static_cast<std::uint32_t>((hash >> 32) + primitive * kGoldenTurn);
  const std::uint64_t salt = mix(hash + primitive + 1);
  const std::uint64_t peak = 192 + (salt & 63);
  constexpr std::uint64_t kFloor = 64;  // so that no channel says nothing
  Color color{0, 0, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint64_t level =
        kFloor + channel(hue, kThird * static_cast<std::uint32_t>(i)) * (peak - kFloor) / 255;
    const std::uint64_t noise = (salt >> (8 + 3 * i)) & 7;
    color[i] = component((level & ~std::uint64_t{7}) | noise);
  }
  return color;
}

std::vector<std::uint64_t> salted_indices(Primitive primitive, std::size_t vertices) {
  const auto each = static_cast<std::size_t>(vertices_of(kind_of(primitive)));
  const bool shared = is_vertex_count(primitive, each + 1) && each > 1;
  std::vector<std::uint64_t> indices;
  indices.reserve(vertices);
  for (std::size_t i = 0; i < vertices; ++i) indices.push_back(shared ? i : i / each);
  if (primitive != Primitive::line_loop || vertices < 2) return indices;
  // A loop's last vertex stands between the one before it and the first.
  std::uint64_t& last = indices.back();
  const std::uint64_t before = indices[vertices - 2];
  while (!hues_differ(last) || !hues_differ(last - before)) ++last;
  return indices;
}

}  // namespace edgecase
