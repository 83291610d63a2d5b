// SPDX-License-Identifier: MIT
//
// How random primitives are made: first a size, then a shape of about that size round pixel (0, 0),
// then a shift by whole pixels to a random position strictly inside the target. Whole pixels do not
// affect ties, so a shape can be built round one beforehand.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "generate/random_scenes.h"
#include "model/scene.h"

namespace edgecase {

// Common parts of generated scenes.

// A difference of two points in raw units of 2^-16 pixel.
struct RawVector {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

constexpr Point operator+(Point p, RawVector v) {
  return {Fixed::from_raw(p.x.raw() + v.x), Fixed::from_raw(p.y.raw() + v.y)};
}
constexpr Point operator-(Point p, RawVector v) {
  return p + RawVector{-v.x, -v.y};
}
constexpr RawVector operator-(Point p, Point q) {
  return {p.x.raw() - q.x.raw(), p.y.raw() - q.y.raw()};
}
constexpr RawVector operator+(RawVector a, RawVector b) {
  return {a.x + b.x, a.y + b.y};
}
constexpr RawVector operator*(std::int64_t n, RawVector v) {
  return {n * v.x, n * v.y};
}

// Twice the area between two vectors, positive if b lies to the left of a.
constexpr std::int64_t turn(RawVector a, RawVector b) {
  return a.x * b.y - a.y * b.x;
}

// Added to a stream: windows have other scenes, so that both surfaces together show more.
constexpr std::uint64_t window_streams(Surface surface) {
  return surface == Surface::window ? 0x1000 : 0;
}

// A square target without draws, with a viewport of the same size.
Scene empty_scene(Surface surface, int size);

// One draw; vertex v has colour v of 63 distinct colours without black.
Scene scene_of(Surface surface, int size, Primitive primitive, std::span<const Point> positions);

// Whether the point lies strictly inside a square target, or viewport.
bool strictly_inside(Point point, int size);

// The vertices of a strip's lines, drawn as separate ones: inner vertices occur twice.
std::vector<Point> separate_lines(std::span<const Point> strip);

// A code of 8 bits, or any number of 20 bits; and four of them.
float random_color_component(RandomSource& random);
Color random_color(RandomSource& random);

// The size of a scene.
struct Frame {
  int target = 0;           // pixels: a power of two
  std::int64_t extent = 0;  // raw: the primitive's longer side
  std::int64_t most = 0;    // raw: every shape up to this length fits the target
};
// `largest`: of the target, pixels, a power of two.
Frame random_frame(RandomSource& random, int largest = kMostRandomExtent);

// The same on a target of at least 8 pixels, for shapes of several primitives.
Frame with_room(Frame frame);

// Coordinates of a scene: offset + any multiple of step; raw.
struct Grid {
  std::int64_t step = Fixed::kOne;
  std::int64_t offset = 0;
};
// From whole pixels to 2^-16, including pixel centres and midpoints between sub-pixel steps.
Grid random_grid(RandomSource& random);
// A step of 2^-1 to 2^-16 pixel; coarse ones are frequent.
std::int64_t random_step(RandomSource& random);

// A vector of any direction with a longer component of about `extent`; axes, diagonals, flat and
// steep ones are frequent. Its components are multiples of `step`, unless they are shorter; both
// are 0 only if the extent is.
RawVector random_vector(RandomSource& random, std::int64_t extent, std::int64_t step);

// A point of the grid in pixel (0, 0), including its left and lower border.
Point random_point(RandomSource& random, const Grid& grid);

// Any point of a square of raw width `size` that contains two points; it may lie beyond them. It is
// a multiple of `step` away from the first.
Point random_neighbour(RandomSource& random, Point a, Point b, std::int64_t size,
                       std::int64_t step);

// Whether a square of raw width `most` can hold the points.
bool spans_at_most(std::span<const Point> points, std::int64_t most);

// Shifts points by whole pixels so that all lie strictly inside the target. They must span at most
// Frame::most.
void shift_inside(RandomSource& random, int target, std::span<Point> points);

// Moves coordinates by fractions of a step of 2^-4 to 2^-`finest` pixel, so that the result of a
// tie depends on how vertices are snapped. A vertex that would leave the target is not moved.
void nudge(RandomSource& random, int finest, int target, std::span<Point> points);

// The kind of coordinates that a scene is built round.
enum class Theme {
  tie,       // a sample exactly on a boundary
  near_tie,  // the same, nudged
  free,      // any numbers
};
Theme random_theme(RandomSource& random);

// The step of a tie's vertices: one that nudges do not hide.
std::int64_t step_of(RandomSource& random, Theme theme);

// Vertices in the order of a fan or a strip, or of separate triangles.
struct TriangleMesh {
  Primitive primitive = Primitive::triangle_fan;
  std::vector<Point> vertices;
};

// The triangles separately, in any order, each starting at any vertex with either winding.
TriangleMesh separated(RandomSource& random, const TriangleMesh& mesh);

// The points of each kind of primitive.
struct RandomPoint {
  Point vertex;
  Fixed size;
};
RandomPoint random_point_shape(RandomSource& random, const Frame& frame);
std::vector<Point> random_line_shape(RandomSource& random, const Frame& frame);
// Ties involve the point `tied` of pixel (0, 0).
std::vector<Point> random_triangle_shape(RandomSource& random, const Frame& frame,
                                         Point tied = pixel_centre(0, 0));
// Six points: two triangles on opposite sides of their common edge.
std::vector<Point> random_pair_shape(RandomSource& random, const Frame& frame);

// A line of this raw width that is an area. Ties involve the point `tied` of pixel (0, 0), on one
// of its ends or sides.
std::vector<Point> random_area_line_shape(RandomSource& random, const Frame& frame,
                                          std::int64_t width, Point tied);

}  // namespace edgecase
