// SPDX-License-Identifier: MIT
#include "profile/samples/sample_places.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "rules/samples/attribute_location.h"
#include "rules/samples/sample_mask.h"

namespace edgecase {
namespace {

constexpr double kNear = 1.0 / 64;  // pixels

struct Place {
  double x = 0;
  double y = 0;
};

Place in_pixels(Point point) {
  return {point.x.to_double(), point.y.to_double()};
}

bool is_near(Place a, Place b) {
  return std::abs(a.x - b.x) < kNear && std::abs(a.y - b.y) < kNear;
}

// Within the pixel, by the planes of the colours.
Place told_place(const Fragment& fragment) {
  return {kPlainSize * fragment.color[0] - fragment.x, kPlainSize * fragment.color[1] - fragment.y};
}

Place mean_of(const SamplePositions& positions, std::uint32_t mask) {
  Place sum;
  for (std::size_t s = 0; s < positions.size(); ++s) {
    if ((mask >> s & 1) == 0) continue;
    sum.x += positions[s].x.to_double() / std::popcount(mask);
    sum.y += positions[s].y.to_double() / std::popcount(mask);
  }
  return sum;
}

// `mask`: what the primitive covers of the pixel, more than one sample.
const char* name_of_place(const Fragment& fragment, std::uint32_t mask,
                          const SamplePositions& positions) {
  const Place place = told_place(fragment);
  const auto sample = [&](std::uint32_t of) {
    return in_pixels(positions[static_cast<std::size_t>(std::countr_zero(of))]);
  };
  if (std::has_single_bit(fragment.coverage) && is_near(place, sample(fragment.coverage)))
    return kOwnSample;
  if (is_near(place, in_pixels(centre_of_pixel()))) return "centre";
  if (is_near(place, sample(mask))) return "first covered sample";
  if (is_near(place, mean_of(positions, mask))) return "mean of the covered samples";
  return "elsewhere";
}

}  // namespace

InvocationRow empty_row(const InvocationsAsked& asked, int samples) {
  InvocationRow row;
  row.asked = asked.name;
  row.location = name_of(asked.use.location);
  row.at_sample = is_at_sample(asked.use);
  row.least = least_invocations(asked.use, samples);
  return row;
}

bool InvocationRow::is_violation() const {
  const auto is_elsewhere = [](const auto& place) { return place.first != kOwnSample; };
  return at_sample && (std::any_of(whole.begin(), whole.end(), is_elsewhere) ||
                       std::any_of(partial.begin(), partial.end(), is_elsewhere));
}

void add_invocations(const Rendering& rendering, InvocationRow& row) {
  const auto& fragments = rendering.fragments;
  if (rendering.sample_positions.size() != static_cast<std::size_t>(rendering.samples)) return;
  for (std::size_t first = 0; first < fragments.size();) {
    std::size_t end = first;
    std::uint32_t mask = 0;
    while (end < fragments.size() && fragments[end].x == fragments[first].x &&
           fragments[end].y == fragments[first].y)
      mask |= fragments[end++].coverage;
    const int covered = std::popcount(mask);
    ++row.invocations[covered][static_cast<int>(end - first)];
    auto& places = mask == mask_of_all(rendering.samples) ? row.whole : row.partial;
    // One sample is the first, the mean and its own.
    for (std::size_t i = first; i < end && covered > 1; ++i)
      ++places[name_of_place(fragments[i], mask, rendering.sample_positions)];
    first = end;
  }
}

}  // namespace edgecase
