// SPDX-License-Identifier: MIT
#include "rules/coverage/point_ownership.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "exact/numeral.h"

namespace edgecase {
namespace {

constexpr std::int64_t kHalf = Fixed::kOne / 2;

// How far the centre lies from the vertex along the axis where it lies farther, raw.
std::int64_t chebyshev_distance(Point vertex, Point centre) {
  return std::max(std::abs(centre.x.raw() - vertex.x.raw()),
                  std::abs(centre.y.raw() - vertex.y.raw()));
}

}  // namespace

Rule point_ownership_rule() {
  return {
      "point.ownership",
      "A point of size 1 covers the pixel whose centre lies in its square",
      "14.4 (points)",
      "a centre exactly on the boundary of the square may count or not; the vertex may be moved to "
      "the sub-pixel grid",
      "right-top",
      tie_alternatives(Openness::open, Openness::open),
      {{6,
        "Points: the specification does not say whether the boundary of a point's square belongs "
        "to "
        "it. A pixel centre on the boundary, for some position of the vertex less than one step of "
        "2^-b away (b as in ruling 4), may be covered or not."}}};
}

bool point_covers(Point vertex, int x, int y, const TieRule& ties) {
  const Point centre = pixel_centre(x, y);
  const std::int64_t dx = centre.x.raw() - vertex.x.raw();
  const std::int64_t dy = centre.y.raw() - vertex.y.raw();
  return ties.positive(kHalf + dx, 1, 0) && ties.positive(kHalf - dx, -1, 0) &&
         ties.positive(kHalf + dy, 0, 1) && ties.positive(kHalf - dy, 0, -1);
}

Explanation explain_point(Point vertex, int x, int y, const TieRule& ties) {
  const Point centre = pixel_centre(x, y);
  const std::int64_t distance = chebyshev_distance(vertex, centre);
  const char* where = distance < kHalf    ? "inside"
                      : distance == kHalf ? "exactly on the boundary of"
                                          : "outside";
  Explanation result;
  result.text = fmt::format(
      "the pixel's centre {} lies {} the unit square round the point {} ({} from it along the axis "
      "where it is farther; 0.5 is the boundary)",
      format_point(centre), where, format_point(vertex), to_decimal(Fixed::from_raw(distance)));
  if (distance == kHalf)
    result.text += fmt::format("; the tie is decided by {}, so the centre counts as {}", ties.name,
                               point_covers(vertex, x, y, ties) ? "inside" : "outside");
  const double px = vertex.x.to_double();
  const double py = vertex.y.to_double();
  result.figure.marks = {
      {MarkRole::region,
       true,
       {{px - .5, py - .5}, {px + .5, py - .5}, {px + .5, py + .5}, {px - .5, py + .5}},
       ""},
      sample_mark(centre)};
  return result;
}

bool point_possibly_covered(Point vertex, int x, int y, int bits) {
  const std::int64_t step = Fixed::kOne >> bits;
  return chebyshev_distance(vertex, pixel_centre(x, y)) < kHalf + step;
}

bool point_possibly_uncovered(Point vertex, int x, int y, int bits) {
  const std::int64_t step = Fixed::kOne >> bits;
  return chebyshev_distance(vertex, pixel_centre(x, y)) > kHalf - step;
}

}  // namespace edgecase
