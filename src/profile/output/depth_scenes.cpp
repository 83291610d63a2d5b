// SPDX-License-Identifier: MIT
//
// Scenes of depths: their codes, the depth and the stencil test, polygon offset.
#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "profile/output/output.h"
#include "rules/values/framebuffer.h"

namespace edgecase {

// --------------------------------------------------------------------------- depth codes and tests

namespace {

constexpr std::uint64_t kScenesOfARange = 2;
constexpr std::uint64_t kTestScenes = 4;
constexpr std::uint64_t kStencilScenes = 6;
constexpr std::size_t kStencilDraws = 48;

constexpr std::array kFunctions{CompareFunction::never,   CompareFunction::less,
                                CompareFunction::equal,   CompareFunction::lequal,
                                CompareFunction::greater, CompareFunction::notequal,
                                CompareFunction::gequal,  CompareFunction::always};
constexpr std::array kOperations{StencilOperation::keep,      StencilOperation::zero,
                                 StencilOperation::replace,   StencilOperation::incr,
                                 StencilOperation::incr_wrap, StencilOperation::decr,
                                 StencilOperation::decr_wrap, StencilOperation::invert};

constexpr Color kWhite{1, 1, 1, 1};
constexpr Color kGray{0.25F, 0.25F, 0.25F, 1};

// The whole range, where 24 bits give every distance from a code but few near a middle; lower
// ranges, where float32 is fine enough for many numbers between two codes; and a range round 1/2,
// which is such a middle.
constexpr std::array<DepthRange, 7> kRanges{{{0, 1},
                                             {1, 0},
                                             {0, 0x1p-4F},
                                             {0, 0x1p-9F},
                                             {0, 0x1p-12F},
                                             {0.5F - 0x1p-8F, 0.5F + 0x1p-8F},
                                             {1 - 0x1p-7F, 1}}};

// A depth above a code by 1/16 to 7/16 of a step; any depth for a floating-point buffer.
std::int64_t random_depth_above_a_code(RandomSource& random, DepthFormat format) {
  const std::int64_t largest = (std::int64_t{1} << bits_of(format)) - 1;
  for (;;) {
    const std::int64_t depth = random.between(kDepthOne / 8, 7 * kDepthOne / 8);
    const std::int64_t above = depth * largest % kDepthOne;
    if (bits_of(format) == 0) return depth;
    if (above > kDepthOne / 16 && above < 7 * kDepthOne / 16) return depth;
  }
}

StencilFace random_face(RandomSource& random) {
  constexpr std::array<std::uint8_t, 6> kMaskChoices{0xff, 0xff, 0xff, 0x0f, 0xf0, 0x5a};
  constexpr std::array<std::uint8_t, 6> kReferences{0, 1, 127, 128, 254, 255};
  const auto operation = [&] {
    return random.one_of(std::span<const StencilOperation>(kOperations));
  };
  const auto mask = [&] { return random.one_of(std::span<const std::uint8_t>(kMaskChoices)); };
  StencilFace face;
  face.function = random.one_of(std::span<const CompareFunction>(kFunctions));
  face.reference = random.one_in(2) ? random.one_of(std::span<const std::uint8_t>(kReferences))
                                    : static_cast<std::uint8_t>(random.below(256));
  face.read_mask = mask();
  face.write_mask = mask();
  face.fail = operation();
  face.depth_fail = operation();
  face.pass = operation();
  return face;
}

}  // namespace

std::vector<Scene> depth_code_scenes(std::uint64_t seed, Surface surface, DepthFormat format) {
  std::vector<Scene> scenes;
  for (const DepthRange& range : kRanges)
    for (std::uint64_t i = 0; i < kScenesOfARange; ++i) {
      RandomSource random = random_of(seed, OutputStream::codes, surface, scenes.size());
      Scene scene = cell_scene(surface);
      scene.target.depth = format;
      scene.depth_range = range;
      Draw draw = cell_draw();
      for (std::size_t cell = 0; cell < kCells; ++cell)
        add_triangle(draw, cell, flat_triangle(kWhite, random.below(kDepthOne + 1)));
      scene.draws.push_back(std::move(draw));
      scenes.push_back(std::move(scene));
    }
  return scenes;
}

std::vector<Scene> depth_test_scenes(std::uint64_t seed, Surface surface, DepthFormat format) {
  std::vector<Scene> scenes;
  for (std::uint64_t i = 0; i < kTestScenes; ++i) {
    RandomSource random = random_of(seed, OutputStream::tests, surface, i);
    Scene scene = cell_scene(surface);
    scene.target.depth = format;
    Draw stored = cell_draw();
    std::array<Draw, kFunctions.size()> tested;
    for (std::size_t f = 0; f < tested.size(); ++f) {
      tested[f] = cell_draw();
      tested[f].operations.depth.function = kFunctions[f];
    }
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      const std::int64_t depth = random_depth_above_a_code(random, format);
      // One third each: equal, nearer, and farther by many steps of 16 bits.
      const std::int64_t apart = random.between(-1, 1) * random.between(64, 4096);
      add_triangle(stored, cell, flat_triangle(kGray, depth));
      add_triangle(tested[cell % tested.size()], cell, flat_triangle(kWhite, depth + apart));
    }
    scene.draws.push_back(std::move(stored));
    for (Draw& draw : tested) scene.draws.push_back(std::move(draw));
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::vector<Scene> stencil_scenes(std::uint64_t seed, Surface surface, DepthFormat format) {
  std::vector<Scene> scenes;
  for (std::uint64_t i = 0; i < kStencilScenes; ++i) {
    RandomSource random = random_of(seed, OutputStream::stencils, surface, i);
    Scene scene = cell_scene(surface);
    scene.target.depth = format;
    scene.target.stencil = StencilFormat::stencil8;
    scene.target.clear_stencil = static_cast<std::uint8_t>(random.below(256));
    for (std::size_t d = 0; d < kStencilDraws; ++d) {
      Draw draw = cell_draw();
      draw.operations.stencil = StencilTest{random_face(random), random_face(random)};
      draw.operations.depth.function = random.one_of(std::span<const CompareFunction>(kFunctions));
      // Depths far apart, and often equal.
      const std::int64_t depth = random.between(1, 7) * kDepthOne / 8;
      const Color color = random_codes(random);
      for (std::size_t cell = 0; cell < kCells; ++cell)
        if (random.one_in(4)) {
          const CellTriangle triangle = flat_triangle(color, depth, random.one_in(2));
          add_triangle(draw, cell, triangle);
          // Twice in one draw.
          if ((cell + d) % 4 == 0) add_triangle(draw, cell, triangle);
        }
      scene.draws.push_back(std::move(draw));
    }
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

// ---------------------------------------------------------------------------------- polygon offset

namespace {

constexpr std::uint64_t kSlopeScenes = 4;
constexpr std::size_t kSlopesOfAScene = 64;

// Puts triangles, each with its own offset, into consecutive cells.
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

// Offsets of up to 1/32 for a step, 1/8 for the largest known unit; depths of at least 1/4.
Scene fixed_units_scene(Surface surface, DepthFormat format) {
  OffsetScene scene(surface, format);
  for (const std::int64_t eighths : {2, 3, 5})
    for (int power = 0; power <= bits_of(format) - 5; ++power)
      for (const float sign : {1.0F, -1.0F})
        scene.add(flat_triangle(kWhite, eighths * kDepthOne / 8),
                  {0, sign * static_cast<float>(1 << power), 0});
  return scene.take();
}

// Units of 2^(e - 23) give offsets of 1/16 of the depth's power of two.
constexpr float kManyUnits = 0x1p19F;

// A depth's power of two, and quarters beside it; and triangles with corners of different powers.
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
    // Only units of the largest depth's power of two are subtracted without reaching 0.
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
  if (holds_floats(format)) return {float_units_scene(surface)};
  return {fixed_units_scene(surface, format)};
}

std::vector<Scene> offset_slope_scenes(std::uint64_t seed, Surface surface, DepthFormat format) {
  std::vector<Scene> scenes;
  for (std::uint64_t i = 0; i < kSlopeScenes; ++i) {
    RandomSource random = random_of(seed, OutputStream::slopes, surface, i);
    OffsetScene scene(surface, format);
    for (std::size_t n = 0; n < kSlopesOfAScene; ++n) {
      // Change of depth per half a pixel, up to 1/32 each; sometimes 0 in x or in y.
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
