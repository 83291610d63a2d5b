// SPDX-License-Identifier: MIT
#include "kernels/kernels.h"

#include <cstdint>
#include <utility>

#include "kernels/edge_functions.h"
#include "kernels/span_walk.h"

namespace edgecase {

std::vector<PixelPosition> walked_triangle_pixels(const Triangle& triangle,
                                                  const PixelBounds& bounds, const TieRule& ties) {
  std::vector<PixelPosition> pixels;
  const TriangleSetup setup(raw_point(triangle[0]), raw_point(triangle[1]), raw_point(triangle[2]),
                            weights_of(ties));
  const PixelBounds box = common_part(setup.box_at(kCentrePlace), bounds);
  if (!setup.has_area() || is_empty(box)) return pixels;
  walk_spans(setup.edges_at(kCentrePlace), box, [&](int y, int first, int last) {
    for (int x = first; x <= last; ++x) pixels.push_back({x, y});
  });
  return pixels;
}

bool walks_just(std::span<const PixelPosition> pixels, const Triangle& triangle,
                const PixelBounds& bounds, const TieRule& ties) {
  const TriangleSetup setup(raw_point(triangle[0]), raw_point(triangle[1]), raw_point(triangle[2]),
                            weights_of(ties));
  const PixelBounds box = common_part(setup.box_at(kCentrePlace), bounds);
  if (!setup.has_area() || is_empty(box)) return pixels.empty();
  // Sorted pixels equal a span if its first pixel, last pixel and count agree.
  std::size_t at = 0;
  bool is_same = true;
  walk_spans(setup.edges_at(kCentrePlace), box, [&](int y, int first, int last) {
    const auto count = static_cast<std::size_t>(last - first + 1);
    is_same = is_same && count <= pixels.size() - at && pixels[at] == PixelPosition{first, y} &&
              pixels[at + count - 1] == PixelPosition{last, y};
    if (is_same) at += count;
  });
  return is_same && at == pixels.size();
}

std::vector<PixelPosition> walked_tied_pixels(const Triangle& triangle, const PixelBounds& bounds) {
  struct Span {
    int y, first, last;
  };
  const auto spans_of = [&](std::int64_t owned) {
    std::vector<Span> spans;
    const TriangleSetup setup(raw_point(triangle[0]), raw_point(triangle[1]),
                              raw_point(triangle[2]), {0, 0, owned});
    const PixelBounds box = common_part(setup.box_at(kCentrePlace), bounds);
    if (!setup.has_area() || is_empty(box)) return spans;
    walk_spans(setup.edges_at(kCentrePlace), box, [&](int y, int first, int last) {
      spans.push_back({y, first, last});
    });
    return spans;
  };
  const std::vector<Span> open = spans_of(0);
  std::vector<PixelPosition> pixels;
  auto inner = open.begin();
  for (const Span& outer : spans_of(1)) {
    while (inner != open.end() && inner->y < outer.y) ++inner;
    const bool has_inner = inner != open.end() && inner->y == outer.y;
    for (int x = outer.first; x <= outer.last; ++x) {
      if (has_inner && x == inner->first) x = inner->last + 1;
      if (x <= outer.last) pixels.push_back({x, outer.y});
    }
  }
  return pixels;
}

namespace {

// Lines by the diamond-exit rule, one pixel per column: exact, at about one addition each.
//
// Let the segment be x-major; others are walked with their axes exchanged. The slope is at most 1.
// If the line meets a pixel's open diamond at a distance dx from the middle of the column, it moves
// by at most dx on the way there, so it passes less than half a pixel above or below the centre.
// Conversely, a point of the middle less than half a pixel from the centre lies in the diamond. So
// in each column the line meets the diamond of exactly one pixel, that of the row in which the line
// lies at the column's centre. The tie rule assigns a height on the border of two rows by its
// gradient.
//
// The ends matter only near themselves. In a column strictly between them the segment spans the
// diamond's whole width, and the end lies outside. In columns at the ends, at most two each, the
// rest of rules/coverage/diamond_exit.h is tested: whether the segment reaches the diamond's sides
// and whether its end lies within all four.
//
// The height is a quotient, kept with its remainder as in span_walk.h. The tie rule is one bit of
// its numerator, and the 16 bits that no step changes are dropped.
//
// Bounds: coordinates are at most 2^29 + 2^16 raw (edge_functions.h) and their differences 2^30 +
// 2^17, so the numerator is less than 2^61, and u and v are less than 2^31.

// A segment with its major axis first.
struct WalkedSegment {
  std::int64_t major_a, minor_a, major_b, minor_b;
  bool x_major;

  constexpr WalkedSegment(RawPoint a, RawPoint b)
      : major_a(a.x), minor_a(a.y), major_b(b.x), minor_b(b.y) {
    const std::int64_t width = major_b - major_a, height = minor_b - minor_a;
    x_major = (width < 0 ? -width : width) >= (height < 0 ? -height : height);
    if (x_major) return;
    std::swap(major_a, minor_a);
    std::swap(major_b, minor_b);
  }
};

// The test at the ends, in rotated coordinates u = major + minor and v = major - minor.
class DiamondEnds {
 public:
  constexpr DiamondEnds(const WalkedSegment& s, const TieWeights& ties)
      : u_a_(s.major_a + s.minor_a),
        v_a_(s.major_a - s.minor_a),
        u_b_(s.major_b + s.minor_b),
        v_b_(s.major_b - s.minor_b),
        owns_u_low_(ties.owns(-1, -1)),
        owns_u_high_(ties.owns(1, 1)),
        owns_v_low_(ties.owns(-1, 1)),
        owns_v_high_(ties.owns(1, -1)) {}

