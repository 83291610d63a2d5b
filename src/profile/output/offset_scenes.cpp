// SPDX-License-Identifier: MIT
//
// Polygon offsets, each with a draw of its own.
#include <algorithm>
#include <array>
#include <utility>

#include "profile/output/cells.h"
#include "profile/output/output_scenes.h"
#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

constexpr Color kWhite{1, 1, 1, 1};
constexpr std::uint64_t kSlopeScenes = 4;
constexpr std::size_t kSlopesOfAScene = 64;

// Puts triangles with offsets of their own into cells, one after another.
class OffsetScene {
 public:
  OffsetScene(Surface surface, DepthFormat format) : scene_(cell_scene(surface)) {
    scene_.target.depth = format;
  }

  void add(const CellTriangle& triangle, const PolygonOffset& offset) {
    Draw draw = cell_draw();
    draw.polygon_offset = offset;
    add_triangle(draw, scene_.draws.size(), triangle);
    scene_.draws.push_back(std::move(draw));
  }
  bool is_full() const { return scene_.draws.size() == kCells; }
  Scene take() { return std::move(scene_); }

 private:
  Scene scene_;
};

// Offsets of up to 1/32 for a step, 1/8 for the largest unit that is known; depths of 1/4 and more.
Scene fixed_units_scene(Surface surface, DepthFormat format) {
  OffsetScene scene(surface, format);
  for (const std::int64_t eighths : {2, 3, 5})
    for (int power = 0; power <= bits_of(format) - 5; ++power)
      for (const float sign : {1.0F, -1.0F})
        scene.add(flat_triangle(kWhite, eighths * kDepthOne / 8),
                  {0, sign * static_cast<float>(1 << power), 0});
  return scene.take();
}

// Units of 2^(e - 23) make offsets of 1/16 of the depth's power of two.
constexpr float kManyUnits = 0x1p19F;

// A depth's power of two, and quarters beside it; and triangles whose corners have different ones.
Scene float_units_scene(Surface surface) {
  OffsetScene scene(surface, DepthFormat::depth32f);
  for (int exponent = 1; exponent <= 12; ++exponent) {
    const std::int64_t power = kDepthOne >> exponent;
    for (const std::int64_t quarters : {4, 5, 6, 7}) {
      scene.add(flat_triangle(kWhite, quarters * power / 4), {0, kManyUnits, 0});
      // Not beyond 1.
      if (exponent > 1)
        scene.add(flat_triangle(kWhite, quarters * power / 4), {0, 3 * kManyUnits, 0});
    }
    // Units of the largest depth's power of two alone are taken away without reaching 0.
    if (exponent < 4) scene.add(flat_triangle(kWhite, power), {0, -kManyUnits, 0});
    if (exponent == 1) continue;
    for (const std::size_t largest : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
      CellTriangle triangle = flat_triangle(kWhite, power);
      triangle.z[largest] = z_of_depth(2 * power);
      scene.add(triangle, {0, kManyUnits, 0});
    }
  }
  return scene.take();
}

}  // namespace

std::vector<Scene> offset_unit_scenes(Surface surface, DepthFormat format) {
  if (format == DepthFormat::depth32f) return {float_units_scene(surface)};
  return {fixed_units_scene(surface, format)};
}

std::vector<Scene> offset_slope_scenes(std::uint64_t seed, Surface surface, DepthFormat format) {
  std::vector<Scene> scenes;
  for (std::uint64_t i = 0; i < kSlopeScenes; ++i) {
    RandomSource random = random_of(seed, OutputStream::slopes, surface, i);
    OffsetScene scene(surface, format);
    for (std::size_t n = 0; n < kSlopesOfAScene; ++n) {
      // Of depth per half a pixel, up to 1/32 each; 0 in x or in y now and then.
      const auto rise = [&] {
        return random.one_in(8) ? 0 : random.between(-kDepthOne / 64, kDepthOne / 64) * 2;
      };
      const std::int64_t x = rise();
      const std::int64_t y = rise();
      CellTriangle triangle;
      const std::int64_t base = kDepthOne / 2;
      triangle.z = {z_of_depth(base), z_of_depth(base + x), z_of_depth(base + x / 2 + y)};
      const auto factor = static_cast<float>(random.sign() * random.between(1, 12)) / 4.0F;
      scene.add(triangle, {factor, 0, 0});
    }
    scenes.push_back(scene.take());
  }
  return scenes;
}

}  // namespace edgecase
