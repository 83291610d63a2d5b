// SPDX-License-Identifier: MIT
#include "diff/invariance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tuple>

namespace edgecase {
namespace {

constexpr std::size_t kMostVariances = 64;
constexpr int kLargestMoved = 64;  // pixels along a side of what is moved

// The smallest power of 2 that leaves room to move, and its float32 coordinates exact.
int side_for(const Target& target) {
  return std::max(target.width, target.height) <= 32 ? 64 : 128;
}

bool is_whole_target(const Viewport& viewport, const Target& target) {
  return viewport.x == 0 && viewport.y == 0 && viewport.width == target.width &&
         viewport.height == target.height;
}

// Half the extent of a point's square or of a line's width, in pixels, rounded up.
int margin_of(const ScenePrimitive& primitive) {
  const Draw& draw = *primitive.state;
  const Fixed size = primitive.kind == PrimitiveKind::point  ? draw.point_size
                     : primitive.kind == PrimitiveKind::line ? draw.line_width
                                                             : Fixed();
  return static_cast<int>(size.ceil() / 2) + 1;
}

// True if neither the primitive nor its image is cut by the sides of the target, and nothing is
// rounded as its vertices get their places.
bool lies_inside(const ScenePrimitive& primitive, const Target& target) {
  const int margin = primitive.kind == PrimitiveKind::triangle ? 0 : margin_of(primitive);
  for (int v = 0; v < vertices_of(primitive.kind); ++v) {
    const Vertex& vertex = *primitive.vertices[static_cast<std::size_t>(v)];
    const Point p = vertex.position;
    if (vertex.clip || vertex.w != 1 || p.x.floor() < margin || p.y.floor() < margin ||
        p.x.ceil() > target.width - margin || p.y.ceil() > target.height - margin)
      return false;
  }
  return true;
}

bool can_be_moved(const Scene& scene) {
  const Target& target = scene.target;
  return target.samples == 1 && scene.supersampling.empty() && target.width <= kLargestMoved &&
         target.height <= kLargestMoved && is_whole_target(scene.viewport, target) &&
         std::ranges::all_of(primitives_of(scene), [&](const ScenePrimitive& primitive) {
           return lies_inside(primitive, target);
         });
}

Scene at_place(Scene scene, int right, int up) {
  const int side = side_for(scene.target);
  scene.target.width = scene.target.height = side;
  scene.viewport = {0, 0, side, side};
  for (Draw& draw : scene.draws) {
    for (Vertex& vertex : draw.vertices)
      vertex.position = {vertex.position.x + Fixed::from_integer(right),
                         vertex.position.y + Fixed::from_integer(up)};
    if (!draw.scissor) continue;
    draw.scissor->x += right;
    draw.scissor->y += up;
  }
  return scene;
}

SceneImage moved(const Scene& scene) {
  const int side = side_for(scene.target);
  // Odd, so that no pixel keeps its place in a tile.
  const int right = (side - scene.target.width) | 1;
  const int up = (side - scene.target.height - 2) | 1;
  const int fits = right + scene.target.width > side ? 2 : 0;
  SceneImage image;
  image.right = right - fits;
  image.up = up;
  image.text = fmt::format("is moved by {} pixels to the right and {} up", image.right, image.up);
  image.first = at_place(scene, 0, 0);
  image.second = at_place(scene, image.right, image.up);
  return image;
}

SceneImage masked(const Scene& scene) {
  SceneImage image;
  image.text = "has all colours masked, and another clear colour";
  image.second = scene;
  for (Draw& draw : image.second.draws) draw.operations.color_mask = {};
  for (float& component : image.second.target.clear) component = 1 - component;
  image.has_values = true;
  return image;
}

SceneImage repeated(const Scene& scene) {
  SceneImage image;
  image.text = "is drawn once more";
  image.second = scene;
  image.has_values = image.has_pixels = true;
  return image;
}

class Variances {
 public:
  Variances(const SceneImage& image, std::vector<Variance>& found)
      : image_(image), found_(found), most_(found.size() + kMostVariances) {}

