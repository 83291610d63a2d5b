// SPDX-License-Identifier: MIT
#include "reference/multisample_doubt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgecase {

namespace {

std::uint32_t all_of(int samples) {
  return (std::uint32_t{1} << samples) - 1;
}

// Whether every covered sample is written.
bool writes_what_it_covers(const Draw& draw, int samples) {
  const Multisampling& use = draw.multisampling;
  return use.enabled && !use.alpha_to_coverage && (use.mask & all_of(samples)) == all_of(samples);
}

// The number of fragments that cover each sample.
std::vector<std::uint32_t> covering(const Rendering& rendering) {
  std::vector<std::uint32_t> counts(rendering.hits.size());
  for (const Fragment& fragment : rendering.fragments)
    for (int sample = 0; sample < rendering.samples; ++sample)
      counts[rendering.sample_index(fragment.x, fragment.y, sample)] +=
          (fragment.coverage >> sample) & 1;
  return counts;
}

}  // namespace

std::string doubt_of_samples(const Scene& scene, const Rendering& rendering) {
  const int samples = rendering.samples;
  for (const Fragment& fragment : rendering.fragments)
    if (fragment.coverage == 0 || fragment.coverage > all_of(samples))
      return fmt::format("the fragment at pixel ({}, {}) covers {} of {} samples", fragment.x,
                         fragment.y, fragment.coverage == 0 ? "none" : "more than all", samples);
  if (!std::all_of(scene.draws.begin(), scene.draws.end(),
                   [&](const Draw& draw) { return writes_what_it_covers(draw, samples); }))
    return "";
  const std::vector<std::uint32_t> counts = covering(rendering);
  const bool may_fail = has_fragment_operations(scene);
  const auto agree = [&](std::uint32_t fragments, std::uint32_t hits) {
    return may_fail ? hits <= fragments : hits == fragments;
  };
  const auto found = std::mismatch(counts.begin(), counts.end(), rendering.hits.begin(), agree);
  if (found.first == counts.end()) return "";
  const auto index = static_cast<std::size_t>(found.first - counts.begin());
  const auto area =
      static_cast<std::size_t>(rendering.width) * static_cast<std::size_t>(rendering.height);
  const auto width = static_cast<std::size_t>(rendering.width);
  return fmt::format("sample {} of pixel ({}, {}) has {} hits, and {} fragments that cover it",
                     index / area, index % area % width, index % area / width, *found.second,
                     *found.first);
}

}  // namespace edgecase
