// SPDX-License-Identifier: MIT
#include "generate/clip_scenes.h"

#include <array>
#include <vector>

#include "casefile/scene/viewport.h"
#include "generate/random_scenes.h"
#include "generate/random_shapes.h"

namespace edgecase {
namespace {

constexpr int kSize = 32;   // pixels, of the viewport
constexpr int kBorder = 4;  // pixels around it, where its sides show
// Generators of one seed with different purposes are independent.
constexpr std::uint64_t kStreams = 0x5f00;  // plus a ClipPlace

// Sixteenths of a pixel from the centre of the target, as clip coordinates with w = 1.
float clip_of(std::int64_t sixteenths) {
  return static_cast<float>(sixteenths) / (16 * kSize / 2);
}

float inside(RandomSource& random) {
  return clip_of(random.between(-8 * kSize + 1, 8 * kSize - 1));
}

// A coordinate `least` to `most` pixels beyond one side or the opposite one.
float beyond(RandomSource& random, std::int64_t least, std::int64_t most) {
  const std::int64_t sixteenths = 8 * kSize + random.between(16 * least + 1, 16 * most);
  return clip_of(random.sign() * sixteenths);
}

ClipPosition at_a_side(RandomSource& random, std::int64_t least, std::int64_t most) {
  const float out = beyond(random, least, most);
  const float other = random.one_in(3) ? beyond(random, least, most) : inside(random);
  return random.one_in(2) ? ClipPosition{out, other, 0, 1} : ClipPosition{other, out, 0, 1};
}

ClipPosition outside(RandomSource& random, ClipPlace place) {
  const float deep = static_cast<float>(random.between(17, 64)) / 16;
  switch (place) {
    case ClipPlace::little:
      return at_a_side(random, 0, 8);
    case ClipPlace::much:
      return at_a_side(random, 64, 2048);
    case ClipPlace::beyond_8192:
      return at_a_side(random, 8192, 32768);
    case ClipPlace::near:
      return {inside(random), inside(random), -deep, 1};
    case ClipPlace::far:
      return {inside(random), inside(random), deep, 1};
    case ClipPlace::behind:
      return {inside(random), inside(random), -2 * deep, -deep};
  }
  return {};
}

}  // namespace

Scene clip_scene(std::uint64_t seed, Surface surface, ClipPlace place, std::uint64_t index) {
  RandomSource random(seed, kStreams + static_cast<std::uint64_t>(place), index);
  Scene scene =
      scene_of(surface, kSize + 2 * kBorder, Primitive::triangles, std::array<Point, 3>{});
  scene.viewport = {kBorder, kBorder, kSize, kSize};
  std::vector<Vertex>& vertices = scene.draws[0].vertices;
  const auto last = static_cast<std::size_t>(random.below(3));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const float z = static_cast<float>(random.between(-15, 15)) / 16;
    vertices[i].clip =
        i == last ? outside(random, place) : ClipPosition{inside(random), inside(random), z, 1};
    place_clip_vertex(scene.viewport, vertices[i]);
  }
  return scene;
}

}  // namespace edgecase