  bool is_full() const { return found_.size() >= most_; }
  void add(PixelPosition pixel, int primitive, const std::string& what) {
    if (!is_full())
      found_.push_back({pixel, primitive, fmt::format("{}; it {}", what, image_.text)});
  }

 private:
  const SceneImage& image_;
  std::vector<Variance>& found_;
  const std::size_t most_;
};

bool is_same_number(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// What of a fragment differs, though both renderings report it; "" if nothing does.
std::string other_value(const Fragment& a, const Fragment& b) {
  if (a.coverage != b.coverage)
    return fmt::format("covers samples {:x} in the scene and {:x} in its image", a.coverage,
                       b.coverage);
  if (a.has_depth && b.has_depth && !is_same_number(a.depth, b.depth))
    return fmt::format("has depth {:.9g} in the scene and {:.9g} in its image", a.depth, b.depth);
  if (a.has_color && b.has_color && !std::ranges::equal(a.color, b.color, is_same_number))
    return fmt::format("has colour ({:.9g}) in the scene and ({:.9g}) in its image",
                       fmt::join(a.color, ", "), fmt::join(b.color, ", "));
  return "";
}

void compare_fragments(const SceneImage& image, const Rendering& first, const Rendering& second,
                       Variances& variances) {
  const auto key_in_first = [](const Fragment& f) { return std::tuple(f.y, f.x, f.primitive); };
  const auto key_in_second = [&](const Fragment& f) {
    return std::tuple(f.y - image.up, f.x - image.right, f.primitive);
  };
  const auto say = [&](const auto& key, const std::string& what) {
    const auto [y, x, primitive] = key;
    variances.add({x, y}, primitive, fmt::format("a fragment of primitive {} {}", primitive, what));
  };
  auto a = first.fragments.begin();
  auto b = second.fragments.begin();
  while ((a != first.fragments.end() || b != second.fragments.end()) && !variances.is_full()) {
    const bool is_a_left = a != first.fragments.end();
    const bool is_b_left = b != second.fragments.end();
    if (is_a_left && (!is_b_left || key_in_first(*a) < key_in_second(*b))) {
      say(key_in_first(*a++), "is in the scene and not in its image");
    } else if (is_b_left && (!is_a_left || key_in_second(*b) < key_in_first(*a))) {
      say(key_in_second(*b++), "is in the image of the scene and not in the scene");
    } else {
      if (const std::string what = image.has_values ? other_value(*a, *b) : ""; !what.empty())
        say(key_in_first(*a), what);
      ++a;
      ++b;
    }
  }
}

void compare_pixels(const Rendering& first, const Rendering& second, Variances& variances) {
  if (first.pixels.size() != second.pixels.size()) return;
  for (std::size_t i = 0; i < first.pixels.size() && !variances.is_full(); i += 4) {
    if (std::equal(&first.pixels[i], &first.pixels[i] + 4, &second.pixels[i])) continue;
    const auto pixel = static_cast<int>(i / 4);
    variances.add({pixel % first.width, pixel / first.width}, -1,
                  "the pixel has two colours in two drawings");
  }
}

}  // namespace

std::vector<SceneImage> images_of(const Scene& scene) {
  std::vector<SceneImage> images;
  if (can_be_moved(scene)) images.push_back(moved(scene));
  // A supersampled scene has no fragment operations.
  if (scene.supersampling.empty()) images.push_back(masked(scene));
  images.push_back(repeated(scene));
  return images;
}

void find_variances(const SceneImage& image, const Rendering& first, const Rendering& second,
                    std::vector<Variance>& found) {
  Variances variances(image, found);
  compare_fragments(image, first, second, variances);
  if (image.has_pixels) compare_pixels(first, second, variances);
  for (std::size_t i = 0; i < std::min(first.passes.size(), second.passes.size()); ++i)
    compare_fragments(image, first.passes[i], second.passes[i], variances);
}

}  // namespace edgecase
