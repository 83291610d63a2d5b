// SPDX-License-Identifier: MIT
//
// A scene that is cut in two by a plane draws the same pixels as the whole scene: exactly, where
// nothing is rounded, and within ruling 42 by every permitted way to clip. The plane takes the near
// plane's place: a copy of the triangle with z = p - w lies in front of it where p >= 0, and one
// with z = -p - w where p <= 0.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <tuple>

#include "diff/coverage/legality.h"
#include "diff/coverage/sample_legality.h"
#include "raster/rasterizer.h"
#include "tests/raster/clipped_scenes.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

constexpr Viewport kViewport{0, 0, 8, 8};
using Pixels = std::vector<PixelPosition>;

// p = a x + b y + c w, in clip coordinates.
struct Plane {
  float a, b, c;
};

struct Halves {
  Scene whole;
  Scene front;  // p >= 0
  Scene back;
};

Halves halves(ClippedScenes& random) {
  Halves result{random.scene(Primitive::triangles, 0, kViewport), {}, {}};
  const auto number = [&] { return static_cast<float>(random.between(-3, 3)); };
  const Plane plane{number(), number(), number()};
  for (int i = 0; i < 3; ++i) result.whole.draws[0].vertices.push_back(random.vertex_inside());
  for (Vertex& vertex : result.whole.draws[0].vertices) vertex.clip->z = 0;
  result.front = result.back = result.whole;
  for (std::size_t i = 0; i < 3; ++i) {
    const ClipPosition& clip = *result.whole.draws[0].vertices[i].clip;
    // Of magnitude 1/4 w at most, so that nothing reaches the far plane.
    const float p = (plane.a * clip.x + plane.b * clip.y + plane.c * clip.w) / 64;
    result.front.draws[0].vertices[i].clip->z = p - clip.w;
    result.back.draws[0].vertices[i].clip->z = -p - clip.w;
  }
  return result;
}

Pixels drawn(const Scene& scene, const CoverageChoice& choice) {
  return covered_pixels(primitives_of(scene).front(), scene.target, choice);
}

TEST(CutScene, TheTwoHalvesDrawWhatTheWholeDraws) {
  ClippedScenes random(17);
  const CoverageChoice choice = resolve({}, Surface::fbo).triangles;
  long cut = 0, pixels = 0;
  for (int round = 0; round < 6000; ++round) {
    const Halves scene = halves(random);
    const Pixels whole = drawn(scene.whole, choice);
    const Pixels front = drawn(scene.front, choice);
    const Pixels back = drawn(scene.back, choice);
    cut += !front.empty() && !back.empty();
    pixels += static_cast<long>(whole.size());
    Pixels both;
    std::set_union(
        front.begin(), front.end(), back.begin(), back.end(), std::back_inserter(both),
        [](PixelPosition a, PixelPosition b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
    EXPECT_EQ(both, whole) << round;
    if (HasFailure()) return;
  }
  EXPECT_GT(cut, 500);
  EXPECT_GT(pixels, 20000);
}

// What clipping rounds moves no pixel farther than ruling 42 says, and none that the whole has not
// within ruling 4.
TEST(CutScene, EveryPermittedWayDrawsItWithinTheBound) {
  ClippedScenes random(18);
  long differing = 0, made = 0;
  for (int round = 0; round < 4000; ++round) {
    const Halves scene = halves(random);
    for (const ClipMethod clip :
         {ClipMethod::polygon, ClipMethod::guard_band, ClipMethod::doubled_sides}) {
      for (const char* snap : {"none", "8-half-even", "8-truncate", "4-half-up"}) {
        CoverageChoice choice = resolve({}, Surface::fbo).triangles;
        choice.clip = clip;
        choice.snap = *find_snap(snap);
        const int bits = snap[0] == '4' ? 4 : 8;
        for (const Scene* half : {&scene.front, &scene.back}) {
          const ScenePrimitive triangle = primitives_of(*half).front();
          if (!triangle.is_clipped) continue;
          ++made;
          PrimitiveCoverage coverage;
          coverage.exact = {drawn(*half, resolve({}, Surface::fbo).triangles)};
          coverage.drawn = {drawn(*half, choice)};
          for (const CoverageDifference& difference : differences(coverage)) {
            ++differing;
            const CoverageLegality legality =
                judge_sample(triangle, difference, centre_of_pixel(), bits);
            EXPECT_TRUE(legality.legal) << legality.reason << " round " << round << " " << snap;
            EXPECT_EQ(legality.ruling, 42);
          }
        }
      }
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(made, 1000);
  EXPECT_GT(differing, 300);
}

// The bound is not idle: a triangle dropped whole, and one that near or the sides do not cut, break
// it.
TEST(CutScene, WaysThatAreNotPermittedBreakTheBound) {
  ClippedScenes random(19);
  long illegal = 0, differing = 0;
  for (int round = 0; round < 1000; ++round) {
    const Halves scene = halves(random);
    for (const ClipMethod clip :
         {ClipMethod::discarded, ClipMethod::depth_ignored, ClipMethod::sides_ignored}) {
      const ScenePrimitive triangle = primitives_of(scene.front).front();
      CoverageChoice choice = resolve({}, Surface::fbo).triangles;
      PrimitiveCoverage coverage;
      coverage.exact = {drawn(scene.front, choice)};
      choice.clip = clip;
      coverage.drawn = {drawn(scene.front, choice)};
      if (!triangle.is_clipped) continue;
      for (const CoverageDifference& difference : differences(coverage)) {
        ++differing;
        illegal += !judge_sample(triangle, difference, centre_of_pixel(), 8).legal;
      }
    }
  }
  EXPECT_GT(differing, 1000);
  EXPECT_GT(illegal, differing / 2);
}

}  // namespace
}  // namespace edgecase
