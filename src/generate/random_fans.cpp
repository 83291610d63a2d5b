// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>
#include <vector>

#include "generate/grids.h"
#include "generate/random_scenes.h"
#include "generate/random_shapes.h"

namespace edgecase {
namespace {

// Generators of one seed with different purposes are independent.
constexpr std::uint64_t kJointStream = 0x6100;
constexpr int kFinestSnap = 12;
constexpr std::int64_t kOne = Fixed::kOne;

using Chain = std::vector<Point>;

enum class Course {
  straight,   // one direction
  wandering,  // one major axis and direction along it
  turning,    // any directions
  back,       // to and fro
};

// A direction with the same major axis and sign; 45 degrees counts as x-major.
LineDirection neighbour_of(RandomSource& random, LineDirection direction) {
  const int axis = (static_cast<int>(direction) + 2) / 4 * 4;
  const int most = axis % 8 == 0 ? 2 : 1;
  return static_cast<LineDirection>((axis + random.between(-most, most) + kLineDirections) %
                                    kLineDirections);
}

LineDirection next_direction(RandomSource& random, Course course, LineDirection direction) {
  switch (course) {
    case Course::straight:
      return direction;
    case Course::wandering:
      return neighbour_of(random, direction);
    case Course::turning:
      return static_cast<LineDirection>(random.below(kLineDirections));
    case Course::back:
      return static_cast<LineDirection>((static_cast<int>(direction) + kLineDirections / 2) %
                                        kLineDirections);
  }
  return direction;
}

Course random_course(RandomSource& random) {
  const std::int64_t share = random.below(16);
  return share < 4    ? Course::straight
         : share < 9  ? Course::wandering
         : share < 15 ? Course::turning
                      : Course::back;
}

// The first joint is at a place of pixel (0, 0), where a segment's end is usually a tie.
Chain random_chain(RandomSource& random, const Frame& frame, std::int64_t step) {
  const auto place = static_cast<DiamondPlace>(random.below(kDiamondPlaces));
  const Point joint = random_point_at(place, random, std::min(step, kOne / 16));
  const Course course = random_course(random);
  const std::int64_t segments = random.between(2, 6);
  const std::int64_t most = std::max(2 * frame.most / (3 * segments), 2 * step);
  const auto length = [&] {
    return random.one_in(4) ? random.between(kOne / 8, kOne) : random.between(1, most);
  };
  auto direction = static_cast<LineDirection>(random.below(kLineDirections));
  if (course == Course::wandering) direction = neighbour_of(random, direction);
  Chain chain{joint - random_along(random, direction, length(), step), joint};
  while (static_cast<std::int64_t>(chain.size()) <= segments) {
    direction = next_direction(random, course, direction);
    chain.push_back(chain.back() + random_along(random, direction, length(), step));
  }
  return chain;
}

Chain fitting_chain(RandomSource& random, const Frame& frame) {
  for (;;) {
    const Theme theme = random_theme(random);
    const std::int64_t step = std::min(step_of(random, theme), kOne / 2);
    Chain chain = random_chain(random, frame, step);
    if (!spans_at_most(chain, frame.most)) continue;
    if (random.one_in(2)) std::reverse(chain.begin(), chain.end());
    shift_inside(random, frame.target, chain);
    if (theme == Theme::near_tie) nudge(random, kFinestSnap, frame.target, chain);
    return chain;
  }
}

Scene drawn(RandomSource& random, Surface surface, int target, const Chain& chain) {
  switch (random.below(4)) {
    case 0:
      return scene_of(surface, target, Primitive::lines, separate_lines(chain));
    case 1:
      return scene_of(surface, target, Primitive::line_loop, chain);
    default:
      return scene_of(surface, target, Primitive::line_strip, chain);
  }
}

}  // namespace

Scene random_joint_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  RandomSource random(seed, kJointStream, index);
  // Two segments of two steps each need room.
  const Frame frame = with_room(random_frame(random, kMostCompoundTarget));
  Scene scene = drawn(random, surface, frame.target, fitting_chain(random, frame));
  if (random.one_in(8))
    scene.draws[0].line_width = Fixed::from_raw(random.between(5, 24) * kOne / 4);
  return scene;
}

