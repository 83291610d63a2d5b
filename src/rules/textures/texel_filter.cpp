// SPDX-License-Identifier: MIT
#include "rules/textures/texel_filter.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "rules/textures/directed.h"

namespace edgecase {
namespace {

// True if a coordinate that is `rest` of a step above step `below` moves up.
bool moves_up(double below, double rest, TexelGrid grid) {
  switch (grid) {
    case TexelGrid::none:
    case TexelGrid::floor_8:
      break;
    case TexelGrid::nearest_8:
      return rest >= 0.5;
    case TexelGrid::linear_even_8:
      return rest > 0.5 || (rest == 0.5 && std::fmod(below, 2) != 0);
  }
  return false;
}

double on_grid(double coordinate, TexelGrid grid) {
  constexpr double kSteps = 256;
  constexpr double kFar = 0x1p44;  // from here on every double is on the grid
  if (grid == TexelGrid::none || !(std::fabs(coordinate) < kFar)) return coordinate;
  const double steps = coordinate * kSteps;
  const double below = std::floor(steps);
  return (below + (moves_up(below, steps - below, grid) ? 1 : 0)) / kSteps;
}

// The grid in effect.
TexelGrid effective(TexelGrid grid, Filter filter, TextureFormat format) {
  const bool applies = grid != TexelGrid::linear_even_8 ||
                       (filter == Filter::linear && format == TextureFormat::rgba8);
  return applies ? grid : TexelGrid::none;
}

// One axis of the image for a lookup.
struct Axis {
  int size;
  Wrap wrap;  // the mode in effect
  TexelGrid grid;
  double slack;

  // All coordinates, in texels: from the centre of a texel to that of the one two images further,
  // where every wrap mode starts again.
  Interval everywhere() const { return {0.5, 2 * size + 0.5}; }
};

// The substitute for a coordinate that is NaN or infinite.
Interval defined(Interval s) {
  if (std::isnan(s.low) && std::isnan(s.high)) return 0;
  s = known(s);
  return s.low == s.high && std::isinf(s.low) ? Interval(0) : s;
}

// Moved by an even number of images; the range is less than two wide. If it reaches 4, both its
// ends are multiples of 2^-51, and so are the remainders, which are less than 4: nothing is
// rounded.
Interval brought_near(Interval s) {
  constexpr double kFar = 4;
  if (s.magnitude() < kFar) return s;
  const double images = 2 * std::floor(s.low / 2);
  return {s.low - images, s.high - images};
}

// A coordinate in texels, not far from the image. The high end is rounded down if whole texels or
// steps of a grid are needed: rounding a number down does not change the integer below it, while
// rounding it up may.
Interval in_texels(Interval s, const Axis& axis, bool whole) {
  s = defined(s);
  if (is_periodic(axis.wrap)) {
    if (s.high - s.low + 2 * axis.slack / axis.size >= 2) return axis.everywhere();
    s = brought_near(s);
  }
  Interval u{Down::product(s.low, axis.size),
             whole ? Down::product(s.high, axis.size) : Up::product(s.high, axis.size)};
  if (axis.slack > 0) u = u + Interval(-axis.slack, axis.slack);
  if (!is_periodic(axis.wrap)) {
    // Beyond a texel and a half from an edge there is only the edge or the border.
    const double last = axis.size + 1.5;
    u = {std::clamp(u.low, -1.5, last), std::clamp(u.high, -1.5, last)};
  }
  return on_grid(u, axis.grid);
}

constexpr int kBorder = -1;

// Two texels of an axis, or twice the same, and the weight of the second.
struct Cell {
  int first;
  int second;
  double least;
  double most;
  friend auto operator<=>(const Cell&, const Cell&) = default;
};
using Cells = boost::container::small_vector<Cell, 4>;

// A texel by itself.
Cell lone_cell(int texel) {
  return {texel, texel, 0, 0};
}

int texel_at(std::int64_t texel, const Axis& axis) {
  return wrapped(texel, axis.size, axis.wrap, WrapChoice::as_set).value_or(kBorder);
}

void add_nearest(Interval u, const Axis& axis, Cells& cells) {
  const auto last = static_cast<std::int64_t>(std::floor(u.high));
  for (auto texel = static_cast<std::int64_t>(std::floor(u.low)); texel <= last; ++texel)
    cells.push_back(lone_cell(texel_at(texel, axis)));
}

// The last cell is the one that ends at the high end, not the one that begins there.
void add_linear(Interval u, const Axis& axis, Cells& cells) {
  const Interval v{Down::sum(u.low, -0.5), Up::sum(u.high, -0.5)};
  const auto first = static_cast<std::int64_t>(std::floor(v.low));
  const auto last = std::max(first, static_cast<std::int64_t>(std::ceil(v.high)) - 1);
  for (std::int64_t texel = first; texel <= last; ++texel) {
    const auto begin = static_cast<double>(texel);
    cells.push_back({texel_at(texel, axis), texel_at(texel + 1, axis),
                     texel == first ? Down::sum(v.low, -begin) : 0,
                     texel == last ? Up::sum(v.high, -begin) : 1});
  }
}

// The colours of one axis' cells, and whether they belong to one point, except for rounding.
struct AxisCells {
  Cells cells;
  bool is_narrow = true;
};

AxisCells cells_of(Interval s, const Axis& axis, Filter filter) {
  constexpr double kNarrow = 0x1p-20;
  const bool has_grid = axis.grid != TexelGrid::none;
  Interval u;
  AxisCells result;
  Cells& cells = result.cells;
  switch (filter) {
    case Filter::nearest:
      u = in_texels(s, axis, true);
      add_nearest(u, axis, cells);
      break;
    case Filter::linear:
      u = in_texels(s, axis, has_grid);
      add_linear(u, axis, cells);
      break;
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  result.is_narrow = u.high - u.low < kNarrow;
  return result;
}

// value * share, for a share above 0: of values that are not negative, two of the four products are
// the ends.
Interval part_of(Interval value, Interval share) {
  if (value.low >= 0) return outward(share.low * value.low, share.high * value.high);
  return share * value;
}

// The mean of two colours, `weight` that of b. It always lies between them: the mean of equal
// numbers is that number.
Texel mean(const Texel& a, const Texel& b, double weight) {
  if (weight == 0) return a;
  if (weight == 1) return b;
  const Interval rest{Down::sum(1, -weight), Up::sum(1, -weight)};
  Texel result;
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Interval sum = part_of(a[k], rest) + part_of(b[k], weight);
    const Interval between = hull(a[k], b[k]);
    result[k] = {std::max(sum.low, between.low), std::min(sum.high, between.high)};
  }
  return result;
}

// The hull of no colours.
constexpr Interval kNothing{std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity()};

void extend(Texel& box, const Texel& by) {
  for (std::size_t k = 0; k < box.size(); ++k) box[k] = hull(box[k], by[k]);
}

struct Image {
  const DecodedLevel& level;
  Texel border;

