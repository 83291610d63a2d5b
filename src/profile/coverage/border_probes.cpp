// SPDX-License-Identifier: MIT
//
// Probes of borders: diamonds that lines start or end in, edges and corners of triangles.
#include <algorithm>
#include <array>
#include <cstdlib>

#include "generate/grids.h"
#include "generate/random_shapes.h"
#include "profile/coverage/coverage.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {

// ---------------------------------------------------------------------------------------- diamonds

// Lines with one end at a place of a diamond. For each direction, end and place, the far ends and
// the points of the place are tried in turn, and the first lines that depend on no other tie are
// taken; if there are none, any line is.

namespace {

constexpr int kTarget = 16;
constexpr PixelPosition kPixel{7, 8};
constexpr int kVariants = 4;
constexpr std::int64_t kOne = Fixed::kOne;

// Distances along the place, by variant: two on a grid of 1/16, one on 1/256, one on 2^-16. Those
// inside and outside are divided by 2 and 4.
constexpr std::array<std::int64_t, kVariants> kAlong{kOne / 4, kOne * 5 / 16, kOne * 36 / 256,
                                                     kOne / 2 - 5420};

// The far ends relative to the near one, in sixteenths of a pixel along the major axis, nearest
// first, and across it.
struct Away {
  std::int64_t along;
  std::int64_t across;
};

// Turns the first octant's vector with these components into a direction's octant or axis.
RawVector turned_into(LineDirection direction, Away away) {
  const int number = static_cast<int>(direction);
  // Mirrored into the first quarter, then into its first half.
  const int in_half = number <= 8 ? number : 16 - number;
  const int in_quarter = in_half <= 4 ? in_half : 8 - in_half;
  RawVector v{away.along * kOne / 16, away.across * kOne / 16};
  if (in_quarter > 2) std::swap(v.x, v.y);
  if (in_half > 4) v.x = -v.x;
  if (number > 8) v.y = -v.y;
  return v;
}

bool is_on_axis(LineDirection direction) {
  return static_cast<int>(direction) % 4 == 0;
}

bool is_diagonal(LineDirection direction) {
  return static_cast<int>(direction) % 4 == 2;
}

// Vectors of a direction, 3 to 6 pixels long; `variant` determines the first one.
std::vector<RawVector> vectors_of(LineDirection direction, int variant) {
  std::vector<RawVector> result;
  for (int i = 0; i < 48; ++i) {
    const std::int64_t along = 48 + (i * 5 + variant * 13) % 48;
    if (is_on_axis(direction)) {
      result.push_back(turned_into(direction, {along, 0}));
    } else if (is_diagonal(direction)) {
      result.push_back(turned_into(direction, {along, along}));
    } else {
      for (std::int64_t across = 3; across < along; across += 7)
        result.push_back(
            turned_into(direction, {along, (across + variant * 17) % (along - 1) + 1}));
    }
  }
  return result;
}

Point moved_to_pixel(Point point) {
  return point + RawVector{kPixel.x * kOne, kPixel.y * kOne};
}

bool lies_in_a_diamond(Point p) {
  const PixelPosition pixel{static_cast<int>(p.x.floor()), static_cast<int>(p.y.floor())};
  return place_in_pixel(p, pixel) == DiamondPlace::inside;
}

// Whether the point is on this pixel's diamond at all.
bool touches(Point point, PixelPosition pixel) {
  const auto place = place_in_pixel(point, pixel);
  return place && *place < DiamondPlace::inside;
}

// Whether a tie decides some pixel whose diamond does not have the near end on its boundary.
bool is_tied_elsewhere(const Segment& segment, Point near) {
  for (int y = 0; y < kTarget; ++y)
    for (int x = 0; x < kTarget; ++x)
      if (PixelPosition{x, y} != kPixel && !touches(near, {x, y}) && is_tied(segment, {x, y}))
        return true;
  return false;
}

DiamondProbe make_probe(Surface surface, const Segment& segment) {
  DiamondProbe probe;
  probe.scene = scene_of(surface, kTarget, Primitive::lines, std::array{segment.a, segment.b});
  probe.pixel = kPixel;
  return probe;
}

DiamondProbe find_probe(Surface surface, LineDirection direction, bool at_start, DiamondPlace place,
                        int variant) {
  const Point near = moved_to_pixel(point_at(place, kAlong[static_cast<std::size_t>(variant)]));
  const std::vector<RawVector> vectors = vectors_of(direction, variant);
  const auto segment_by = [&](RawVector v) {
    return at_start ? Segment{near, near + v} : Segment{near - v, near};
  };
  DiamondProbe probe = make_probe(surface, segment_by(vectors[0]));
  probe.tied_elsewhere = true;
  for (RawVector v : vectors) {
    const Segment segment = segment_by(v);
    if (!lies_in_a_diamond(at_start ? segment.b : segment.a)) continue;
    if (is_tied_elsewhere(segment, near)) continue;
    probe = make_probe(surface, segment);
    probe.tied_elsewhere = false;
    break;
  }
  probe.direction = direction;
  probe.at_start = at_start;
  probe.place = place;
  return probe;
}

}  // namespace

std::vector<DiamondProbe> diamond_probes(Surface surface) {
  std::vector<DiamondProbe> result;
  for (int direction = 0; direction < kLineDirections; ++direction)
    for (const bool at_start : {true, false})
      for (int place = 0; place < kDiamondPlaces; ++place)
        for (int variant = 0; variant < kVariants; ++variant)
          result.push_back(find_probe(surface, static_cast<LineDirection>(direction), at_start,
                                      static_cast<DiamondPlace>(place), variant));
  return result;
}

