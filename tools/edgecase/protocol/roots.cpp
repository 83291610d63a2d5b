// SPDX-License-Identifier: MIT
#include "tools/edgecase/protocol/roots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "tools/edgecase/protocol/scenes.h"

namespace edgecase {

namespace {

constexpr int kSize = 32;
// Each primitive covers the pixel of its column in this row.
constexpr int kRow = 6;
constexpr std::array<int, 3> kColumns = {5, 15, 25};
// Red and cyan differ if red and blue are exchanged in one of them, or in both.
constexpr Color kDrawn = {1, 0, 0, 1};
constexpr Color kClear = {0, 1, 1, 1};
constexpr int kDrawnExchanged[3] = {0, 0, 255};
constexpr int kClearExchanged[3] = {255, 255, 0};

// Which of the primitives show in pixels, or in fragments, and whether in the mirrored row.
struct Shown {
  std::array<bool, 3> primitives{};
  bool upside_down = false;

  int row() const { return upside_down ? kSize - 1 - kRow : kRow; }
};

template <typename Shows>
Shown shown_where(const Shows& shows) {
  for (const bool upside_down : {false, true}) {
    Shown shown{{}, upside_down};
    for (std::size_t i = 0; i < kColumns.size(); ++i)
      shown.primitives[i] = shows(kColumns[i], shown.row());
    if (shown.primitives != std::array<bool, 3>{}) return shown;
  }
  return {};
}

// The pixels that do not have the colour of a corner, where nothing is to be drawn.
Shown shown_pixels(const Rendering& rendering) {
  return shown_where([&](int x, int y) {
    const std::uint8_t* corner = rendering.pixels.data();
    const std::uint8_t* pixel = corner + 4 * rendering.pixel_index(x, y);
    return !std::equal(pixel, pixel + 4, corner);
  });
}

Shown shown_fragments(const Rendering& rendering) {
  return shown_where([&](int x, int y) {
    return std::any_of(rendering.fragments.begin(), rendering.fragments.end(),
                       [&](const Fragment& f) { return f.x == x && f.y == y; });
  });
}

void find_nothing(const Rendering& rendering, std::vector<Fault>& roots) {
  const bool fragments = !rendering.fragments.empty();
  const bool pixels = shows_contrast(rendering);
  if (!pixels && !fragments)
    roots.push_back({"it draws nothing: all pixels are alike, and no fragment is listed",
                     "draw what \"draws\" holds, or answer \"not_run\""});
  else if (!pixels)
    roots.push_back({"all pixels are alike, although it lists fragments",
                     "write the colour of each fragment to its pixel"});
  else if (!fragments)
    roots.push_back({"it draws pixels and lists no fragment",
                     "list each pixel that a primitive covers in \"fragments\""});
}

void find_upside_down(const Shown& pixels, const Shown& fragments, std::vector<Fault>& roots) {
  if (pixels.upside_down && fragments.upside_down)
    roots.push_back({"the image is upside down: what lies near the bottom is drawn near the top",
                     "let y point up: row 0 is the bottom one, of pixels and of fragments"});
  else if (pixels.upside_down)
    roots.push_back({"its pixels are upside down, and its fragments are not",
                     "write the rows of \"pixels\" from the bottom to the top"});
  else if (fragments.upside_down)
    roots.push_back({"its fragments are upside down, and its pixels are not",
                     "count \"y\" of fragments from the bottom"});
}

void find_culled(const Shown& pixels, std::vector<Fault>& roots) {
  const auto& [first, middle, last] = pixels.primitives;
  if (first != last || first == middle) return;
  roots.push_back({fmt::format("{} triangles are culled, although no facing is to be culled",
                               first ? "clockwise" : "counterclockwise"),
                   "draw both facings unless a draw has the key \"cull\""});
}

bool has(const Rendering& rendering, std::size_t pixel, const int (&color)[3]) {
  return shows(rendering, static_cast<int>(pixel % kSize), static_cast<int>(pixel / kSize), color,
               1);
}

void find_colors(const Rendering& rendering, std::size_t drawn, std::vector<Fault>& roots) {
  const bool of_drawn = has(rendering, drawn, kDrawnExchanged);
  const bool of_clear = has(rendering, 0, kClearExchanged);
  if (of_drawn || of_clear)
    roots.push_back(
        {fmt::format("red and blue are exchanged{}", !of_clear  ? " in what is drawn"
                                                     : of_drawn ? ""
                                                                : " in the clear colour"),
         "write the four numbers of a pixel as red, green, blue, alpha"});
  const auto is_short = [&](std::size_t pixel) {
    const std::uint8_t* codes = rendering.pixels.data() + 4 * pixel;
    return std::count(codes, codes + 4, 254) > 0;
  };
  if (is_short(drawn) || is_short(0))
    roots.push_back({"a colour of 1 is told as 254, which is off by one",
                     "convert a colour c of 0 to 1 by round(255 * c), so that 1 becomes 255"});
}

}  // namespace

Scene root_scene(Primitive primitive) {
  Scene scene = empty_scene(kSize, kSize);
  scene.target.clear = kClear;
  Draw draw;
  draw.primitive = primitive;
  // Points and lines lie off the centres by 1/8 pixel.
  const Fixed y = Fixed::centre_of(kRow) - Fixed::from_raw(Fixed::kOne / 8);
  const auto add = [&](Fixed at_x, Fixed at_y) {
    Vertex vertex;
    vertex.position = {at_x, at_y};
    vertex.color = kDrawn;
    draw.vertices.push_back(vertex);
  };
  for (const int column : kColumns) {
    const Fixed left = Fixed::from_integer(column - 4);
    const Fixed right = Fixed::from_integer(column + 5);
    switch (kind_of(primitive)) {
      case PrimitiveKind::point:
        add(Fixed::centre_of(column) - Fixed::from_raw(Fixed::kOne / 8), y);
        break;
      case PrimitiveKind::line:
        add(left, y);
        add(right, y);
        break;
      case PrimitiveKind::triangle:
        add(left, Fixed::from_integer(2));
        add(right, Fixed::from_integer(2));
        add(Fixed::from_integer(column), Fixed::from_integer(14));
        if (column == kColumns[1]) std::swap(draw.vertices[3], draw.vertices[4]);
        break;
    }
  }
  scene.draws = {draw};
  return scene;
}

std::vector<Fault> roots_of(Primitive primitive, const Rendering& rendering) {
  std::vector<Fault> roots;
  find_nothing(rendering, roots);
  const Shown pixels = shown_pixels(rendering);
  find_upside_down(pixels, shown_fragments(rendering), roots);
  if (primitive == Primitive::triangles) find_culled(pixels, roots);
  // The clear colour if nothing is drawn where something is expected.
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < kColumns.size(); ++i)
    if (pixels.primitives[i]) drawn = rendering.pixel_index(kColumns[i], pixels.row());
  find_colors(rendering, drawn, roots);
  return roots;
}

}  // namespace edgecase
