// SPDX-License-Identifier: MIT
#include "suite/expectation_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <optional>

namespace edgecase {

std::string draw_hits(const std::vector<int>& hits, int width, int height) {
  std::string drawing;
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      const int count = hits[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(x)];
      drawing += count == 0   ? '.'
                 : count == 1 ? '#'
                 : count > 9  ? '+'
                              : static_cast<char>('0' + count);
    }
    drawing += '\n';
  }
  return drawing;
}

std::vector<int> hits_of(const Rendering& rendering) {
  std::vector<int> hits(static_cast<std::size_t>(rendering.width) *
                        static_cast<std::size_t>(rendering.height));
  const auto add = [&](const Rendering& drawn) {
    const std::size_t area = hits.size();
    for (std::size_t i = 0; i < drawn.hits.size(); ++i)
      hits[i % area] += static_cast<int>(drawn.hits[i]);
  };
  add(rendering);
  for (const Rendering& pass : rendering.passes) add(pass);
  return hits;
}

PixelMasks masks_of(const Rendering& rendering) {
  const std::size_t area =
      static_cast<std::size_t>(rendering.width) * static_cast<std::size_t>(rendering.height);
  PixelMasks masks{std::vector<std::uint32_t>(area), std::vector<std::uint32_t>(area)};
  for (const Fragment& f : rendering.fragments) {
    const std::size_t pixel = rendering.pixel_index(f.x, f.y);
    masks.doubly[pixel] |= masks.covered[pixel] & f.coverage;
    masks.covered[pixel] |= f.coverage;
  }
  return masks;
}

std::string draw_masks(const std::vector<std::uint32_t>& masks, int width, int height) {
  const std::uint32_t largest = masks.empty() ? 0 : std::ranges::max(masks);
  const std::size_t cell = fmt::formatted_size("{:x}", largest);
  std::string drawing;
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t mask =
          masks[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)];
      drawing += fmt::format("{}{:>{}}", x == 0 ? "" : " ",
                             mask == 0 ? std::string(".") : fmt::format("{:x}", mask), cell);
    }
    drawing += '\n';
  }
  return drawing;
}

namespace {

// How a drawing of hits differs from exact; nothing if it does not.
std::optional<std::string> fault_of_coverage(const std::vector<int>& drawing,
                                             const Rendering& exact) {
  const std::vector<int> hits = hits_of(exact);
  const auto [drawn, real] = std::mismatch(drawing.begin(), drawing.end(), hits.begin());
  if (drawn == drawing.end()) return std::nullopt;
  const auto index = drawn - drawing.begin();
  return fmt::format("the drawing has {} at pixel ({}, {}), exact has {}; exact draws\n{}", *drawn,
                     index % exact.width, index / exact.width, *real,
                     draw_hits(hits, exact.width, exact.height));
}

// The same for a drawing of masks. It shows one primitive, which covers no sample twice.
std::optional<std::string> fault_of_masks(const std::vector<std::uint32_t>& drawing,
                                          const Rendering& exact) {
  const PixelMasks masks = masks_of(exact);
  for (std::size_t i = 0; i < drawing.size(); ++i) {
    const std::string pixel =
        fmt::format("pixel ({}, {})", i % static_cast<std::size_t>(exact.width),
                    i / static_cast<std::size_t>(exact.width));
    if (masks.doubly[i] != 0)
      return fmt::format("exact covers samples {:x} of {} twice", masks.doubly[i], pixel);
    if (drawing[i] != masks.covered[i])
      return fmt::format("the drawing has {:x} at {}, exact has {:x}; exact draws\n{}", drawing[i],
                         pixel, masks.covered[i],
                         draw_masks(masks.covered, exact.width, exact.height));
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> unmet_drawings(const Case& one, const std::string& policy,
                                        const Rendering& exact) {
  std::vector<std::string> unmet;
  for (const Expect& expect : one.expect) {
    if (expect.policy != policy) continue;
    const auto fault = expect.masks.empty() ? fault_of_coverage(expect.coverage, exact)
                                            : fault_of_masks(expect.masks, exact);
    if (fault)
      unmet.push_back(fmt::format("{}: under policy {}, {}", expect.where, policy, *fault));
  }
  return unmet;
}

}  // namespace edgecase
