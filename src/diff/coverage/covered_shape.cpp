// SPDX-License-Identifier: MIT
#include "diff/coverage/covered_shape.h"

#include <cstddef>
#include <cstdint>

namespace edgecase {
namespace {

// A point of the hull's border: a column by its row.
struct Corner {
  std::int64_t row = 0;
  std::int64_t column = 0;
};

// Above 0 if c lies to the right of the line a-b, seen along rising rows.
std::int64_t rightward(const Corner& a, const Corner& b, const Corner& c) {
  return (c.column - a.column) * (b.row - a.row) - (b.column - a.column) * (c.row - a.row);
}

// The corners of the hull's left border, by row: of points with at most one in a row, in order.
void add_to_left_border(std::vector<Corner>& border, Corner corner) {
  while (border.size() >= 2 && rightward(border[border.size() - 2], border.back(), corner) <= 0)
    border.pop_back();
  border.push_back(corner);
}

// Calls `visit` with the row, the least whole column that is not left of the border, and whether
// the border passes through it, row by row.
template <class Visit>
void for_each_column(std::span<const Corner> border, const Visit& visit) {
  visit(border.front().row, border.front().column, true);
  for (std::size_t i = 1; i < border.size(); ++i) {
    const Corner& from = border[i - 1];
    const Corner& to = border[i];
    for (std::int64_t row = from.row + 1; row <= to.row; ++row) {
      const std::int64_t dividend = (to.column - from.column) * (row - from.row);
      const std::int64_t divisor = to.row - from.row;
      const std::int64_t rest = dividend % divisor;
      visit(row, from.column + dividend / divisor + (rest > 0 ? 1 : 0), rest == 0);
    }
  }
}

}  // namespace

// The right border is the left one of the mirrored pixels.
PixelHull::PixelHull(std::span<const PixelPosition> pixels) {
  if (pixels.empty()) return;
  first_row_ = pixels.front().y;
  rows_.resize(static_cast<std::size_t>(pixels.back().y - first_row_) + 1);
  std::vector<Corner> left;
  std::vector<Corner> right;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto [x, y] = pixels[i];
    if (i == 0 || pixels[i - 1].y != y) add_to_left_border(left, {y, x});
    if (i + 1 == pixels.size() || pixels[i + 1].y != y) add_to_left_border(right, {y, -x});
  }
  const auto columns_of = [&](std::int64_t row) -> Columns& {
    return rows_[static_cast<std::size_t>(row - first_row_)];
  };
  for_each_column(left, [&](std::int64_t row, std::int64_t column, bool is_on_border) {
    columns_of(row).first = static_cast<int>(column);
    columns_of(row).is_first_on_border = is_on_border;
  });
  for_each_column(right, [&](std::int64_t row, std::int64_t column, bool is_on_border) {
    columns_of(row).last = static_cast<int>(-column);
    columns_of(row).is_last_on_border = is_on_border;
  });
}

bool PixelHull::contains(PixelPosition pixel) const {
  const std::int64_t row = std::int64_t{pixel.y} - first_row_;
  if (row < 0 || row >= static_cast<std::int64_t>(rows_.size())) return false;
  const Columns& columns = rows_[static_cast<std::size_t>(row)];
  return columns.first <= pixel.x && pixel.x <= columns.last;
}

std::vector<Hole> holes_in(std::span<const PixelPosition> pixels) {
  const PixelHull hull(pixels);
  std::vector<Hole> holes;
  std::size_t next = 0;
  for (std::size_t row = 0; row < hull.rows().size(); ++row) {
    const int y = hull.first_row() + static_cast<int>(row);
    const bool is_outer = row == 0 || row + 1 == hull.rows().size();
    const PixelHull::Columns& columns = hull.rows()[row];
    for (int x = columns.first; x <= columns.last; ++x) {
      const PixelPosition pixel{x, y};
      const bool is_covered = next < pixels.size() && pixels[next] == pixel;
      const bool is_on_border = is_outer || (x == columns.first && columns.is_first_on_border) ||
                                (x == columns.last && columns.is_last_on_border);
      if (!is_covered) holes.push_back({pixel, is_on_border});
      while (next < pixels.size() && pixels[next] == pixel) ++next;
    }
  }
  return holes;
}

}  // namespace edgecase