  const Texel& at(int i, int j) const {
    return i == kBorder || j == kBorder ? border : level.at(i, j);
  }
};

// The mean of four texels is linear in either weight, so the corners of the ranges bound it.
Texel quad_colour(const Image& image, const Cell& s, const Cell& t) {
  const auto at_s = [&](double weight) {
    const Texel first = mean(image.at(s.first, t.first), image.at(s.second, t.first), weight);
    const Texel second = mean(image.at(s.first, t.second), image.at(s.second, t.second), weight);
    Texel box = mean(first, second, t.least);
    if (t.most > t.least) extend(box, mean(first, second, t.most));
    return box;
  };
  Texel box = at_s(s.least);
  if (s.most > s.least) extend(box, at_s(s.most));
  return box;
}

using Ends = std::array<double, 8>;

Ends ends_of(const Texel& box) {
  return {box[0].low, box[0].high, box[1].low, box[1].high,
          box[2].low, box[2].high, box[3].low, box[3].high};
}

void drop_equal(Texels& boxes) {
  if (boxes.size() < 2) return;
  std::sort(boxes.begin(), boxes.end(),
            [](const Texel& a, const Texel& b) { return ends_of(a) < ends_of(b); });
  const auto equal = [](const Texel& a, const Texel& b) { return ends_of(a) == ends_of(b); };
  boxes.erase(std::unique(boxes.begin(), boxes.end(), equal), boxes.end());
}

// The number of cells of each axis that share a box, so that there are at most `kMostBoxes`.
std::size_t cells_per_box(std::size_t columns, std::size_t rows) {
  const auto boxes = [&](std::size_t cells) {
    return ((columns + cells - 1) / cells) * ((rows + cells - 1) / cells);
  };
  std::size_t cells = 1;
  while (boxes(cells) > kMostBoxes) ++cells;
  return cells;
}

Texels boxes_of(const Image& image, const Cells& s, const Cells& t, std::size_t per_box) {
  Texels boxes;
  for (std::size_t j0 = 0; j0 < t.size(); j0 += per_box)
    for (std::size_t i0 = 0; i0 < s.size(); i0 += per_box) {
      Texel box;
      box.fill(kNothing);
      for (std::size_t j = j0; j < std::min(j0 + per_box, t.size()); ++j)
        for (std::size_t i = i0; i < std::min(i0 + per_box, s.size()); ++i)
          extend(box, quad_colour(image, s[i], t[j]));
      boxes.push_back(box);
    }
  return boxes;
}

}  // namespace

Interval on_grid(Interval coordinate, TexelGrid grid) {
  return {on_grid(coordinate.low, grid), on_grid(coordinate.high, grid)};
}

Texels filter_level(const DecodedLevel& level, int dimensions, TextureFormat format, Filter filter,
                    const TexturePoint& point, const TexelLookup& lookup) {
  const TexelGrid grid = effective(lookup.grid, filter, format);
  const auto axis = [&](std::size_t k, int size) {
    return Axis{size, effective(lookup.wrap[k], lookup.choice), grid, lookup.slack};
  };
  const AxisCells s = cells_of(point.s, axis(0, level.width), filter);
  const AxisCells t = dimensions == 1 ? AxisCells{{lone_cell(0)}, true}
                                      : cells_of(point.t, axis(1, level.height), filter);
  const auto meets_border = [&](std::size_t k) {
    return effective(lookup.wrap[k], lookup.choice) == Wrap::clamp_to_border;
  };
  Image image{level, {}};
  if (meets_border(0) || (dimensions == 2 && meets_border(1)))
    image.border = decode_border(lookup.border, format);
  // At a texel's centre, a rounded coordinate touches two cells whose colours are equal there.
  const bool is_one = filter == Filter::linear && s.is_narrow && t.is_narrow;
  const std::size_t per_box = is_one ? std::max(s.cells.size(), t.cells.size())
                                     : cells_per_box(s.cells.size(), t.cells.size());
  Texels boxes = boxes_of(image, s.cells, t.cells, per_box);
  drop_equal(boxes);
  return boxes;
}

Rule texel_filter_rule() {
  return {
      RuleId::texture_filter,
      "A lookup takes the texel that holds the point, or the mean of the four around it",
      "8.14.2 (coordinate wrapping and texel selection) and 8.14.3 (mipmapping)",
      "positions within a texel have no stated precision, and neither have the weights made from "
      "them; textures of 8 bits may be filtered in 8 bits (ruling 24)",
      "",
      {},
      {{24,
        "Texels: the coordinates that the renderer itself interpolated decide which texel "
        "contains a point, and how those around it are weighted. OpenGL does not say to how many "
        "bits positions within a texel are kept: a coordinate in texels may be off by 2^-7, as "
        "the Khronos tests ask, and 1 part in 10^5 of itself (2.3.4.1); what is beyond is a "
        "violation, or contested by ruling 50. Nearest: that close to a border either texel is "
        "permitted; exactly on it, the formula yields the upper or right one. Linear: any "
        "weights that such coordinates yield. A filter of a format of 8 bits may compute in 8 "
        "bits: each mean that it takes, along s, along t and between levels, may round to a code "
        "and be off by half of one. sRGB texels may be decoded before they are filtered, after "
        "that within each level, or after all of it (8.24). Numbers may besides be off by 1 part "
        "in 10^5 of the texture's largest, by 3 more for each of these means, whose operations "
        "err one by one (2.3.4.1), and by 1 more for each lookup of an anisotropic filter. Where "
        "the renderer reports the level of detail, its colour must fit that level. A coordinate "
        "that is infinite or not a number may yield any colour, and so may levels that the "
        "renderer generated and does not report."},
       {kRulingOnSrgb,
        "Contested: a red, green or blue looked up in an sRGB texture is beyond what the filter "
        "and the rounding to 8 bits permit (ruling 24), by 0.005 at most. 2.3.4.1 states 1 part in "
        "10^5 of each operation of the conversion to linear light. But 8.24 states no precision of "
        "the conversion as a whole, and 2.3.4 lets the format limit it, which has 8 bits. The "
        "Khronos tests (dEQP-GLES31.functional.srgb_texture_decode.skip_decode.*) accept 0.005. "
        "OpenGL ES 3.2 converts alike (8.21)."}}};
}

Rule texel_grid_rule() {
  return {RuleId::texture_texel_grid,
          "Texels and weights follow from coordinates that are not rounded",
          "8.14.2 (coordinate wrapping and texel selection)",
          "coordinates in texels may be rounded to some bits (ruling 24)",
          "none",
          alternatives_of<TexelGrid>(),
          {}};
}

}  // namespace edgecase
