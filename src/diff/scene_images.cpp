// SPDX-License-Identifier: MIT
#include "diff/scene_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace edgecase {
namespace {

// Half the extent of a point's square or of a line's width, in pixels, rounded up.
int margin_of(const ScenePrimitive& primitive) {
  const Draw& draw = *primitive.state;
  const Fixed size = primitive.kind == PrimitiveKind::point  ? draw.point_size
                     : primitive.kind == PrimitiveKind::line ? draw.line_width
                                                             : Fixed();
  return static_cast<int>(size.ceil() / 2) + 1;
}

}  // namespace

bool is_whole_target(const Viewport& viewport, const Target& target) {
  return viewport.x == 0 && viewport.y == 0 && viewport.width == target.width &&
         viewport.height == target.height;
}

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

namespace {

// The smallest power of 2 that leaves room to move, and its float32 coordinates exact.
int side_for(const Target& target) {
  return std::max(target.width, target.height) <= 32 ? 64 : 128;
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
  image.first = std::make_shared<const Scene>(at_place(scene, 0, 0));
  image.second = at_place(scene, image.right, image.up);
  return image;
}

SceneImage masked(const Scene& scene) {
  SceneImage image;
  image.text = "has all colours masked, and another clear colour";
  image.second = scene;
  for (Draw& draw : image.second.draws) draw.operations.color_mask = {};
  for (float& component : image.second.target.clear) component = 1 - component;
  image.has_values = image.has_tests = true;
  return image;
}

SceneImage repeated(const Scene& scene) {
  SceneImage image;
  image.text = "is the scene once more";
  image.second = scene;
  image.has_values = image.has_pixels = image.has_tests = true;
  return image;
}

Scene within(Scene scene, const Viewport& box) {
  for (Draw& draw : scene.draws) {
    if (!draw.scissor) {
      draw.scissor = box;
      continue;
    }
    const PixelBounds both = common_part(pixels_in(*draw.scissor), pixels_in(box));
    draw.scissor = Viewport{both.x_min, both.y_min, std::max(both.x_max - both.x_min + 1, 0),
                            std::max(both.y_max - both.y_min + 1, 0)};
  }
  return scene;
}

// With the scissor test and blending, whose enables are excepted: `scissored` and `blended` change
// their parameters.
std::shared_ptr<const Scene> enabled(const Scene& scene) {
  Scene all = within(scene, {0, 0, scene.target.width, scene.target.height});
  for (Draw& draw : all.draws)
    if (!draw.operations.blending) draw.operations.blending.emplace();
  return std::make_shared<const Scene>(std::move(all));
}

// The box has neighbours on each side where the target has three pixels or more along it.
SceneImage scissored(const std::shared_ptr<const Scene>& enabled) {
  const auto [width, height] = std::pair(enabled->target.width, enabled->target.height);
  const Viewport box{width / 3, height / 3, (width + 1) / 2, (height + 1) / 2};
  SceneImage image;
  image.text = fmt::format("has a scissor box of {}x{} pixels at ({}, {})", box.width, box.height,
                           box.x, box.y);
  image.first = enabled;
  image.second = within(*enabled, box);
  image.part = pixels_in(box);
  image.has_values = image.has_pixels = image.has_tests = true;
  return image;
}

SceneImage after_the_same(const Scene& scene) {
  SceneImage image;
  image.text = "follows a first drawing of the same";
  image.second = scene;
  image.second.draws.insert(image.second.draws.end(), scene.draws.begin(), scene.draws.end());
  image.behind = static_cast<int>(primitives_of(scene).size());
  image.has_values = true;
  return image;
}

// Whether a depth buffer is added to a scene without being read, or counted upon.
bool has_room_for_depths(const Scene& scene) {
  return scene.target.depth == DepthFormat::none && scene.target.stencil == StencilFormat::none &&
         std::ranges::all_of(scene.draws, [](const Draw& draw) {
           return draw.operations.depth.function == CompareFunction::always && !draw.polygon_offset;
         });
}

SceneImage blended(const std::shared_ptr<const Scene>& enabled) {
  constexpr BlendTerm kSum{BlendEquation::add, BlendFactor::one, BlendFactor::one};
  constexpr BlendTerm kLargest{BlendEquation::max, BlendFactor::one, BlendFactor::one};
  SceneImage image;
  image.text = "has other parameters of blending";
  image.first = enabled;
  image.second = *enabled;
  for (Draw& draw : image.second.draws) {
    BlendTerm& color = draw.operations.blending->color;
    color = color == kSum ? kLargest : kSum;
  }
  if (has_room_for_depths(*enabled)) {
    image.text += " and a depth buffer that nothing reads";
    image.second.target.depth = DepthFormat::depth24;
  }
  image.has_values = true;
  image.ruling = kRulingOnSuggestedImages;
  return image;
}

}  // namespace

std::vector<SceneImage> images_of(const Scene& scene, bool suggested) {
  std::vector<SceneImage> images;
  if (can_be_moved(scene)) images.push_back(moved(scene));
  images.push_back(repeated(scene));
  // A supersampled scene has no fragment operations.
  if (!scene.supersampling.empty()) return images;
  images.push_back(masked(scene));
  images.push_back(after_the_same(scene));
  const std::shared_ptr<const Scene> first = enabled(scene);
  images.push_back(scissored(first));
  if (suggested) images.push_back(blended(first));
  return images;
}

}  // namespace edgecase
