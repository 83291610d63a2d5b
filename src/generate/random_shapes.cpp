// SPDX-License-Identifier: MIT
#include "generate/random_shapes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <utility>

#include "generate/random_scenes.h"

namespace edgecase {
namespace {

// Four levels per channel give 63 distinct colours: index + 1 in base 4.
Color color_of(std::size_t index) {
  const std::size_t code = index % 63 + 1;
  const auto channel = [&](int digit) {
    return static_cast<float>((code >> (2 * digit) & 3) * 85) / 255.0f;
  };
  return {channel(0), channel(1), channel(2), 1};
}

}  // namespace

Scene empty_scene(Surface surface, int size) {
  Scene scene;
  scene.target.width = size;
  scene.target.height = size;
  scene.target.surface = surface;
  scene.viewport = {0, 0, size, size};
  return scene;
}

Scene scene_of(Surface surface, int size, Primitive primitive, std::span<const Point> positions) {
  Scene scene = empty_scene(surface, size);
  Draw& draw = scene.draws.emplace_back();
  draw.primitive = primitive;
  for (std::size_t i = 0; i < positions.size(); ++i)
    draw.vertices.push_back({positions[i], Fixed(), color_of(i)});
  return scene;
}

std::vector<Point> separate_lines(std::span<const Point> strip) {
  std::vector<Point> pairs;
  for (std::size_t i = 1; i < strip.size(); ++i) {
    pairs.push_back(strip[i - 1]);
    pairs.push_back(strip[i]);
  }
  return pairs;
}

float random_color_component(RandomSource& random) {
  if (random.one_in(2)) return static_cast<float>(random.below(256)) / 255.0F;
  return static_cast<float>(random.below((1 << 20) + 1)) * 0x1p-20F;
}

Color random_color(RandomSource& random) {
  Color color;
  for (float& component : color) component = random_color_component(random);
  return color;
}

bool strictly_inside(Point point, int size) {
  const Fixed end = Fixed::from_integer(size);
  return point.x > Fixed() && point.x < end && point.y > Fixed() && point.y < end;
}

namespace {

constexpr std::int64_t kOne = Fixed::kOne;

// The nearest multiple of `step` towards zero; a shorter length is unchanged.
std::int64_t coarsened(std::int64_t length, std::int64_t step) {
  return std::abs(length) < step ? length : length - length % step;
}

// The shorter component of a vector whose longer one is `longer`, both nonnegative.
std::int64_t random_shorter(RandomSource& random, std::int64_t longer) {
  switch (random.below(8)) {
    case 0:
      return 0;
    case 1:
      return longer;
    case 2:
    case 3: {  // flat, down to a sub-pixel of rise over the whole length
      const std::int64_t rise = random.log_uniform(20);
      return std::min(rise, longer);
    }
    case 4: {  // a simple slope
      const std::int64_t run = random.between(2, 8);
      return longer / run * random.between(1, run - 1);
    }
    default:
      return random.below(longer + 1);
  }
}

// A coordinate of a square of width `size` that contains a and b.
std::int64_t random_between(RandomSource& random, std::int64_t a, std::int64_t b, std::int64_t size,
                            std::int64_t step) {
  const auto [low, high] = std::minmax({a, b});
  const std::int64_t left =
      high - size + random.below(std::max<std::int64_t>(size - (high - low), 0) + 1);
  const std::int64_t first = std::min(low, left);
  const std::int64_t last = std::max(high, first + size);
  return a + coarsened(random.between(first, last) - a, step);
}

// The range of whole-pixel shifts that keep coordinates strictly between 0 and `target`.
std::pair<std::int64_t, std::int64_t> shifts(std::int64_t low, std::int64_t high, int target) {
  return {Fixed::from_raw(-low).floor() + 1, Fixed::from_raw(target * kOne - high).ceil() - 1};
}

}  // namespace

Frame random_frame(RandomSource& random, int largest) {
  const std::int64_t extent =
      random.log_uniform(static_cast<int>(std::bit_width(static_cast<unsigned>(largest))) - 1);
  Frame frame;
  frame.target = static_cast<int>(std::max<std::uint64_t>(
      kLeastRandomTarget, std::bit_ceil(static_cast<std::uint64_t>(extent))));
  // A shift by whole pixels surely exists if the shape needs less than the target minus a pixel;
  // the slack is for nudges and coarsening.
  frame.most = (frame.target - 1) * kOne - kOne / 4;
  frame.extent = std::min(extent * kOne - random.below(kOne), frame.most);
  return frame;
}

Frame with_room(Frame frame) {
  constexpr int kRoom = 8;
  if (frame.target >= kRoom) return frame;
  frame.target = kRoom;
  frame.most = (kRoom - 1) * kOne - kOne / 4;
  return frame;
}

Grid random_grid(RandomSource& random) {
  switch (random.below(10)) {
    case 0:
      return {kOne, 0};
    case 1:
      return {kOne, kOne / 2};
    case 2: {  // midway between the steps of a sub-pixel grid
      const std::int64_t step = kOne >> random.between(4, 12);
      return {step, step / 2};
    }
    case 3:
      return {kOne >> 8, kOne >> 9};
    case 4:
      return {kOne >> 4, kOne >> 5};
    default:
      return {random_step(random), 0};
  }
}

std::int64_t random_step(RandomSource& random) {
  constexpr std::array kBits{1, 1, 1, 2, 2, 4, 4, 8, 8, 12, 16, 16};
  return kOne >> random.one_of(std::span<const int>(kBits));
}

RawVector random_vector(RandomSource& random, std::int64_t extent, std::int64_t step) {
  const std::int64_t longer = coarsened(extent, step);
  const std::int64_t shorter = coarsened(random_shorter(random, longer), step);
  const std::int64_t sign_x = random.sign();
  const std::int64_t sign_y = random.sign();
  return random.one_in(2) ? RawVector{sign_x * longer, sign_y * shorter}
                          : RawVector{sign_x * shorter, sign_y * longer};
}

Point random_point(RandomSource& random, const Grid& grid) {
  const auto coordinate = [&] {
    return Fixed::from_raw(grid.offset % grid.step + grid.step * random.below(kOne / grid.step));
  };
  const Fixed x = coordinate();
  return {x, coordinate()};
}

Point random_neighbour(RandomSource& random, Point a, Point b, std::int64_t size,
                       std::int64_t step) {
  const std::int64_t x = random_between(random, a.x.raw(), b.x.raw(), size, step);
  const std::int64_t y = random_between(random, a.y.raw(), b.y.raw(), size, step);
  return {Fixed::from_raw(x), Fixed::from_raw(y)};
}

void shift_inside(RandomSource& random, int target, std::span<Point> points) {
  const auto by_x = [](Point p, Point q) { return p.x < q.x; };
  const auto by_y = [](Point p, Point q) { return p.y < q.y; };
  const auto [left, right] = std::minmax_element(points.begin(), points.end(), by_x);
  const auto [bottom, top] = std::minmax_element(points.begin(), points.end(), by_y);
  const auto columns = shifts(left->x.raw(), right->x.raw(), target);
  const auto rows = shifts(bottom->y.raw(), top->y.raw(), target);
  const std::int64_t dx = random.between(columns.first, columns.second) * kOne;
  const std::int64_t dy = random.between(rows.first, rows.second) * kOne;
  for (Point& point : points) point = point + RawVector{dx, dy};
}

bool spans_at_most(std::span<const Point> points, std::int64_t most) {
  for (Point p : points)
    for (Point q : points)
      if ((p - q).x > most || (p - q).y > most) return false;
  return true;
}

void nudge(RandomSource& random, int finest, int target, std::span<Point> points) {
  const std::int64_t step = kOne >> random.between(4, finest);
  // Eighths of a step; most often halves, where roundings differ.
  constexpr std::array<std::int64_t, 8> kEighths{0, 0, 2, 4, 4, 4, 6, 8};
  const auto move = [&] {
    const std::int64_t length = random.one_of(std::span<const std::int64_t>(kEighths));
    return random.sign() * length * step / 8;
  };
  for (Point& point : points) {
    const std::int64_t dx = move();
    const Point moved = point + RawVector{dx, move()};
    if (strictly_inside(moved, target)) point = moved;
  }
}

Theme random_theme(RandomSource& random) {
  const std::int64_t share = random.below(20);
  return share < 11 ? Theme::tie : share < 17 ? Theme::near_tie : Theme::free;
}

std::int64_t step_of(RandomSource& random, Theme theme) {
  return theme == Theme::near_tie ? kOne >> random.between(1, 4) : random_step(random);
}

TriangleMesh separated(RandomSource& random, const TriangleMesh& mesh) {
  std::vector<std::array<Point, 3>> triangles;
  const std::vector<Point>& v = mesh.vertices;
  if (mesh.primitive == Primitive::triangles)
    for (std::size_t i = 0; i + 2 < v.size(); i += 3)
      triangles.push_back({v[i], v[i + 1], v[i + 2]});
  else
    for (std::size_t i = 2; i < v.size(); ++i)
      triangles.push_back(
          {mesh.primitive == Primitive::triangle_fan ? v[0] : v[i - 2], v[i - 1], v[i]});
  TriangleMesh result{Primitive::triangles, {}};
  while (!triangles.empty()) {
    const auto next = triangles.begin() + random.below(static_cast<std::int64_t>(triangles.size()));
    std::array<Point, 3> triangle = *next;
    triangles.erase(next);
    std::rotate(triangle.begin(), triangle.begin() + random.below(3), triangle.end());
    if (random.one_in(2)) std::swap(triangle[0], triangle[1]);
    result.vertices.insert(result.vertices.end(), triangle.begin(), triangle.end());
  }
  return result;
}

}  // namespace edgecase
