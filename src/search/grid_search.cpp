// SPDX-License-Identifier: MIT
#include "search/grid_search.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "model/scene.h"
#include "search/coordinate_steps.h"
#include "search/scene_size.h"

namespace edgecase {
namespace {

// The limit of combinations per grid: all of six coordinates with four choices each.
constexpr std::size_t kMostCombinations = 4096;
constexpr std::size_t kChunk = 256;

// For each coordinate of each point, x before y, the candidate positions, nearest first.
using PlacesOf = std::vector<std::vector<Fixed>>;

PlacesOf places_on_grid(const std::vector<Point>& points, int bits) {
  PlacesOf choices;
  for (const Point point : points) {
    choices.push_back(neighbours_on_grid(point.x, bits));
    choices.push_back(neighbours_on_grid(point.y, bits));
  }
  return choices;
}

// The same with one more position on either side.
PlacesOf widened(PlacesOf choices, int bits) {
  const Fixed step = Fixed::from_raw(Fixed::kOne >> bits);
  for (std::vector<Fixed>& places : choices) {
    const auto [least, most] = std::ranges::minmax(places);
    // Nearer positions come first.
    if (places.front() == least) {
      places.push_back(least - step);
      places.push_back(most + step);
    } else {
      places.push_back(most + step);
      places.push_back(least - step);
    }
  }
  return choices;
}

// Combinations as indices into the choices, those with the smallest sum of indices first.
std::vector<std::vector<std::size_t>> combinations(const PlacesOf& choices) {
  std::size_t largest_sum = 0;
  for (const auto& places : choices) largest_sum += places.size() - 1;
  std::vector<std::vector<std::size_t>> found;
  std::vector<std::size_t> indices(choices.size());
  const auto descend = [&](const auto& self, std::size_t at, std::size_t sum) -> void {
    if (found.size() >= kMostCombinations) return;
    if (at == choices.size()) {
      if (sum == 0) found.push_back(indices);
      return;
    }
    for (std::size_t i = 0; i < choices[at].size() && i <= sum; ++i) {
      indices[at] = i;
      self(self, at + 1, sum - i);
    }
  };
  for (std::size_t sum = 0; sum <= largest_sum; ++sum) descend(descend, 0, sum);
  return found;
}

bool search_choices(Shrinking& shrinking, const std::vector<Point>& points,
                    const PlacesOf& choices) {
  const Scene scene = shrinking.scene();
  std::vector<Scene> candidates;
  const auto all = combinations(choices);
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<Point> places;
    for (std::size_t p = 0; p < points.size(); ++p)
      places.push_back({choices[2 * p][all[i][2 * p]], choices[2 * p + 1][all[i][2 * p + 1]]});
    candidates.push_back(with_points(scene, points, places));
    if (candidates.size() < kChunk && i + 1 < all.size()) continue;
    if (shrinking.offer_first_of(std::exchange(candidates, {}))) return true;
  }
  return false;
}

// A number in [0, count); the standard's distributions differ between libraries.
std::int64_t below(std::mt19937_64& engine, std::int64_t count) {
  return static_cast<std::int64_t>(engine() % static_cast<std::uint64_t>(count));
}

Fixed on_readable_grid(std::int64_t steps) {
  return Fixed::from_raw(steps * (Fixed::kOne >> kReadableBits));
}

// A position on the grid within a pixel of the value.
Fixed near(std::mt19937_64& engine, Fixed value) {
  const std::int64_t reach = std::int64_t{1} << kReadableBits;
  const Fixed rounded = neighbours_on_grid(value, kReadableBits).front();
  return rounded + on_readable_grid(below(engine, 2 * reach + 1) - reach);
}

// Any position on a target of `size` pixels.
Fixed anywhere(std::mt19937_64& engine, int size) {
  return on_readable_grid(below(engine, (std::int64_t{size} << kReadableBits) + 1));
}

}  // namespace

bool search_neighbours(Shrinking& shrinking) {
  const std::vector<Point> points = points_of(shrinking.scene());
  if (points.empty() || points.size() > kMostGridPoints) return false;
  const int present = fraction_bits_of(shrinking.scene());
  for (int bits = 0; bits < present; ++bits) {
    const PlacesOf choices = places_on_grid(points, bits);
    if (search_choices(shrinking, points, choices)) return true;
    if (bits != kReadableBits) continue;
    if (search_choices(shrinking, points, widened(choices, bits))) return true;
  }
  return false;
}

bool search_afar(Shrinking& shrinking, std::size_t most) {
  const std::vector<Point> points = points_of(shrinking.scene());
  if (points.empty() || points.size() > kMostGridPoints) return false;
  std::mt19937_64 engine(1);
  const Scene scene = shrinking.scene();
  std::vector<Scene> candidates;
  for (std::size_t i = 0; i < most; ++i) {
    std::vector<Point> places;
    for (const Point point : points)
      places.push_back(i % 2 == 0 ? Point{near(engine, point.x), near(engine, point.y)}
                                  : Point{anywhere(engine, scene.target.width),
                                          anywhere(engine, scene.target.height)});
    candidates.push_back(with_points(scene, points, places));
    if (candidates.size() < kChunk && i + 1 < most) continue;
    if (shrinking.offer_first_of(std::exchange(candidates, {}))) return true;
  }
  return false;
}

}  // namespace edgecase
