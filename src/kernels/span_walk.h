// SPDX-License-Identifier: MIT
//
// Large triangles as spans: the first and the last pixel of each row, without testing pixels.
//
// On row y an edge function e + right x that grows to the right is >= 0 from x = -floor(e / right)
// on; one that falls is >= 0 up to x = floor(e / -right). From row to row e grows by `up`, so the
// quotient is kept with its remainder and both are incremented: a digital differential analyser
// that never rounds. A horizontal edge either owns the samples of its row or shortens the box by a
// row. The cost is two divisions per edge and three additions per edge and row, whatever the width.
#pragma once

#include <array>
#include <cstdint>

#include "kernels/edge_functions.h"

namespace edgecase {

// floor(e / divisor), row by row. Functions are less than 2^46 (edge_functions.h), so their
// quotients fit, even one step beyond the last row.
class Border {
 public:
  // A column beyond every pixel of the window.
  static constexpr std::int64_t kFar = std::int64_t{1} << 20;

  constexpr Border() = default;
  constexpr Border(const EdgeFunction& edge, std::int64_t y)
      : divisor_(edge.right < 0 ? -edge.right : edge.right) {
    divide(edge.at(0, y), column_, rest_);
    divide(edge.up, step_, step_rest_);
  }

  constexpr std::int64_t column() const { return column_; }
  constexpr void go_up() {
    column_ += step_;
    rest_ += step_rest_;
    // This avoids a branch: which rows carry is practically random.
    const std::int64_t carry = rest_ >= divisor_ ? 1 : 0;
    rest_ -= divisor_ & -carry;
    column_ += carry;
  }

 private:
  constexpr void divide(std::int64_t value, std::int64_t& quotient, std::int64_t& rest) const {
    quotient = value / divisor_;
    rest = value % divisor_;
    if (rest < 0) {
      rest += divisor_;
      --quotient;
    }
  }

  std::int64_t column_ = kFar;
  std::int64_t rest_ = 0;
  std::int64_t divisor_ = 1;
  std::int64_t step_ = 0;
  std::int64_t step_rest_ = 0;
};

// Calls sink(y, first, last), both ends inclusive, for each row of the triangle with pixels in the
// box, from the bottom. The box lies within the triangle's own box and the window.
template <class Sink>
inline void walk_spans(const std::array<EdgeFunction, 3>& edges, PixelBounds box, Sink&& sink) {
  // The third border, if there is one, shares a side with the left or the right border.
  Border left, right, third;
  bool has_left = false, has_right = false, third_is_left = false;
  for (const EdgeFunction& edge : edges) {
    if (edge.right != 0) continue;
    if (edge.at(0, box.y_min) < 0) ++box.y_min;
    if (edge.at(0, box.y_max) < 0) --box.y_max;
  }
  if (box.y_min > box.y_max) return;
  for (const EdgeFunction& edge : edges) {
    if (edge.right == 0) continue;
    const bool is_left = edge.right > 0;
    bool& has_side = is_left ? has_left : has_right;
    Border& border = has_side ? third : is_left ? left : right;
    if (has_side) third_is_left = is_left;
    border = Border(edge, box.y_min);
    has_side = true;
  }
  for (int y = box.y_min; y <= box.y_max; ++y) {
    const std::int64_t other = third.column();
    const std::int64_t more_left = third_is_left ? -other : -Border::kFar;
    const std::int64_t less_right = third_is_left ? Border::kFar : other;
    const std::int64_t first = std::max({-left.column(), more_left, std::int64_t{box.x_min}});
    const std::int64_t last = std::min({right.column(), less_right, std::int64_t{box.x_max}});
    if (first <= last) sink(y, static_cast<int>(first), static_cast<int>(last));
    left.go_up();
    right.go_up();
    third.go_up();
  }
}

}  // namespace edgecase
