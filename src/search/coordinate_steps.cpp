// SPDX-License-Identifier: MIT
#include "search/coordinate_steps.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>

#include "search/scene_size.h"

namespace edgecase {
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

}  // namespace edgecase