namespace {

// Generators of one seed with different purposes are independent.
constexpr std::uint64_t kFanStream = 0x6200;

// A hub and the vertices round it, counter-clockwise. In a closed fan the last vertex repeats the
// first.
TriangleMesh random_fan(RandomSource& random, const Frame& frame, std::int64_t step) {
  const bool is_closed = random.one_in(2);
  const std::int64_t spokes = is_closed ? random.between(3, 8) : random.between(2, 6);
  const std::int64_t most = std::max(frame.most / 2, 2 * step);
  const Point hub =
      random.one_in(8) ? random_point(random, random_grid(random)) : pixel_centre(0, 0);
  TriangleMesh mesh{Primitive::triangle_fan, {hub}};
  const std::int64_t first = random.below(kLineDirections);
  for (std::int64_t i = 0; i < spokes; ++i) {
    // Sixteenths of a turn: spread evenly in a closed fan, adjacent otherwise.
    const std::int64_t turned = is_closed ? i * kLineDirections / spokes : i;
    const auto direction = static_cast<LineDirection>((first + turned) % kLineDirections);
    const std::int64_t length = random.one_in(3) ? random.between(kOne, 2 * kOne) : most;
    mesh.vertices.push_back(hub + random_along(random, direction, random.between(1, length), step));
  }
  if (is_closed) mesh.vertices.push_back(mesh.vertices[1]);
  return mesh;
}

// A long spoke with a few others near it, from a pixel down to 2^-16 away.
TriangleMesh random_slivers(RandomSource& random, const Frame& frame, std::int64_t step) {
  const Point hub = pixel_centre(0, 0);
  const RawVector spoke =
      random_vector(random, random.between(std::min(kOne, frame.most), frame.most - kOne), step);
  const bool is_flat = std::abs(spoke.x) >= std::abs(spoke.y);
  std::int64_t aside = -random.log_uniform(15);
  TriangleMesh mesh{Primitive::triangle_fan, {hub}};
  const std::int64_t count = random.between(2, 5);
  for (std::int64_t i = 0; i < count; ++i) {
    mesh.vertices.push_back(hub + spoke + (is_flat ? RawVector{0, aside} : RawVector{aside, 0}));
    aside = aside < 0 && random.one_in(2)
                ? 0
                : std::max<std::int64_t>(aside, 0) + random.log_uniform(14);
  }
  return mesh;
}

// Two rows of vertices, shifted by half a step against each other.
TriangleMesh random_strip(RandomSource& random, const Frame& frame, std::int64_t step) {
  const std::int64_t triangles = random.between(2, 8);
  const std::int64_t runs = triangles / 2 + 1;
  const RawVector run = random_vector(random, frame.most / (2 * runs), step);
  const RawVector rise = random_vector(random, frame.most / 2, step);
  const Point start = pixel_centre(0, 0);
  TriangleMesh mesh{Primitive::triangle_strip, {}};
  for (std::int64_t i = 0; i < triangles + 2; ++i)
    mesh.vertices.push_back(start + (i / 2) * run + (i % 2) * rise);
  return mesh;
}

// One triangle, and two on the other side of its edge that share a vertex on it.
TriangleMesh random_t_junction(RandomSource& random, const Frame& frame, std::int64_t step) {
  const std::int64_t before = random.between(1, 3);
  const std::int64_t after = random.between(1, 3);
  const RawVector part = random_vector(random, frame.most / (before + after) / 2, step);
  const Point junction = pixel_centre(0, 0);
  const Point a = junction - before * part;
  const Point b = junction + after * part;
  const auto third = [&] { return random_neighbour(random, a, b, frame.most, step); };
  const Point left = third();
  Point right = third();
  for (int i = 0; i < 8 && (turn(b - a, left - a) > 0) == (turn(b - a, right - a) > 0); ++i)
    right = third();
  return {Primitive::triangles, {a, b, left, a, junction, right, junction, b, right}};
}

TriangleMesh random_mesh(RandomSource& random, const Frame& frame, std::int64_t step) {
  switch (random.below(8)) {
    case 0:
      return random_slivers(random, frame, step);
    case 1:
    case 2:
      return random_strip(random, frame, step);
    case 3:
      return random_t_junction(random, frame, step);
    default:
      return random_fan(random, frame, step);
  }
}

TriangleMesh fitting_mesh(RandomSource& random, const Frame& frame) {
  for (;;) {
    const Theme theme = random_theme(random);
    const std::int64_t step = std::min(step_of(random, theme), kOne / 2);
    TriangleMesh mesh = random_mesh(random, frame, step);
    if (!spans_at_most(mesh.vertices, frame.most)) continue;
    shift_inside(random, frame.target, mesh.vertices);
    if (theme != Theme::near_tie) return mesh;
    // Equal vertices stay equal.
    std::vector<Point> moved = mesh.vertices;
    nudge(random, kFinestSnap, frame.target, moved);
    for (std::size_t i = 0; i < moved.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (mesh.vertices[i] == mesh.vertices[j]) {
          moved[i] = moved[j];
          break;
        }
    mesh.vertices = std::move(moved);
    return mesh;
  }
}

}  // namespace

Scene random_fan_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  RandomSource random(seed, kFanStream, index);
  // Triangles on all sides of a vertex need room.
  const Frame frame = with_room(random_frame(random, kMostCompoundTarget));
  TriangleMesh mesh = fitting_mesh(random, frame);
  if (random.one_in(3)) mesh = separated(random, mesh);
  return scene_of(surface, frame.target, mesh.primitive, mesh.vertices);
}

}  // namespace edgecase
