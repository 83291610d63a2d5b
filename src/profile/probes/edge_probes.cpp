// SPDX-License-Identifier: MIT
//
// Triangles with one sample on an edge or at a corner. Edges run in 24 directions and are shorter
// than a step from one sample to the next, so that they pass through one sample only; of several
// places for the other vertices the first is taken that puts no other sample on an edge.
#include <algorithm>
#include <array>

#include "generate/scene_parts.h"
#include "profile/probes/probe_scenes.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

constexpr int kTarget = 16;
constexpr PixelPosition kPixel{7, 8};

constexpr const char* kSideNames[kEdgeSides] = {
    "left", "right", "bottom", "top", "lower left", "lower right", "upper left", "upper right"};

// Counter-clockwise from the right. A sample lies at every whole multiple, and at none between.
constexpr std::array<RawVector, 24> kDirections{
    {{1, 0},   {4, 1},   {2, 1},  {1, 1},  {1, 2},  {1, 4},   {0, 1},   {-1, 4},
     {-1, 2},  {-1, 1},  {-2, 1}, {-4, 1}, {-1, 0}, {-4, -1}, {-2, -1}, {-1, -1},
     {-1, -2}, {-1, -4}, {0, -1}, {1, -4}, {1, -2}, {1, -1},  {2, -1},  {4, -1}}};

// How far an edge reaches to either side of the sample, in sixteenths of its direction.
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

// The pixels that open and closed edges disagree about.
int count_ties(const Triangle& triangle) {
  static const TieRule& open = *find_tie_rule("open");
  static const TieRule& closed = *find_tie_rule("closed");
  int ties = 0;
  for (int y = 0; y < kTarget; ++y)
    for (int x = 0; x < kTarget; ++x)
      if (triangle_covers(triangle, x, y, open) != triangle_covers(triangle, x, y, closed)) ++ties;
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
  return {};  // not reached: the tests count the probes
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
  // Interior to the left of from -> corner -> to.
  if (turn(to, from) <= 0) return;
  const Triangle triangle = triangle_at_corner(from, to);
  if (doubled_area(triangle) == 0) return;
  EdgeProbe probe = make_probe(surface, triangle, probes.size() % 2 == 1);
  probe.corner_with = side_of(triangle[1], triangle[2]);
  probes.push_back(std::move(probe));
}

}  // namespace

const char* name_of(EdgeSide side) {
  return kSideNames[static_cast<std::size_t>(side)];
}

EdgeSide side_of(Point a, Point b) {
  const RawVector along = b - a;
  // The interior of a counter-clockwise triangle lies to the left, the outside to the right: an
  // edge that goes down has its outside to the left, one that goes right has it below.
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
