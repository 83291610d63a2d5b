// SPDX-License-Identifier: MIT
//
// What an adversary makes of a primitive: cut, divided by w, moved onto its sub-pixel grid, and the
// pixels and samples that it covers (GL 4.6 core, 13.7, 13.8.1, 14.4 to 14.6).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "exact/fixed.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "tests/adversaries/freedoms.h"

namespace edgecase::adversary {

// Where coverage is decided: in the window, 2^-16 pixel.
struct Place {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const Place&, const Place&) = default;
};
constexpr std::int64_t kPixel = 65536;

struct Corner {
  std::array<double, 4> clip{};   // x, y, z, w
  std::array<double, 4> value{};  // what is interpolated
  Place place;                    // as coverage has it
  Real x, y;                      // as values have it, pixels
  Real depth;                     // in the window
};

// A point, a line, or a triangle of the fan that a polygon is.
struct Piece {
  std::array<Corner, 3> corners;
};

struct Shape {
  const ScenePrimitive* primitive = nullptr;
  const Draw* draw = nullptr;
  std::vector<Piece> pieces;  // none: nothing of it is seen
  std::array<double, 4> provoking{};
  bool front = true;
  bool is_cut = false;  // some of it lies beyond the clip volume
  PixelBounds bounds;   // pixels that it may have
};

// The pixels of single-sampled lines, of which each has a piece (the only one) and the place where
// its values are taken.
struct LinePixel {
  PixelPosition pixel;
  Place valued_at;
};

class Shaper {
 public:
  // Both must outlive it.
  Shaper(const Scene& scene, const Freedoms& freedoms)
      : scene_(scene), freedoms_(freedoms), primitives_(primitives_of(scene)) {}

  const std::vector<ScenePrimitive>& primitives() const { return primitives_; }

  Shape shape_of(const ScenePrimitive& primitive) const;
  // Of points and polygons, and of lines where they are multisampled: the piece that covers a
  // place, or none.
  const Piece* piece_at(const Shape& shape, Place place) const;
  std::vector<LinePixel> line_pixels(const Shape& shape) const;

 private:
  Corner corner_of(const Vertex& vertex, const Draw& draw) const;
  void place(Corner& corner, const Vertex* given, bool is_line) const;
  std::vector<Corner> cut(std::vector<Corner> polygon, bool smooth) const;
  std::int64_t snapped(double pixels, std::uint64_t luck, bool is_line) const;
  bool owns(std::int64_t along_x, std::int64_t along_y) const;
  bool covers(const Piece& triangle, Place place, int index) const;
  bool point_covers(const Shape& shape, Place place) const;
  bool rectangle_covers(const Shape& shape, Place place) const;
  bool exits_diamond(Place a, Place b, Place centre) const;
  void finish_polygon(Shape& shape, const std::vector<Corner>& polygon) const;
  bool is_alone(const ScenePrimitive& line) const;

  const Scene& scene_;
  const Freedoms& freedoms_;
  std::vector<ScenePrimitive> primitives_;
};

}  // namespace edgecase::adversary
