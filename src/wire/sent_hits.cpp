// SPDX-License-Identifier: MIT
#include "wire/sent_hits.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace edgecase::wire {
namespace {

// How many fragments each sample has; nothing where one lies outside.
std::optional<std::vector<std::uint32_t>> counted(const Rendering& rendering) {
  const std::size_t plane = rendering.pixel_index(0, rendering.height);
  std::vector<std::uint32_t> counts(plane * static_cast<std::size_t>(rendering.samples));
  for (const Fragment& fragment : rendering.fragments) {
    if (fragment.x < 0 || fragment.x >= rendering.width || fragment.y < 0 ||
        fragment.y >= rendering.height)
      return std::nullopt;
    std::size_t at = rendering.pixel_index(fragment.x, fragment.y);
    for (std::uint32_t left = fragment.coverage; left != 0; left >>= 1, at += plane) {
      if (at >= counts.size()) return std::nullopt;
      counts[at] += left & 1;
    }
  }
  return counts;
}

}  // namespace

void write_hits(Writer& io, const Rendering& rendering) {
  const auto counts = counted(rendering);
  const bool count_fragments = counts && rendering.hits == *counts;
  carry(io, count_fragments);
  if (!count_fragments) carry(io, rendering.hits);
}

bool read_hits(Reader& io, Rendering& rendering) {
  bool count_fragments = false;
  carry(io, count_fragments);
  if (!count_fragments) {
    carry(io, rendering.hits);
    return false;
  }
  auto counts = counted(rendering);
  if (!counts) throw Refusal("a fragment is outside the target");
  rendering.hits = *std::move(counts);
  return true;
}

}  // namespace edgecase::wire