  // Whether the segment exits the diamond of a pixel; its line must meet that diamond.
  constexpr bool exits(std::int64_t column, std::int64_t row) const {
    const std::int64_t u = (column + row + 1) * Fixed::kOne;
    const std::int64_t v = (column - row) * Fixed::kOne;
    const auto [u_low, u_high] = std::minmax(u_a_, u_b_);
    const auto [v_low, v_high] = std::minmax(v_a_, v_b_);
    return is_inside({u_low - u, v_low - v}, {u_high - u, v_high - v}) &&
           !is_inside({u_b_ - u, v_b_ - v}, {u_b_ - u, v_b_ - v});
  }

 private:
  struct Rotated {
    std::int64_t u;
    std::int64_t v;
  };

  // Relative to the centre: is `high` beyond its lower sides and `low` before its upper ones?
  constexpr bool is_inside(Rotated low, Rotated high) const {
    constexpr std::int64_t kRadius = Fixed::kOne / 2;
    return high.u + kRadius + owns_u_low_ > 0 && kRadius - low.u + owns_u_high_ > 0 &&
           high.v + kRadius + owns_v_low_ > 0 && kRadius - low.v + owns_v_high_ > 0;
  }

  std::int64_t u_a_, v_a_, u_b_, v_b_;
  int owns_u_low_, owns_u_high_, owns_v_low_, owns_v_high_;
};

// The rows of a line's columns, from left to right.
class LineHeight {
 public:
  constexpr LineHeight(const WalkedSegment& s, const TieWeights& ties, std::int64_t column) {
    std::int64_t rise = s.minor_b - s.minor_a;
    run_ = s.major_b - s.major_a;
    if (run_ < 0) {
      run_ = -run_;
      rise = -rise;
    }
    // A whole height lies on the upper border of the row below, from which the distance grows along
    // (-rise, run). If that row owns it, the height counts as slightly less.
    const std::int64_t tie = ties.owns(-rise, run_) ? 1 : 0;
    const std::int64_t along = column * Fixed::kOne + Fixed::kOne / 2 - s.major_a;
    const std::int64_t height = (s.minor_a * run_ + along * rise - tie) >> Fixed::kFractionBits;
    row_ = height / run_;
    rest_ = height % run_;
    if (rest_ < 0) {
      rest_ += run_;
      --row_;
    }
    // |rise| <= run
    step_ = rise < 0 ? -1 : rise == run_ ? 1 : 0;
    step_rest_ = rise - step_ * run_;
  }

  constexpr std::int64_t row() const { return row_; }
  constexpr void go_right() {
    row_ += step_;
    rest_ += step_rest_;
    const std::int64_t carry = rest_ >= run_ ? 1 : 0;
    rest_ -= run_ & -carry;
    row_ += carry;
  }

 private:
  std::int64_t run_ = 0;
  std::int64_t row_ = 0;
  std::int64_t rest_ = 0;
  std::int64_t step_ = 0;
  std::int64_t step_rest_ = 0;
};

// Calls sink(x, y) for each pixel within the bounds, which lie within the window, that a line of
// width 1 covers, ascending along its major axis. The tie rule must be a perturbed one: the other
// two do not assign a height between two rows.
template <class Sink>
inline void walk_line(RawPoint a, RawPoint b, const TieWeights& rule, const PixelBounds& bounds,
                      Sink&& sink) {
  const WalkedSegment s(a, b);
  if (s.major_a == s.major_b) return;
  const TieWeights ties = s.x_major ? rule : TieWeights{rule.up, rule.right, 0};
  const auto [low, high] = std::minmax(s.major_a, s.major_b);
  const auto floor = [](std::int64_t raw) { return raw >> Fixed::kFractionBits; };
  const auto ceil = [](std::int64_t raw) { return -(-raw >> Fixed::kFractionBits); };
  const std::int64_t first_within = floor(low) + 1, last_within = ceil(high) - 2;
  const std::int64_t first =
      std::max<std::int64_t>(ceil(low) - 1, s.x_major ? bounds.x_min : bounds.y_min);
  const std::int64_t last =
      std::min<std::int64_t>(floor(high), s.x_major ? bounds.x_max : bounds.y_max);
  if (first > last) return;
  const std::int64_t bottom = s.x_major ? bounds.y_min : bounds.x_min;
  const std::int64_t top = s.x_major ? bounds.y_max : bounds.x_max;
  const DiamondEnds ends(s, ties);
  LineHeight height(s, ties, first);
  for (std::int64_t column = first; column <= last; ++column, height.go_right()) {
    const std::int64_t row = height.row();
    if (row < bottom || row > top) continue;
    const bool is_within = column >= first_within && column <= last_within;
    if (!is_within && !ends.exits(column, row)) continue;
    const auto major = static_cast<int>(column), minor = static_cast<int>(row);
    s.x_major ? sink(major, minor) : sink(minor, major);
  }
}

}  // namespace

std::vector<PixelPosition> walked_line_pixels(const Segment& segment, const PixelBounds& bounds,
                                              const TieRule& ties) {
  std::vector<PixelPosition> pixels;
  walk_line(raw_point(segment.a), raw_point(segment.b), weights_of(ties), bounds,
            [&](int x, int y) {
              pixels.push_back({x, y});
            });
  return pixels;
}

void fill_lines(const FillTarget& target, std::span<const FlatLine> lines, const TieWeights& ties) {
  const PixelPlane plane = target.planes[0];
  for (const FlatLine& line : lines)
    walk_line(line.a, line.b, ties, target.bounds,
              [&](int x, int y) { plane.row(y)[x] = line.color; });
}

}  // namespace edgecase
