// SPDX-License-Identifier: MIT
#include "casefile/mesh/triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "exact/rational.h"

namespace edgecase {

namespace {

using Triangle = std::array<std::size_t, 3>;
using Triangles = std::vector<Triangle>;

// A corner, along the two axes that are seen.
struct Corner {
  double x = 0;
  double y = 0;
  friend bool operator==(const Corner&, const Corner&) = default;
};

int sign_of(const Rational& value) {
  return value.sign();
}

// Twice the area of a triangle, positive if it runs counterclockwise.
template <class Number>
Number doubled_area(const Number& ax, const Number& ay, const Number& bx, const Number& by,
                    const Number& cx, const Number& cy) {
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

// 1 if c lies to the left of a -> b, -1 if to the right, 0 on the line. Doubles decide where their
// rounding cannot: three roundings in each product, and one of the difference.
int side_of(const Corner& a, const Corner& b, const Corner& c) {
  const double left = (b.x - a.x) * (c.y - a.y);
  const double right = (b.y - a.y) * (c.x - a.x);
  constexpr double kRounding = 0x1p-50;
  const double area = left - right;
  if (std::fabs(area) > kRounding * (std::fabs(left) + std::fabs(right))) return area > 0 ? 1 : -1;
  const auto exact = [](double value) { return rational_of(value); };
  return sign_of(
      doubled_area(exact(a.x), exact(a.y), exact(b.x), exact(b.y), exact(c.x), exact(c.y)));
}

// The same of a polygon's area. Each of up to 255 corners adds a rounding.
int turn_of(const std::vector<Corner>& corners) {
  const Corner& a = corners[0];
  double area = 0, size = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Corner &b = corners[i - 1], &c = corners[i];
    area += doubled_area(a.x, a.y, b.x, b.y, c.x, c.y);
    size += std::fabs((b.x - a.x) * (c.y - a.y)) + std::fabs((b.y - a.y) * (c.x - a.x));
  }
  if (std::fabs(area) > 0x1p-43 * size) return area > 0 ? 1 : -1;
  Rational sum = 0;
  const Rational x = rational_of(a.x), y = rational_of(a.y);
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += doubled_area(x, y, rational_of(corners[i - 1].x), rational_of(corners[i - 1].y),
                        rational_of(corners[i].x), rational_of(corners[i].y));
  return sign_of(sum);
}

// The axis along which a polygon is seen: that of the largest part of its normal, roughly; where
// parts of it cancel each other out, that of the largest of them.
std::size_t axis_of(std::span<const Vector> corners) {
  std::array<std::pair<double, double>, 3> normal{};  // the sum, and that of magnitudes
  const auto from_first = [&](std::size_t i, std::size_t axis) {
    return static_cast<double>(corners[i][axis]) - static_cast<double>(corners[0][axis]);
  };
  for (std::size_t i = 2; i < corners.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      const double part =
          from_first(i - 1, u) * from_first(i, v) - from_first(i - 1, v) * from_first(i, u);
      normal[axis].first += part;
      normal[axis].second += std::fabs(part);
    }
  for (auto& [sum, size] : normal) sum = std::fabs(sum);
  return static_cast<std::size_t>(std::ranges::max_element(normal) - normal.begin());
}

// The corners as seen, counterclockwise unless the polygon has no area.
std::vector<Corner> seen_corners(std::span<const Vector> corners) {
  const std::size_t axis = axis_of(corners);
  std::vector<Corner> seen;
  for (const Vector& corner : corners)
    seen.push_back(
        {static_cast<double>(corner[(axis + 1) % 3]), static_cast<double>(corner[(axis + 2) % 3])});
  if (turn_of(seen) < 0)
    for (Corner& corner : seen) std::swap(corner.x, corner.y);
  return seen;
}

bool do_cross(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

bool crosses_itself(const std::vector<Corner>& corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 2; j < count; ++j)
      if (do_cross(corners[i], corners[i + 1], corners[j], corners[(j + 1) % count])) return true;
  return false;
}

// Squares of lengths, in float32: ties and near ties are cut as other readers of OBJ files cut
// them.
bool is_shorter(std::span<const Vector> corners, std::size_t from, std::size_t to,
                std::size_t other_from, std::size_t other_to) {
  const auto square = [&](std::size_t a, std::size_t b) {
    float sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float difference = corners[b][axis] - corners[a][axis];
      sum += difference * difference;
    }
    return sum;
  };
  return square(from, to) < square(other_from, other_to);
}

Triangles cut_four(std::span<const Vector> given, const std::vector<Corner>& corners) {
  // How often a diagonal's triangles have an area, or -1 if one is turned.
  const auto worth = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    const int one = side_of(corners[a], corners[b], corners[c]);
    const int other = side_of(corners[a], corners[c], corners[d]);
    return one < 0 || other < 0 ? -1 : one + other;
  };
  const int first = worth(0, 1, 2, 3);
  const int second = worth(1, 2, 3, 0);
  if (first < 0 && second < 0) return {};
  if (first > second || (first == second && is_shorter(given, 0, 2, 1, 3)))
    return {{0, 1, 2}, {0, 2, 3}};
  return {{0, 1, 3}, {1, 2, 3}};
}

