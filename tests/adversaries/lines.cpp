// SPDX-License-Identifier: MIT
//
// Lines without multisampling (GL 4.6 core, 14.5.1 and 14.5.2.2).
#include <algorithm>
#include <array>
#include <cmath>

#include "exact/fixed.h"
#include "tests/adversaries/shape.h"

namespace edgecase::adversary {
namespace {

using Wide = Int128;
using Number = std::array<Wide, 3>;  // a + b e + c e^2

std::int64_t centre(int pixel) {
  return pixel * kPixel + kPixel / 2;
}

}  // namespace

// The segment meets the open diamond and does not end in it; both ends are moved against the ties.
bool Shaper::exits_diamond(Place a, Place b, Place at) const {
  struct Part {
    Number n;
    Wide of;
  };
  const auto less = [](const Part& p, const Part& q) {
    const auto times = [](const Number& n, Wide k) { return Number{n[0] * k, n[1] * k, n[2] * k}; };
    return times(p.n, q.of) < times(q.n, p.of);
  };
  // The rule itself moves both ends by -(e, e^2), and what it is relaxed to is held against that.
  const auto& f = freedoms_;
  const bool to_the_letter = f.line != LineWay::diamond_exit || !f.crime.empty();
  const int tie_x = to_the_letter ? 1 : f.tie_x, tie_y = to_the_letter ? 1 : f.tie_y;
  const bool y_first = f.tie_y_first && !to_the_letter;
  Part enter = {{0, -1, 0}, 1}, leave = {{1, 1, 0}, 1};
  bool ends_inside = true;
  for (const auto& [sx, sy] : {std::array{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
    const Wide first = y_first ? sy * tie_y : sx * tie_x;
    const Wide second = y_first ? sx * tie_x : sy * tie_y;
    const Wide at_a = sx * (a.x - at.x) + sy * (a.y - at.y) - kPixel / 2;
    const Wide at_b = sx * (b.x - at.x) + sy * (b.y - at.y) - kPixel / 2;
    const Wide slope = at_b - at_a, sign = slope < 0 ? -1 : 1;
    const Part crossing = {{-at_a * sign, first * sign, second * sign}, slope * sign};
    if (Number{at_b, -first, -second} >= Number{}) ends_inside = false;
    if (slope == 0 && Number{at_a, -first, -second} >= Number{}) return false;
    if (slope > 0 && less(crossing, leave)) leave = crossing;
    if (slope < 0 && less(enter, crossing)) enter = crossing;
  }
  const Part start = {Number{}, 1}, end = {{1, 0, 0}, 1};
  return !ends_inside && less(enter, leave) && less(enter, end) && less(start, leave);
}

std::vector<LinePixel> Shaper::line_pixels(const Shape& shape) const {
  if (shape.pieces.empty()) return {};
  const auto& f = freedoms_;
  Place a = shape.pieces[0].corners[0].place, b = shape.pieces[0].corners[1].place;
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
  const bool x_major = std::abs(dx) >= std::abs(dy);
  const std::int64_t raw = shape.draw->line_width.raw();
  std::int64_t width = (raw + kPixel / 2 - (f.halves_down ? 1 : 0)) / kPixel;
  if (f.crime == "lines one wider" && raw > kPixel) ++width;
  width = std::max<std::int64_t>(width, 1);
  const std::int64_t shift = (width - 1) * kPixel / 2;
  (x_major ? a.y : a.x) -= shift;
  (x_major ? b.y : b.x) -= shift;

  // In the order of drawing, beyond the target by what may come back into it.
  const int margin = static_cast<int>(width) + 2;
  const PixelBounds seen = shape.bounds.grown(margin);
  const auto pixel = [](std::int64_t at) { return static_cast<int>(at >> 16); };
  const PixelBounds box =
      common_part(seen, {pixel(std::min(a.x, b.x)) - 1, pixel(std::min(a.y, b.y)) - 1,
                         pixel(std::max(a.x, b.x)) + 1, pixel(std::max(a.y, b.y)) + 1});
  std::vector<PixelPosition> lowest;
  const Wide reach = Wide{kPixel} * std::max(std::abs(dx), std::abs(dy));
  for (int y = box.y_min; y <= box.y_max; ++y) {
    for (int x = box.x_min; x <= box.x_max; ++x) {
      const Place at{centre(x), centre(y)};
      const Wide off = Wide{dx} * (at.y - a.y) - Wide{dy} * (at.x - a.x);
      if (off > reach || off < -reach || !exits_diamond(a, b, at)) continue;
      lowest.push_back({x, y});
    }
  }
  const int ahead_x = x_major ? (dx < 0 ? -1 : 1) : 0, ahead_y = x_major ? 0 : (dy < 0 ? -1 : 1);
  std::stable_sort(lowest.begin(), lowest.end(), [&](PixelPosition p, PixelPosition q) {
    return p.x * ahead_x + p.y * ahead_y < q.x * ahead_x + q.y * ahead_y;
  });
  const auto drop = [&](std::size_t which) {
    lowest.erase(lowest.begin() + static_cast<std::ptrdiff_t>(which));
  };
  const auto add = [&](int units) {
    const PixelPosition last = lowest.back();
    lowest.push_back({last.x + units * ahead_x, last.y + units * ahead_y});
  };
  const bool alone = is_alone(*shape.primitive);
  if (f.line == LineWay::moved)
    for (PixelPosition& p : lowest) p = {p.x + 1, p.y + 1};
  if (f.line == LineWay::sideways && alone)
    for (PixelPosition& p : lowest)
      if (((x_major ? p.x : p.y) & 1) != 0) --(x_major ? p.y : p.x);
  if (!lowest.empty() && alone) {
    if (f.line == LineWay::one_more) add(1);
    if (f.line == LineWay::one_fewer) drop(0);
    if (f.line == LineWay::gap && lowest.size() > 2) drop(lowest.size() / 2);
  }
  if (f.crime == "lines two units off")
    for (PixelPosition& p : lowest) (x_major ? p.y : p.x) += 2;
  if (f.crime == "lines two longer" && !lowest.empty()) add(1), add(1);
  if (f.crime == "lines two shorter" && lowest.size() > 3) drop(0), drop(0);
  if (f.crime == "two in a column" && !lowest.empty())
    lowest.push_back({lowest[0].x + ahead_y * ahead_y, lowest[0].y + ahead_x * ahead_x});
  if (f.crime == "joints with a gap" && !alone && lowest.size() > 1) drop(0);

  std::vector<LinePixel> drawn;
  for (const PixelPosition& low : lowest) {
    for (int i = 0; i < width; ++i) {
      const PixelPosition p =
          x_major ? PixelPosition{low.x, low.y + i} : PixelPosition{low.x + i, low.y};
      if (!shape.bounds.contains(p)) continue;
      Place valued{centre(p.x), centre(p.y)};
      // As the adjusted line has it at the lowest fragment.
      if (f.replicates_values) (x_major ? valued.y : valued.x) += shift - i * kPixel;
      drawn.push_back({p, valued});
    }
  }
  return drawn;
}

// Does no other line of the scene start or end where it does?
bool Shaper::is_alone(const ScenePrimitive& line) const {
  int ends = 0;
  for (const ScenePrimitive& other : primitives_)
    for (int i = 0; other.kind == PrimitiveKind::line && i < 2; ++i)
      for (int k = 0; k < 2; ++k) {
        const Vertex &p = *other.vertices[static_cast<std::size_t>(i)],
                     &q = *line.vertices[static_cast<std::size_t>(k)];
        if (p.clip ? p.clip == q.clip : !q.clip && p.position == q.position) ++ends;
      }
  return ends == 2;
}

}  // namespace edgecase::adversary
