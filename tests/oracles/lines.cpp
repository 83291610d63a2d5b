// SPDX-License-Identifier: MIT
#include "tests/oracles/lines.h"

#include <algorithm>

namespace edgecase::oracle {
namespace {

const Rational kHalf(1, 2);

// A line and a pixel with the major axis first.
struct AlongMajor {
  Spot a;
  Spot b;
  int column;
  int row;
};

AlongMajor along_major(const Line& line, PixelPosition p) {
  if (is_x_major(line)) return {line.a, line.b, p.x, p.y};
  return {{line.a.y, line.a.x}, {line.b.y, line.b.x}, p.y, p.x};
}

// The line's minor coordinate at the centre of the column.
Rational height_at_centre(const AlongMajor& m) {
  if (m.a.x == m.b.x) return m.a.y;
  return m.a.y + (Rational(2 * m.column + 1, 2) - m.a.x) * (m.b.y - m.a.y) / (m.b.x - m.a.x);
}

bool takes_part(const AlongMajor& m, LineAlgorithm algorithm) {
  const Rational centre(2 * m.column + 1, 2);
  const Rational low = std::min(m.a.x, m.b.x);
  const Rational high = std::max(m.a.x, m.b.x);
  if (algorithm == LineAlgorithm::walk_half_open_geometry) return low <= centre && centre < high;
  if (algorithm == LineAlgorithm::walk_half_open_direction)
    return low <= centre && centre <= high && !(centre == m.b.x);
  return low.floor() <= m.column && m.column <= high.floor();
}

bool is_end_column(const AlongMajor& m) {
  return m.column == m.a.x.floor() || m.column == m.b.x.floor();
}

bool walk_covers(const LineQuestion& q, PixelPosition p) {
  const AlongMajor m = along_major(q.line, p);
  if (!takes_part(m, q.algorithm)) return false;
  const Rational height = height_at_centre(m);
  if (height < Rational(m.row) || height >= Rational(m.row + 1)) return false;
  return q.algorithm != LineAlgorithm::walk_ends_tested || !is_end_column(m) ||
         exits_diamond(q.line, q.boundary, p.x, p.y);
}

int toward_zero(const Rational& value) {
  return static_cast<int>(value.sign() < 0 ? -(-value).floor() : value.floor());
}

// The ends' pixels, seen along the major axis in steps from the start.
struct IntegerLine {
  int x, y;            // the start's pixel, major axis first
  int run, rise;       // steps to the end's, not negative
  int x_step, y_step;  // direction
  int column, row;     // the pixel asked about, in steps from the start
};

IntegerLine integer_line(PixelPosition a, PixelPosition b, bool x_major, PixelPosition p) {
  if (!x_major) {
    std::swap(a.x, a.y);
    std::swap(b.x, b.y);
    std::swap(p.x, p.y);
  }
  const int x_step = b.x < a.x ? -1 : 1;
  const int y_step = b.y < a.y ? -1 : 1;
  return {a.x,    a.y,    x_step * (b.x - a.x), y_step * (b.y - a.y),
          x_step, y_step, x_step * (p.x - a.x), y_step * (p.y - a.y)};
}

IntegerLine bresenham_line(const LineQuestion& q, PixelPosition p) {
  const auto whole = [&](const Rational& value) {
    return q.algorithm == LineAlgorithm::bresenham ? static_cast<int>(value.floor())
                                                   : toward_zero(value);
  };
  const PixelPosition a{whole(q.line.a.x), whole(q.line.a.y)};
  const PixelPosition b{whole(q.line.b.x), whole(q.line.b.y)};
  return integer_line(a, b, std::abs(b.x - a.x) > std::abs(b.y - a.y), p);
}

IntegerLine midpoint_line(const LineQuestion& q, PixelPosition p) {
  const auto whole = [](const Spot& s) {
    return PixelPosition{static_cast<int>(s.x.floor()), static_cast<int>(s.y.floor())};
  };
  PixelPosition a = whole(q.line.a);
  PixelPosition b = whole(q.line.b);
  const bool x_major = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  if (x_major ? b.x < a.x : b.y < a.y) std::swap(a, b);
  return integer_line(a, b, x_major, p);
}

// Nearest to the line at its column; midway, the pixel that is a step on.
bool bresenham_covers(const IntegerLine& l) {
  return l.column >= 0 && l.column < l.run &&
         l.row == (Rational(l.column) * l.rise / l.run + kHalf).floor();
}

// Nearest to the line at its column; midway, the pixel that is not a step on.
bool midpoint_covers(const IntegerLine& l) {
  if (l.column < 0 || l.column > l.run) return false;
  if (l.run == 0) return l.row == 0;
  return l.row == -(kHalf - Rational(l.column) * l.rise / l.run).floor();
}

bool is_midway(const IntegerLine& l) {
  return l.column >= 0 && l.column < l.run &&
         (Rational(l.column) * l.rise / l.run + kHalf).is_whole();
}

bool area_covers(const LineQuestion& q, bool rectangle, PixelPosition p) {
  const Place sample = moved(centre_of_pixel(p.x, p.y), q.ties.move);
  return q.ties.accept(rectangle ? where_in_rectangle(q.line, q.width, sample)
                                 : where_in_parallelogram(q.line, q.width, sample));
}

bool thin_covers(const LineQuestion& q, PixelPosition p) {
  switch (q.algorithm) {
    case LineAlgorithm::diamond_exit:
      return exits_diamond(q.line, q.boundary, p.x, p.y);
    case LineAlgorithm::bresenham:
    case LineAlgorithm::bresenham_toward_zero:
      return bresenham_covers(bresenham_line(q, p));
    case LineAlgorithm::midpoint:
      return midpoint_covers(midpoint_line(q, p));
    case LineAlgorithm::rectangle:
    case LineAlgorithm::parallelogram:
      return area_covers(q, q.algorithm == LineAlgorithm::rectangle, p);
    default:
      return walk_covers(q, p);
  }
}

// "Rounding the supplied width to the nearest integer", at least 1.
int whole_width(const Rational& width) {
  int best = 1;
  for (int candidate = 2; candidate <= 64; ++candidate)
    if (magnitude(width - candidate) <= magnitude(width - best)) best = candidate;
  return best;
}

// GL 4.6 core, 14.5.2: the line is moved by -(w - 1)/2 along the minor axis, and each of its
// fragments becomes a column (row) of w.
bool replicated_covers(const LineQuestion& q, PixelPosition p) {
  const bool x_major = is_x_major(q.line);
  const int width = whole_width(q.width);
  const Rational down = Rational(width - 1, 2);
  LineQuestion thin = q;
  thin.width = 1;
  for (Spot* end : {&thin.line.a, &thin.line.b})
    (x_major ? end->y : end->x) = (x_major ? end->y : end->x) - down;
  for (int i = 0; i < width; ++i)
    if (thin_covers(thin, x_major ? PixelPosition{p.x, p.y - i} : PixelPosition{p.x - i, p.y}))
      return true;
  return false;
}

bool covers(const LineQuestion& q, PixelPosition p) {
  if (q.width == Rational(1)) return thin_covers(q, p);
  if (q.wide == WideLine::replicate) return replicated_covers(q, p);
  return area_covers(q, q.wide == WideLine::rectangle, p);
}

}  // namespace

int where_in_rectangle(const Line& line, const Rational& width, const Place& sample) {
  const Rational dx = line.b.x - line.a.x;
  const Rational dy = line.b.y - line.a.y;
  const Rational squared_length = dx * dx + dy * dy;
  if (squared_length.sign() == 0) return -1;
  const Nearby<2> x = sample.x - line.a.x;
  const Nearby<2> y = sample.y - line.a.y;
  const Nearby<2> along = x * dx + y * dy;
  const Nearby<2> across = y * dx - x * dy;
  // The distance from the line is across / length: compare squares.
  const auto rest = Nearby<4>(width * width * squared_length) - product(across, across) * 4;
  return std::min({along.sign(), (Nearby<2>(squared_length) - along).sign(), rest.sign()});
}

int where_in_parallelogram(const Line& line, const Rational& width, const Place& sample) {
  const bool x_major = is_x_major(line);
  const Spot a = x_major ? line.a : Spot{line.a.y, line.a.x};
  const Spot b = x_major ? line.b : Spot{line.b.y, line.b.x};
  const Place p = x_major ? sample : Place{sample.y, sample.x};
  if (a.x == b.x) return -1;
  const Nearby<2> t = (p.x - a.x) * (Rational(1) / (b.x - a.x));
  const Nearby<2> height = p.y - (Nearby<2>(a.y) + t * (b.y - a.y));
  return std::min(
      {t.sign(), (Nearby<2>(1) - t).sign(), (Nearby<2>(width * kHalf) - magnitude(height)).sign()});
}

std::vector<PixelPosition> line_pixels(const LineQuestion& question, const PixelBounds& window) {
  std::vector<PixelPosition> pixels;
  for (int x = window.x_min; x <= window.x_max; ++x)
    for (int y = window.y_min; y <= window.y_max; ++y)
      if (covers(question, {x, y})) pixels.push_back({x, y});
  return pixels;
}

bool hangs_on_convention(const LineQuestion& q, const PixelBounds& window) {
  for (int x = window.x_min; x <= window.x_max; ++x)
    for (int y = window.y_min; y <= window.y_max; ++y) {
      if (q.algorithm == LineAlgorithm::midpoint) {
        if (is_midway(midpoint_line(q, {x, y}))) return true;
      } else if (q.algorithm == LineAlgorithm::bresenham ||
                 q.algorithm == LineAlgorithm::bresenham_toward_zero) {
        if (is_midway(bresenham_line(q, {x, y}))) return true;
      } else {
        const AlongMajor m = along_major(q.line, {x, y});
        const Rational centre(2 * m.column + 1, 2);
        const bool half_open = q.algorithm == LineAlgorithm::walk_half_open_direction ||
                               q.algorithm == LineAlgorithm::walk_half_open_geometry;
        const Rational border = half_open ? centre : Rational(m.column);
        if (m.a.x == border || m.b.x == border) return true;
        if (takes_part(m, q.algorithm) && height_at_centre(m) == Rational(m.row)) return true;
      }
    }
  return false;
}

}  // namespace edgecase::oracle