// What is left of a polygon while its ears are cut.
class Ears {
 public:
  explicit Ears(const std::vector<Corner>& corners) : corners_(corners) {
    left_.resize(corners.size());
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }

  Triangles cut() {
    Triangles triangles;
    std::size_t at = 0;
    while (left_.size() > 3) {
      const std::size_t ear = find(at);
      if (ear == left_.size()) return {};
      triangles.push_back({left_[before(ear)], left_[ear], left_[after(ear)]});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
      // The one behind, so that triangles do not all meet in one corner.
      at = ear % left_.size();
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  std::size_t before(std::size_t i) const { return (i + left_.size() - 1) % left_.size(); }
  std::size_t after(std::size_t i) const { return (i + 1) % left_.size(); }
  const Corner& corner(std::size_t i) const { return corners_[left_[i]]; }

  // The first ear from `from` on; if there is none, a corner that takes no area with it.
  std::size_t find(std::size_t from) const {
    const std::size_t count = left_.size();
    for (std::size_t k = 0; k < count; ++k)
      if (is_ear((from + k) % count)) return (from + k) % count;
    for (std::size_t k = 0; k < count; ++k)
      if (turn_at((from + k) % count) == 0) return (from + k) % count;
    return count;
  }

  int turn_at(std::size_t i) const {
    return side_of(corner(before(i)), corner(i), corner(after(i)));
  }

  // Whether a line from corner i to a place starts inside.
  bool leads_inside(std::size_t i, const Corner& to) const {
    const bool is_left_of_next = side_of(corner(i), corner(after(i)), to) >= 0;
    const bool is_left_of_last = side_of(corner(before(i)), corner(i), to) >= 0;
    return turn_at(i) >= 0 ? is_left_of_next && is_left_of_last
                           : is_left_of_next || is_left_of_last;
  }

  bool is_ear(std::size_t i) const {
    if (turn_at(i) <= 0) return false;
    const Corner &a = corner(before(i)), &b = corner(i), &c = corner(after(i));
    if (!leads_inside(before(i), c) || !leads_inside(after(i), a)) return false;
    return std::ranges::none_of(left_, [&](std::size_t other) {
      const Corner& p = corners_[other];
      return p != a && p != b && p != c && side_of(a, b, p) >= 0 && side_of(b, c, p) >= 0 &&
             side_of(c, a, p) >= 0;
    });
  }

  const std::vector<Corner>& corners_;
  std::vector<std::size_t> left_;  // numbers of corners
};

}  // namespace

std::vector<std::array<std::size_t, 3>> triangles_of(std::span<const Vector> corners) {
  if (corners.size() == 3) return {{0, 1, 2}};
  const std::vector<Corner> seen = seen_corners(corners);
  if (corners.size() == 4) return cut_four(corners, seen);
  return crosses_itself(seen) ? Triangles{} : Ears(seen).cut();
}

}  // namespace edgecase
