// SPDX-License-Identifier: MIT
#include "reference/rendering_doubt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "reference/multisample_doubt.h"
#include "reference/vertex_data.h"

namespace edgecase {

namespace {

// Finds more hits than fragments, which are `captured` by pixel.
std::string doubt_of_hits(const Rendering& rendering, const std::vector<std::uint32_t>& captured) {
  const auto found = std::mismatch(rendering.hits.begin(), rendering.hits.end(), captured.begin(),
                                   [](auto hits, auto fragments) { return hits <= fragments; });
  if (found.first == rendering.hits.end()) return "";
  const auto index = found.first - rendering.hits.begin();
  return fmt::format("pixel ({}, {}) has {} hits, and {} fragments", index % rendering.width,
                     index / rendering.width, *found.first, *found.second);
}

// With pixels there are values of the other buffers, unless these could not be read.
std::string doubt_of_buffers(const Target& target, const Rendering& rendering) {
  if (target.depth != DepthFormat::none &&
      rendering.depths.size() * 4 != rendering.sample_pixels.size())
    return fmt::format("a sample's depth is none that {} holds", name_of(target.depth));
  if (target.stencil != StencilFormat::none &&
      rendering.stencils.size() * 4 != rendering.sample_pixels.size())
    return fmt::format("a sample's stencil is none that {} holds", name_of(target.stencil));
  return "";
}

}  // namespace

bool has_pixel_of_more(const Rendering& rendering, std::uint32_t most) {
  if (rendering.fragments.size() <= most) return false;
  std::vector<std::uint32_t> counts(rendering.pixel_index(0, rendering.height));
  return std::ranges::any_of(rendering.fragments, [&](const Fragment& fragment) {
    return ++counts[rendering.pixel_index(fragment.x, fragment.y)] > most;
  });
}

std::string doubt_of(const Scene& scene, const Rendering& rendering, std::uint32_t most_hits) {
  std::vector<std::uint32_t> counts(static_cast<std::size_t>(rendering.width) *
                                    static_cast<std::size_t>(rendering.height));
  for (const Fragment& fragment : rendering.fragments) {
    if (fragment.primitive == kNoPrimitive)
      return fmt::format(
          "the fragment at pixel ({}, {}) has the flat attributes of a vertex that provokes no "
          "primitive",
          fragment.x, fragment.y);
    if (++counts[rendering.pixel_index(fragment.x, fragment.y)] > most_hits)
      return fmt::format("pixel ({}, {}) has more hits than the {} that this surface can count",
                         fragment.x, fragment.y, most_hits);
  }
  if (rendering.samples == 1)
    return has_fragment_operations(scene) ? doubt_of_hits(rendering, counts) : "";
  if (std::string doubt = doubt_of_buffers(scene.target, rendering); !doubt.empty()) return doubt;
  return doubt_of_samples(scene, rendering);
}

}  // namespace edgecase
