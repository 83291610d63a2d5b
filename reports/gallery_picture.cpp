// SPDX-License-Identifier: MIT
#include "reports/gallery_picture.h"

#include <algorithm>
#include <cstddef>
#include <map>

#include "reports/nodes.h"

namespace edgecase {
namespace {

// In CSS pixels.
constexpr int kWanted = 320;    // of a picture's longer side
constexpr int kLeastPixel = 5;  // of a pixel's side
constexpr int kMostPixel = 40;
constexpr int kGridFrom = 12;   // below, a grid would hide the pixels
constexpr int kShapesFrom = 8;  // below, outlines would
constexpr std::size_t kMostShapes = 80;

struct Canvas {
  pugi::xml_node svg;
  int width = 0;
  int height = 0;
  int pixel = 1;  // CSS pixels a side

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  // y runs down in SVG.
  double row(double y) const { return height - y; }
  pugi::xml_node add_path(const char* kind, const std::string& path) const {
    pugi::xml_node parent = svg;
    pugi::xml_node node = parent.append_child("path");
    set(node, "class", std::string(kind));
    set(node, "d", path);
    return node;
  }
};

std::string color_at(const GalleryImage& image, std::size_t index) {
  const std::uint8_t* rgba = &image.pixels[4 * index];
  return fmt::format("#{:02x}{:02x}{:02x}", rgba[0], rgba[1], rgba[2]);
}

// A path for each colour, of runs along rows.
void add_pixels(const Canvas& canvas, const GalleryImage& image) {
  std::map<std::string, std::string> paths;
  for (int y = 0; y < canvas.height; ++y)
    for (int x = 0; x < canvas.width;) {
      const std::string color = color_at(image, canvas.index(x, y));
      int end = x + 1;
      while (end < canvas.width && color_at(image, canvas.index(end, y)) == color) ++end;
      paths[color] += fmt::format("M{} {}h{}v1H{}z", x, canvas.height - 1 - y, end - x, x);
      x = end;
    }
  for (const auto& [color, path] : paths) set(canvas.add_path("pixels", path), "fill", color);
}

void add_grid(const Canvas& canvas) {
  if (canvas.pixel < kGridFrom) return;
  std::string path;
  for (int x = 0; x <= canvas.width; ++x) path += fmt::format("M{} 0V{}", x, canvas.height);
  for (int y = 0; y <= canvas.height; ++y) path += fmt::format("M0 {}H{}", y, canvas.width);
  canvas.add_path("grid", path);
}

void add_circle(const Canvas& canvas, const char* kind, double x, double y, double radius) {
  pugi::xml_node parent = canvas.svg;
  pugi::xml_node node = parent.append_child("circle");
  set(node, "class", std::string(kind));
  set(node, "cx", x);
  set(node, "cy", canvas.row(y));
  set(node, "r", radius);
}

// Each outline twice, dark on light, so that it shows on any colour.
void add_shapes(const Canvas& canvas, const Figure& figure) {
  if (canvas.pixel < kShapesFrom || figure.marks.size() > kMostShapes) return;
  for (const Mark& mark : figure.marks) {
    if (mark.role != MarkRole::primitive) continue;
    if (mark.points.size() == 1)
      add_circle(canvas, "dot", mark.points[0].first, mark.points[0].second, 3.0 / canvas.pixel);
    std::string path;
    for (const auto& [x, y] : mark.points)
      path += fmt::format("{}{:.4f} {:.4f}", path.empty() ? "M" : "L", x, canvas.row(y));
    if (mark.closed) path += "z";
    canvas.add_path("shape-halo", path);
    canvas.add_path("shape", path);
  }
}

// The sides between pixels that differ and others.
std::string contour(const Canvas& canvas, const std::vector<bool>& flags) {
  const auto is_set = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < canvas.width && y < canvas.height && flags[canvas.index(x, y)];
  };
  std::string path;
  for (int y = 0; y <= canvas.height; ++y)
    for (int x = 0; x <= canvas.width; ++x) {
      if (is_set(x, y) != is_set(x - 1, y)) path += fmt::format("M{} {}v-1", x, canvas.height - y);
      if (is_set(x, y) != is_set(x, y - 1)) path += fmt::format("M{} {}h1", x, canvas.height - y);
    }
  return path;
}

void add_difference(const Canvas& canvas, const GalleryDifference& difference) {
  if (const std::string path = contour(canvas, difference.slightly); !path.empty())
    canvas.add_path("slight", path);
  if (const std::string path = contour(canvas, difference.colored); !path.empty()) {
    canvas.add_path("mark-halo", path);
    canvas.add_path("mark", path);
  }
  for (int y = 0; y < canvas.height && difference.counts > 0; ++y)
    for (int x = 0; x < canvas.width; ++x)
      if (difference.counted[canvas.index(x, y)]) add_circle(canvas, "times", x + .5, y + .5, .22);
}

}  // namespace

void add_gallery_picture(pugi::xml_node parent, const GalleryEntry& entry,
                         const GalleryImage& image, const GalleryDifference& difference,
                         const std::string& words) {
  const int longer = std::max(entry.width, entry.height);
  Canvas canvas{parent.append_child("svg"), entry.width, entry.height,
                std::clamp(kWanted / longer, kLeastPixel, kMostPixel)};
  set(canvas.svg, "class", std::string("picture"));
  set(canvas.svg, "viewBox", fmt::format("-0.1 -0.1 {} {}", entry.width + 0.2, entry.height + 0.2));
  set(canvas.svg, "width", static_cast<double>(entry.width * canvas.pixel));
  set(canvas.svg, "height", static_cast<double>(entry.height * canvas.pixel));
  set(canvas.svg, "role", std::string("img"));
  set(canvas.svg, "aria-label", words);
  add_pixels(canvas, image);
  add_grid(canvas);
  add_shapes(canvas, entry.figure);
  add_difference(canvas, difference);
}

}  // namespace edgecase