// ------------------------------------------------------------------------------------------- edges

// Triangles with one sample on an edge or at a corner. Edges have 24 directions and are shorter
// than the distance between samples, so that each passes through only one sample. Of several
// positions of the other vertices, the first one that puts no other sample on an edge is taken.

namespace {

// Counter-clockwise from the right. A sample lies at every whole multiple, and none between.
constexpr std::array<RawVector, 24> kDirections{
    {{1, 0},   {4, 1},   {2, 1},  {1, 1},  {1, 2},  {1, 4},   {0, 1},   {-1, 4},
     {-1, 2},  {-1, 1},  {-2, 1}, {-4, 1}, {-1, 0}, {-4, -1}, {-2, -1}, {-1, -1},
     {-1, -2}, {-1, -4}, {0, -1}, {1, -4}, {1, -2}, {1, -1},  {2, -1},  {4, -1}}};

// How far an edge extends to either side of the sample, in sixteenths of its direction.
struct Reach {
  std::int64_t before;
  std::int64_t after;
};
constexpr std::array<Reach, 4> kReaches{{{8, 8}, {15, 13}, {5, 12}, {11, 3}}};

Point sample() {
  return pixel_centre(kPixel.x, kPixel.y);
}

RawVector sixteenths(std::int64_t count, RawVector direction) {
  return count * RawVector{direction.x * Fixed::kOne / 16, direction.y * Fixed::kOne / 16};
}

// The number of pixels on which open and closed edges disagree.
int count_ties(const Triangle& triangle) {
  int ties = 0;
  for (int y = 0; y < kTarget; ++y)
    for (int x = 0; x < kTarget; ++x)
      if (triangle_covers(triangle, x, y, open_ties()) !=
          triangle_covers(triangle, x, y, closed_ties()))
        ++ties;
  return ties;
}

bool is_good(const Triangle& triangle) {
  return doubled_area(triangle) > 0 && count_ties(triangle) == 1 &&
         std::all_of(triangle.begin(), triangle.end(),
                     [](Point p) { return strictly_inside(p, kTarget); });
}

EdgeProbe make_probe(Surface surface, const Triangle& ccw, bool clockwise) {
  Triangle triangle = ccw;
  if (clockwise) std::swap(triangle[0], triangle[2]);
  EdgeProbe probe;
  probe.scene = scene_of(surface, kTarget, Primitive::triangles, triangle);
  probe.pixel = kPixel;
  probe.side = side_of(ccw[0], ccw[1]);
  return probe;
}

// The interior lies to the left of the edge, which runs along the direction.
Triangle triangle_on_edge(RawVector direction, Reach reach) {
  const Point a = sample() - sixteenths(reach.before, direction);
  const Point b = sample() + sixteenths(reach.after, direction);
  const RawVector left{-direction.y, direction.x};
  for (std::int64_t height = 19; height < 80; ++height)
    for (std::int64_t aside = -9; aside <= 9; ++aside) {
      const Triangle triangle{a, b,
                              sample() + sixteenths(height, left) + sixteenths(aside, {1, 1})};
      if (is_good(triangle)) return triangle;
    }
  return {};  // not reached: tests count the probes
}

// A corner at the sample: the edge that arrives there comes from `from`, the next goes to `to`.
Triangle triangle_at_corner(RawVector from, RawVector to) {
  for (std::int64_t length = 15; length > 3; --length)
    for (std::int64_t other = 15; other > 3; --other) {
      const Triangle triangle{sample() + sixteenths(length, from), sample(),
                              sample() + sixteenths(other, to)};
      if (is_good(triangle)) return triangle;
    }
  return {};
}

void add_corner(std::vector<EdgeProbe>& probes, Surface surface, RawVector from, RawVector to) {
  // The interior is to the left of from -> corner -> to.
  if (turn(to, from) <= 0) return;
  const Triangle triangle = triangle_at_corner(from, to);
  if (doubled_area(triangle) == 0) return;
  EdgeProbe probe = make_probe(surface, triangle, probes.size() % 2 == 1);
  probe.corner_with = side_of(triangle[1], triangle[2]);
  probes.push_back(std::move(probe));
}

}  // namespace

EdgeSide side_of(Point a, Point b) {
  const RawVector along = b - a;
  // The interior of a counter-clockwise triangle is to the left of its edges: an edge that goes
  // down is a left side, one that goes right is a bottom side.
  if (along.x == 0) return along.y < 0 ? EdgeSide::left : EdgeSide::right;
  if (along.y == 0) return along.x > 0 ? EdgeSide::bottom : EdgeSide::top;
  if (along.y < 0) return along.x > 0 ? EdgeSide::lower_left : EdgeSide::upper_left;
  return along.x > 0 ? EdgeSide::lower_right : EdgeSide::upper_right;
}

std::vector<EdgeProbe> edge_probes(Surface surface) {
  std::vector<EdgeProbe> result;
  for (RawVector direction : kDirections)
    for (Reach reach : kReaches)
      for (const bool clockwise : {false, true})
        result.push_back(make_probe(surface, triangle_on_edge(direction, reach), clockwise));
  for (RawVector from : kDirections)
    for (RawVector to : kDirections) add_corner(result, surface, from, to);
  return result;
}

}  // namespace edgecase
