// SPDX-License-Identifier: MIT
#include "model/rendering.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace edgecase {

namespace {

// Whether there are enough fragments to count them by pixel, and all lie within the target.
bool can_distribute(const Rendering& rendering) {
  const std::size_t pixels = rendering.pixel_index(0, rendering.height);
  return pixels <= 16 * rendering.fragments.size() &&
         std::all_of(
             rendering.fragments.begin(), rendering.fragments.end(), [&](const Fragment& f) {
               return f.x >= 0 && f.x < rendering.width && f.y >= 0 && f.y < rendering.height;
             });
}

using Places = std::vector<std::vector<Fragment>::iterator>;

// The starts of a list's sorted runs, and its end; cut short after more than `most` runs.
Places runs_of(std::vector<Fragment>& fragments, std::size_t most) {
  Places places{fragments.begin()};
  while (places.size() <= most && places.back() != fragments.end())
    places.push_back(std::is_sorted_until(places.back(), fragments.end(), precedes));
  return places;
}

// Merges from the end: a large primitive followed by smaller ones is passed over only once.
void merge_runs(const Places& places) {
  for (std::size_t i = places.size() - 2; i > 0; --i)
    std::inplace_merge(places[i - 1], places[i], places.back(), precedes);
}

}  // namespace

bool precedes(const Fragment& a, const Fragment& b) {
  if (a.y != b.y) return a.y < b.y;
  if (a.x != b.x) return a.x < b.x;
  return std::tie(a.primitive, a.coverage) < std::tie(b.primitive, b.coverage);
}

void sort_fragments(Rendering& rendering) {
  constexpr std::size_t kFewRuns = 8;
  std::vector<Fragment>& fragments = rendering.fragments;
  const auto are_sorted = [&] {
    return std::is_sorted(fragments.begin(), fragments.end(), precedes);
  };
  // Most lists are sorted already, or by primitive, and a check is much cheaper than a sort.
  if (are_sorted()) return;
  const Places places = runs_of(fragments, kFewRuns);
  if (places.back() == fragments.end()) return merge_runs(places);
  if (can_distribute(rendering))
    distribute(fragments, rendering.pixel_index(0, rendering.height),
               [&](const Fragment& f) { return rendering.pixel_index(f.x, f.y); });
  if (!are_sorted()) std::stable_sort(fragments.begin(), fragments.end(), precedes);
}

std::uint8_t to_unorm8(double component) {
  if (!(component > 0)) return 0;
  if (component >= 1) return 255;
  // At this size the last bit of a double is worth 1, so adding rounds to the nearest even integer.
  constexpr double kIntegers = 0x1p52;
  return static_cast<std::uint8_t>(component * 255 + kIntegers - kIntegers);
}

}  // namespace edgecase
