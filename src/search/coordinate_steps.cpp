// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "search/minimize.h"

namespace edgecase {

// ------------------------------------------------------------------------------------- coordinates

namespace {

constexpr std::array kAxes{&Point::x, &Point::y};

std::int64_t raw_step(int bits) {
  return Fixed::kOne >> bits;
}

Fixed round_down(Fixed value, int bits) {
  return Fixed::from_raw(value.raw() & -raw_step(bits));
}

int bits_of(Point point) {
  return std::max(fraction_bits_of(point.x), fraction_bits_of(point.y));
}

// The scene with each point moved to `place_of(point)`.
template <class PlaceOf>
Scene with_each(const Scene& scene, const PlaceOf& place_of) {
  const std::vector<Point> points = points_of(scene);
  std::vector<Point> places;
  for (const Point point : points) places.push_back(place_of(point));
  return with_points(scene, points, places);
}

Scene with_one(const Scene& scene, Point point, Point place) {
  return with_points(scene, {point}, {place});
}

// The distinct values along an axis, ascending.
std::vector<Fixed> values_of(const Scene& scene, Fixed Point::*axis) {
  std::set<Fixed> values;
  for (const Point point : points_of(scene)) values.insert(point.*axis);
  return {values.begin(), values.end()};
}

// Moves all points whose coordinate along the axis is `from` to `to`.
Scene with_value(const Scene& scene, Fixed Point::*axis, Fixed from, Fixed to) {
  return with_each(scene, [&](Point point) {
    if (point.*axis == from) point.*axis = to;
    return point;
  });
}

std::vector<Scene> rounded_points(const Scene& scene, Point point, int bits) {
  std::vector<Scene> candidates;
  for (const Fixed x : neighbours_on_grid(point.x, bits))
    for (const Fixed y : neighbours_on_grid(point.y, bits))
      candidates.push_back(with_one(scene, point, {x, y}));
  return candidates;
}

bool round_point(Shrinking& shrinking, Point point) {
  for (int bits = 0; bits < bits_of(point); ++bits)
    if (shrinking.offer_first_of(rounded_points(shrinking.scene(), point, bits))) return true;
  return false;
}

bool round_value(Shrinking& shrinking, Fixed Point::*axis, Fixed value) {
  for (int bits = 0; bits < fraction_bits_of(value); ++bits)
    for (const Fixed rounder : neighbours_on_grid(value, bits))
      if (shrinking.offer(with_value(shrinking.scene(), axis, value, rounder))) return true;
  return false;
}

bool round_coordinate(Shrinking& shrinking, Fixed Point::*axis, Point point) {
  for (int bits = 0; bits < fraction_bits_of(point.*axis); ++bits)
    for (const Fixed rounder : neighbours_on_grid(point.*axis, bits)) {
      Point place = point;
      place.*axis = rounder;
      if (shrinking.offer(with_one(shrinking.scene(), point, place))) return true;
    }
  return false;
}

// Moves by whole pixels, powers of two, towards 0; `moved(distance)` makes the candidate.
template <class Moved>
bool move_by_pixels(Shrinking& shrinking, Fixed value, const Moved& moved) {
  const Fixed size = value < Fixed() ? -value : value;
  for (int pixels = 1 << 12; pixels >= 1; pixels /= 2) {
    if (Fixed::from_integer(pixels) > size + Fixed::from_integer(1)) continue;
    const Fixed distance = Fixed::from_integer(value < Fixed() ? pixels : -pixels);
    if (shrinking.offer(moved(distance))) return true;
  }
  return false;
}

bool move_value(Shrinking& shrinking, Fixed Point::*axis, Fixed value) {
  return move_by_pixels(shrinking, value, [&](Fixed distance) {
    return with_value(shrinking.scene(), axis, value, value + distance);
  });
}

// Moves everything from this value on, away from the origin, so that the gap before it closes.
bool close_gap(Shrinking& shrinking, Fixed Point::*axis, Fixed value) {
  return move_by_pixels(shrinking, value, [&](Fixed distance) {
    return with_each(shrinking.scene(), [&](Point point) {
      const bool beyond = value < Fixed() ? point.*axis <= value : point.*axis >= value;
      if (beyond) point.*axis = point.*axis + distance;
      return point;
    });
  });
}

bool move_point(Shrinking& shrinking, Fixed Point::*axis, Point point) {
  return move_by_pixels(shrinking, point.*axis, [&](Fixed distance) {
    Point place = point;
    place.*axis = place.*axis + distance;
    return with_one(shrinking.scene(), point, place);
  });
}

// Repeats the step on the current scene until nothing changes any more.
template <class Step>
bool until_nothing_helps(const Step& step) {
  bool any = false;
  while (step()) any = true;
  return any;
}

}  // namespace

std::vector<Point> points_of(const Scene& scene) {
  std::vector<Point> points;
  for (const Draw& draw : scene.draws)
    for (const Vertex& vertex : draw.vertices)
      if (!vertex.clip && std::ranges::find(points, vertex.position) == points.end())
        points.push_back(vertex.position);
  return points;
}

Scene with_points(const Scene& scene, const std::vector<Point>& points,
                  const std::vector<Point>& places) {
  Scene result = scene;
  for (Draw& draw : result.draws)
    for (Vertex& vertex : draw.vertices) {
      if (vertex.clip) continue;
      const auto found = std::ranges::find(points, vertex.position);
      if (found != points.end())
        vertex.position = places[static_cast<std::size_t>(found - points.begin())];
    }
  return result;
}

std::vector<Fixed> neighbours_on_grid(Fixed value, int bits) {
  const Fixed down = round_down(value, bits);
  if (down == value) return {value};
  const Fixed up = Fixed::from_raw(down.raw() + raw_step(bits));
  if (value - down <= up - value) return {down, up};
  return {up, down};
}

bool round_all(Shrinking& shrinking) {
  const int most = fraction_bits_of(shrinking.scene());
  for (int bits = 0; bits < most; ++bits) {
    std::vector<Scene> candidates;
    const auto add = [&](const auto& round) {
      candidates.push_back(with_each(shrinking.scene(), [&](Point point) {
        return Point{round(point.x), round(point.y)};
      }));
    };
    add([&](Fixed value) { return neighbours_on_grid(value, bits).front(); });
    add([&](Fixed value) { return round_down(value, bits); });
    add([&](Fixed value) { return -round_down(-value, bits); });
    if (shrinking.offer_first_of(std::move(candidates))) return true;
  }
  return false;
}

bool round_each(Shrinking& shrinking) {
  bool any = false;
  for (const auto axis : kAxes)
    for (const Fixed value : values_of(shrinking.scene(), axis))
      any = round_value(shrinking, axis, value) || any;
  for (const Point point : points_of(shrinking.scene())) any = round_point(shrinking, point) || any;
  for (const auto axis : kAxes)
    for (const Point point : points_of(shrinking.scene()))
      any = round_coordinate(shrinking, axis, point) || any;
  return any;
}

bool align(Shrinking& shrinking) {
  return until_nothing_helps([&] {
    std::vector<Scene> candidates;
    const Scene& scene = shrinking.scene();
    for (const Point point : points_of(scene))
      for (const auto axis : kAxes)
        for (const Fixed value : values_of(scene, axis)) {
          if (value == point.*axis) continue;
          Point place = point;
          place.*axis = value;
          candidates.push_back(with_one(scene, point, place));
        }
    return shrinking.offer_first_of(std::move(candidates));
  });
}

bool draw_in(Shrinking& shrinking) {
  return until_nothing_helps([&] {
    bool any = false;
    for (const auto axis : kAxes) {
      for (const Fixed value : values_of(shrinking.scene(), axis))
        any = close_gap(shrinking, axis, value) || any;
      for (const Fixed value : values_of(shrinking.scene(), axis))
        any = move_value(shrinking, axis, value) || any;
      for (const Point point : points_of(shrinking.scene()))
        any = move_point(shrinking, axis, point) || any;
    }
    return any;
  });
}

bool round_depths(Shrinking& shrinking) {
  std::set<Fixed> depths;
  for (const Draw& draw : shrinking.scene().draws)
    for (const Vertex& vertex : draw.vertices)
      if (!vertex.clip) depths.insert(vertex.z);
  bool any = false;
  for (const Fixed depth : depths) {
    std::vector<Scene> candidates;
    for (int bits = 0; bits < fraction_bits_of(depth); ++bits)
      for (const Fixed rounder : neighbours_on_grid(depth, bits)) {
        candidates.push_back(shrinking.scene());
        for (Draw& draw : candidates.back().draws)
          for (Vertex& vertex : draw.vertices)
            if (!vertex.clip && vertex.z == depth) vertex.z = rounder;
      }
    any = shrinking.offer_first_of(std::move(candidates)) || any;
  }
  return any;
}

// ------------------------------------------------------------------------------------- grid search

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
