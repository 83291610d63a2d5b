// SPDX-License-Identifier: MIT
//
// Points and lines at the viewport's sides, which clip them in OpenGL and not in OpenGL ES (rulings
// 42, 54 and 68): each API's picture agrees with its own law, and is found out under the other's.
#include "model/side_clipping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "rules/coverage/clip_volume.h"
#include "tests/diff/output/output_judging.h"
#include "tests/raster/clipped_scenes.h"

namespace edgecase {
namespace {

using Names = std::set<std::string>;
using Rulings = std::set<int>;
constexpr Viewport kWhole{0, 0, 8, 8};
constexpr Viewport kInner{2, 2, 4, 4};

Scene scene_of(Primitive primitive, const std::vector<ClipPosition>& positions,
               const Viewport& viewport = kWhole) {
  Scene scene = ClippedScenes(1).scene(primitive, 0, viewport);
  for (const ClipPosition& clip : positions) scene.draws[0].vertices.push_back(clip_vertex(clip));
  scene.draws[0].point_size = scene.draws[0].line_width = Fixed::from_integer(5);
  return scene;
}

Scene of_es(const Scene& scene) {
  const SceneOfApi own(scene, true);
  EXPECT_TRUE(own.is_own());
  EXPECT_TRUE(own.is_exact());
  return own.scene();
}

// A vertex half a pixel beyond each side, and beyond each corner.
std::vector<ClipPosition> beside() {
  constexpr float beyond = 1.125F;
  std::vector<ClipPosition> positions;
  for (const float x : {-beyond, 0.125F, beyond})
    for (const float y : {-beyond, 0.125F, beyond})
      if (std::fabs(x) > 1 || std::fabs(y) > 1) positions.push_back({x, y, 0.5F, 1});
  return positions;
}

// Lines of width 5, half a pixel beyond each side and along it.
std::vector<std::vector<ClipPosition>> lines_along_sides() {
  std::vector<std::vector<ClipPosition>> lines;
  for (const float beyond : {-1.125F, 1.125F}) {
    lines.push_back({{-0.5F, beyond, 0, 1}, {0.75F, beyond, 0, 1}});
    lines.push_back({{beyond, 0.75F, 0, 1}, {beyond, -0.5F, 0, 1}});
  }
  return lines;
}

TEST(SideClipping, APointOfOpenGlEsIsItsWholeSquare) {
  for (const ClipPosition& clip : beside()) {
    const Scene scene = of_es(scene_of(Primitive::points, {clip}));
    const double x = 4 + 4 * static_cast<double>(clip.x);
    const double y = 4 + 4 * static_cast<double>(clip.y);
    std::set<PixelPosition> square;
    for (int py = 0; py < 8; ++py)
      for (int px = 0; px < 8; ++px)
        if (std::fabs(px + 0.5 - x) < 2.5 && std::fabs(py + 0.5 - y) < 2.5) square.insert({px, py});
    std::set<PixelPosition> drawn;
    for (const Fragment& f : rasterize(scene, {}).fragments) drawn.insert({f.x, f.y});
    EXPECT_FALSE(square.empty());
    EXPECT_EQ(drawn, square) << clip.x << " " << clip.y;
  }
}

TEST(SideClipping, NearAndFarClipInOpenGlEsToo) {
  for (const float z : {-1.125F, 1.125F}) {
    const Scene scene = of_es(scene_of(Primitive::points, {{1.125F, 0, z, 1}}));
    EXPECT_TRUE(rasterize(scene, {}).fragments.empty()) << z;
  }
  // From the middle of the depths to twice the distance of far, beyond the right side.
  const Scene scene = of_es(scene_of(Primitive::lines, {{1.25F, 0, 0, 1}, {1.25F, 4, 4, 1}}));
  for (const Fragment& f : rasterize(scene, {}).fragments) EXPECT_LE(f.y, 7);
  const ScenePrimitive line = primitives_of(scene).front();
  EXPECT_TRUE(line.is_cut);
  EXPECT_EQ(nearest_point(line.positions[1]).y, Fixed::from_integer(8));
}

TEST(SideClipping, EachApiAgreesWithItself) {
  ClippedScenes random(34);
  int own = 0;
  for (int round = 0; round < 600; ++round) {
    const auto kind = static_cast<Primitive>(round % 4);
    Scene scene = random.scene(kind, 4, round % 3 == 0 ? kInner : kWhole);
    scene.draws[0].point_size = Fixed::from_integer(1 + round % 5);
    scene.draws[0].line_width = Fixed::from_integer(1 + round / 5 % 3);
    const SceneOfApi es(scene, true);
    if (!es.is_exact()) continue;
    own += es.is_own() ? 1 : 0;
    const Result result = judge_output(es.scene(), {}, rasterize(es.scene(), {}));
    EXPECT_EQ(result.verdict, Verdict::agree) << described(result);
    if (HasFailure()) return;
  }
  EXPECT_GT(own, 300);
}

TEST(SideClipping, APointThatOpenGlEsMustDrawMayBeDrawnByOpenGl) {
  for (const ClipPosition& clip : beside()) {
    const Scene scene = scene_of(Primitive::points, {clip});
    const Rendering whole = rasterize(of_es(scene), {});
    const Rendering none = rasterize(scene, {});
    const Result lost = judge_output(of_es(scene), {}, none);
    EXPECT_EQ(lost.verdict, Verdict::violation) << described(lost);
    EXPECT_EQ(broken_rulings(lost), Rulings{68});
    EXPECT_EQ(disagreement_causes_of(lost), Names{"point.clip=of-other-api"});
    const Result drawn = judge_output(scene, {}, whole);
    EXPECT_EQ(drawn.verdict, Verdict::convention) << described(drawn);
    EXPECT_EQ(rulings_of(drawn), Rulings{42});
    EXPECT_EQ(disagreement_causes_of(drawn), Names{"point.clip=of-other-api"});
  }
}

TEST(SideClipping, AWideLineIsCutAtTheSidesByOpenGlAlone) {
  for (const std::vector<ClipPosition>& ends : lines_along_sides()) {
    const Scene scene = scene_of(Primitive::lines, ends);
    const Rendering whole = rasterize(of_es(scene), {});
    const Rendering cut = rasterize(scene, {});
    EXPECT_LT(cut.fragments.size(), whole.fragments.size());
    const Result lost = judge_output(of_es(scene), {}, cut);
    EXPECT_EQ(lost.verdict, Verdict::violation) << described(lost);
    EXPECT_EQ(broken_rulings(lost), Rulings{68}) << described(lost);
    EXPECT_EQ(disagreement_causes_of(lost), Names{"line.clip=of-other-api"});
    // It speaks for no way to snap vertices.
    EXPECT_TRUE(lost.illegal_line_snaps.empty());
    const Result drawn = judge_output(scene, {}, whole);
    EXPECT_EQ(drawn.verdict, Verdict::violation) << described(drawn);
    EXPECT_EQ(broken_rulings(drawn).count(68), 0U);
    EXPECT_EQ(disagreement_causes_of(drawn), Names{"line.clip=of-other-api"});
  }
}

TEST(SideClipping, SamplesAreJudgedLikePixels) {
  for (const Primitive primitive : {Primitive::points, Primitive::lines}) {
    Scene scene = primitive == Primitive::points
                      ? scene_of(primitive, {{1.125F, 0.25F, 0, 1}})
                      : scene_of(primitive, {{-0.5F, 1.125F, 0, 1}, {0.75F, 1.125F, 0, 1}});
    scene.target.samples = 4;
    // So large that no other place of a sample explains it (ruling 47).
    scene.draws[0].point_size = scene.draws[0].line_width = Fixed::from_integer(11);
    const Result lost = judge_output(of_es(scene), {}, rasterize(scene, {}));
    EXPECT_EQ(lost.verdict, Verdict::violation) << described(lost);
    EXPECT_TRUE(broken_rulings(lost).contains(68)) << described(lost);
    EXPECT_EQ(judge_output(of_es(scene), {}, rasterize(of_es(scene), {})).verdict, Verdict::agree);
  }
}

// A renderer that also cuts at the viewport, as the reference of the Khronos tests does.
TEST(SideClipping, WhatLiesBeyondTheSidesMayBeLeftOut) {
  const auto judged_within = [&](const Scene& scene) {
    const Rendering whole = rasterize(scene, {});
    Scene scissored = scene;
    scissored.draws[0].scissor = kInner;
    const Rendering cut = rasterize(scissored, {});
    EXPECT_LT(cut.fragments.size(), whole.fragments.size());
    EXPECT_FALSE(cut.fragments.empty());
    Result result = compare(scene, {}, whole, cut, {8});
    Result* const alone[] = {&result};
    judge(alone, Latitude::opengl);
    return broken_rulings(result);
  };
  EXPECT_EQ(judged_within(of_es(scene_of(Primitive::points, {{1.125F, 0.25F, 0, 1}}, kInner))),
            Rulings{54});
  EXPECT_EQ(judged_within(of_es(
                scene_of(Primitive::lines, {{0.25F, 1.25F, 0, 1}, {1.5F, 1.25F, 0, 1}}, kInner))),
            Rulings{54});
}

// A line of width 1 that is cut lacks at most what rule 2 lets it lack: nobody need know where the
// clipping was done.
TEST(SideClipping, AThinLineMayBeCutWhereItLeaves) {
  ClippedScenes random(35);
  int own = 0;
  for (int round = 0; round < 2000; ++round) {
    Scene scene = random.scene(Primitive::lines, 2, kWhole);
    const SceneOfApi es(scene, true);
    if (!es.is_own() || !es.is_exact()) continue;
    const Result result = judge_output(es.scene(), {}, rasterize(scene, {}));
    ++own;
    for (const Disagreement& d : result.disagreements) {
      if (d.kind == DisagreementKind::value) continue;
      EXPECT_TRUE(is_legal(d) || d.ruling == 68) << described(result);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(own, 300);
}

TEST(SideClipping, PlacesThatAreNotExactAreNotJudged) {
  EXPECT_FALSE(SceneOfApi(scene_of(Primitive::points, {{4096, 0, 0, 1}}), true).is_exact());
  EXPECT_TRUE(SceneOfApi(scene_of(Primitive::points, {{4096, 0, 2, 1}}), true).is_exact());
  EXPECT_FALSE(SceneOfApi(scene_of(Primitive::points, {{4096, 0, 0, 1}}), false).is_own());
  EXPECT_FALSE(SceneOfApi(scene_of(Primitive::points, {{0.5F, 0, 0, 1}}), true).is_own());
  EXPECT_FALSE(
      SceneOfApi(scene_of(Primitive::triangles, {{-2, 0, 0, 1}, {0, 0, 0, 1}, {0, 1, 0, 1}}), true)
          .is_own());
}

}  // namespace
}  // namespace edgecase
