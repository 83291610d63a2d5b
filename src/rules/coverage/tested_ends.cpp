// SPDX-License-Identifier: MIT
#include "rules/coverage/tested_ends.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "exact/binary32.h"
#include "rules/coverage/line_areas.h"

namespace edgecase {
namespace {

constexpr int kGrid = 256;  // steps per pixel
const Binary32 kHalf = Binary32::from_fixed(Fixed::from_raw(Fixed::kOne / 2));
const Binary32 kOne = Binary32::from_integer(1);

// x and y in single precision, of a point or of a distance.
struct Pair {
  Binary32 x;
  Binary32 y;
};

bool is_less(Binary32 a, Binary32 b) {
  return (a - b).is_negative();
}

Binary32 magnitude(Binary32 value) {
  return value.is_negative() ? -value : value;
}

Binary32 fraction(Binary32 value) {
  return value - Binary32::from_integer(value.floor());
}

// A line turned to be x-major: if it is y-major, "along" is downwards and "across" is to the right.
// Then both cases are the same, except for one tie.
struct Frame {
  bool x_major;
  Binary32 along(Pair p) const { return x_major ? p.x : -p.y; }
  Binary32 across(Pair p) const { return x_major ? p.y : p.x; }
  Pair pair(Binary32 along, Binary32 across) const {
    return x_major ? Pair{along, across} : Pair{across, -along};
  }
};

// From the centre of its pixel to the point.
Pair from_centre(Pair p) {
  return {fraction(p.x) - kHalf, fraction(p.y) - kHalf};
}

class TestedLine {
 public:
  TestedLine(Pair start, Pair end)
      : start_(start),
        end_(end),
        frame_{!is_less(magnitude(end.x - start.x), magnitude(end.y - start.y))} {
    const Pair back{start.x - end.x, start.y - end.y};
    back_along_ = frame_.along(back);
    back_across_ = frame_.across(back);
    slope_ = back_across_ / back_along_;
  }

  const Frame& frame() const { return frame_; }

  bool runs_along() const { return back_along_.is_negative(); }

  // Start and end, moved if the two tests differ.
  std::pair<Pair, Pair> moved_ends() const {
    Pair start = start_, end = end_;
    const Place first = place_of(start_);
    Place last = place_of(end_);
    // A line that comes from below: an end on its pixel's lower border counts as on the upper.
    if (last.across == -kHalf && back_across_.is_negative()) last.across = kHalf;
    if (draws_start(first) != reaches_start(first)) start = moved(start_, first);
    if (draws_end(last) != reaches_end(last)) end = moved(end_, last);
    return {start, end};
  }

 private:
  // The position of an end relative to its pixel's centre, and its fraction across.
  struct Place {
    Binary32 along;
    Binary32 across;
    Binary32 fraction_across;
  };

  Place place_of(Pair end) const {
    const Pair distance = from_centre(end);
    return {frame_.along(distance), frame_.across(distance), fraction(frame_.across(end))};
  }

  static bool in_diamond(const Place& place) {
    return is_less(magnitude(place.along) + magnitude(place.across), kHalf);
  }

  // True if the line's continuation crosses the middle of the pixel, along its major axis, inside
  // it.
  bool crosses_middle(const Place& place) const {
    const Binary32 at = place.fraction_across + place.along * slope_;
    return is_less(Binary32(), at) && is_less(at, kOne);
  }

  // True if the end is at the centre, or on the side of it to which the line runs.
  bool is_ahead(const Place& place) const {
    return place.along.is_negative() == (-back_along_).is_negative();
  }

  // By the algorithm's version of the diamond-exit rule.
  bool draws_start(const Place& place) const {
    if (in_diamond(place)) return true;
    if (is_ahead(place)) return false;
    const bool away = frame_.x_major ? (-place.across).is_negative() != back_across_.is_negative()
                                     : place.across.is_negative() != (-back_across_).is_negative();
    return away || crosses_middle(place);
  }
  bool draws_end(const Place& place) const {
    if (in_diamond(place)) return false;
    if (!is_ahead(place)) return false;
    return (-place.across).is_negative() == back_across_.is_negative() || crosses_middle(place);
  }

  // True if the parallelogram contains the centre of the end's pixel.
  bool reaches_start(const Place& place) const {
    return (-place.along).is_negative() != back_along_.is_negative();
  }
  bool reaches_end(const Place& place) const { return is_ahead(place) || place.along.is_zero(); }

  // Moves an end along the line to the border of its pixel on the side from which the line comes.
  Pair moved(Pair end, const Place& place) const {
    const Binary32 by = (back_along_.is_negative() ? -kHalf : kHalf) - place.along;
    const Pair distance = frame_.pair(by, by * slope_);
    return {end.x + distance.x, end.y + distance.y};
  }

  Pair start_;
  Pair end_;
  Frame frame_;
  Binary32 back_along_;  // from the end to the start
  Binary32 back_across_;
  Binary32 slope_;  // across, for one along
};

// Steps of the grid from the centre of pixel 0, ties away from zero.
std::int64_t snapped(Binary32 value) {
  const Binary32 steps = Binary32::from_integer(kGrid) * value;
  return (steps.is_negative() ? steps - kHalf : steps + kHalf).truncate();
}

struct Corner {
  std::int64_t x;
  std::int64_t y;
};

}  // namespace

std::vector<PixelPosition> tested_ends_pixels(const Segment& segment, int width,
                                              const PixelBounds& bounds, const TieRule& ties) {
  if (segment.a == segment.b) return {};
  const auto pair_of = [](Point p) {
    return Pair{Binary32::from_fixed(p.x), Binary32::from_fixed(p.y)};
  };
  const TestedLine line(pair_of(segment.a), pair_of(segment.b));
  const auto [start, end] = line.moved_ends();
  // Ends are snapped, not corners: a tie goes away from zero on either side of the line.
  const std::int64_t half_width = width * kGrid / 2;
  const auto corner = [&](Pair p, std::int64_t across) {
    const std::int64_t x = snapped(p.x - kHalf), y = snapped(p.y - kHalf);
    return line.frame().x_major ? Corner{x, y + across} : Corner{x + across, y};
  };
  const std::array<Corner, 4> corners{corner(start, -half_width), corner(end, -half_width),
                                      corner(end, half_width), corner(start, half_width)};
  // The corners are counter-clockwise if the line runs along. If the ends have moved past each
  // other, the order is reversed and the inside is behind every side: nothing is drawn.
  const std::int64_t turn = line.runs_along() ? 1 : -1;
  // Ends move along the line by at most a pixel. Rounding to the grid moves them sideways by less
  // than the other half of the width, which the search includes.
  std::vector<PixelPosition> pixels =
      pixels_centred_near_line(segment, Fixed::from_integer(width), 1, bounds);
  std::erase_if(pixels, [&](PixelPosition pixel) {
    const Corner sample{std::int64_t{pixel.x} * kGrid, std::int64_t{pixel.y} * kGrid};
    for (std::size_t i = 0; i < 4; ++i) {
      const Corner& a = corners[i];
      const Corner& b = corners[(i + 1) % 4];
      const std::int64_t dx = turn * (b.x - a.x), dy = turn * (b.y - a.y);
      const std::int64_t side = dx * (sample.y - a.y) - dy * (sample.x - a.x);
      if (!ties.positive(side, -dy, dx)) return true;
    }
    return false;
  });
  return pixels;
}

}  // namespace edgecase
