// SPDX-License-Identifier: MIT
#include "run/expectation_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

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
  for (const Fragment& f : rendering.fragments) ++hits[rendering.pixel_index(f.x, f.y)];
  return hits;
}

std::vector<std::string> unmet_drawings(const Case& one, const std::string& policy,
                                        const Rendering& exact) {
  std::vector<std::string> unmet;
  const std::vector<int> hits = hits_of(exact);
  for (const Expect& expect : one.expect) {
    if (expect.policy != policy || expect.coverage.empty()) continue;
    const auto [drawn, real] =
        std::mismatch(expect.coverage.begin(), expect.coverage.end(), hits.begin());
    if (drawn == expect.coverage.end()) continue;
    const auto index = drawn - expect.coverage.begin();
    unmet.push_back(fmt::format(
        "{}: the drawing has {} at pixel ({}, {}), exact has {} under policy {}; exact draws\n{}",
        expect.where, *drawn, index % exact.width, index / exact.width, *real, policy,
        draw_hits(hits, exact.width, exact.height)));
  }
  return unmet;
}

}  // namespace edgecase
