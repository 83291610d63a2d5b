// SPDX-License-Identifier: MIT
//
// Block walks of scenes: under every choice of rules they find what the rasterizer covers, or say
// why there is no walk.
#include "raster/coverage_stages.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/causes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

constexpr int kSizes[] = {8, 2};

// What the rasterizer covers, pixel by pixel. Where centres decide, bit 0.
std::vector<PixelSamples> plainly_covered(const ScenePrimitive& primitive, const Target& target,
                                          const CoverageChoice& choice) {
  const SampleCoverage coverage = covered_samples(primitive, target, choice, {});
  const bool by_sample = sampling_of(primitive, target, choice) == Unsampled::by_each_sample;
  std::map<std::pair<int, int>, std::uint32_t> masks;
  for (std::size_t s = 0; s < (by_sample ? coverage.size() : 1); ++s)
    for (PixelPosition pixel : coverage[s]) masks[{pixel.y, pixel.x}] |= std::uint32_t{1} << s;
  std::vector<PixelSamples> result;
  for (const auto& [place, mask] : masks) result.push_back({{place.second, place.first}, mask});
  return result;
}

// Policies that choose each alternative of each rule of coverage for once, with either row order.
std::vector<Policy> policies() {
  std::vector<Policy> result;
  for (const Rule& rule : all_rules())
    for (const Alternative& alternative : rule.alternatives)
      for (const char* rows : {"bottom-up", "top-down"}) {
        const std::string id = name_of(rule.id);
        if (!id.starts_with("triangle.") && !id.starts_with("sample.") && id != "subpixel.snap" &&
            id != "clip.volume" && id != "polygon.facing")
          continue;
        Policy policy;
        policy.rules["triangle.row-order"] = rows;
        policy.rules[name_of(rule.id)] = alternative.name;
        result.push_back(policy);
      }
  return result;
}

// Vertices as clip coordinates, every second one with a w of 3, so that what it lands on is a third
// of a pixel; those beyond the viewport lie outside the clip volume.
void project(Scene& scene) {
  int count = 0;
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices) {
      const float w = ++count % 2 == 0 ? 3 : 1;
      const auto half = static_cast<float>(scene.target.width) / 2;
      const auto clip = [&](Fixed window) {
        return (static_cast<float>(window.to_double()) - half) / half * (w == 3 ? 2.75F : 1);
      };
      vertex.clip = ClipPosition{clip(vertex.position.x), clip(vertex.position.y), 0, w};
      vertex.w = w;
      vertex.position = nearest_point(window_position(*vertex.clip, scene.viewport));
    }
}

struct Seen {
  std::size_t covered = 0;
  std::map<std::string, int> absences;
};

void check(const Scene& scene, const Policy& policy, Seen& seen) {
  const CoverageChoice choice = resolve(policy, scene.target.surface).triangles;
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const PrimitiveBlocks blocks = blocks_of(primitive, scene.target, choice, kSizes);
    const auto covered = plainly_covered(primitive, scene.target, choice);
    if (!blocks.absence.empty()) {
      const std::string first = blocks.absence.substr(0, 12);
      ++seen.absences[first];
      ASSERT_TRUE(blocks.walk.blocks.empty());
      // What has nothing to cover, covers nothing.
      if (first == "it has no ar" || first == "no sample li") {
        ASSERT_TRUE(covered.empty());
      }
      continue;
    }
    ASSERT_EQ(covered_samples(blocks.walk, static_cast<int>(blocks.places.size())), covered);
    seen.covered += covered.size();
  }
}

TEST(PrimitiveBlocks, FindWhatTheRasterizerCovers) {
  RandomScenes random(57);
  Seen seen;
  const std::vector<Policy> all = policies();
  for (int round = 0; round < 60; ++round) {
    Scene scene = random.next({16, 8192, 4, false});
    scene.target.samples = round % 3 == 0 ? 4 : 1;
    if (round % 2 == 0) project(scene);
    for (Draw& draw : scene.draws) {
      draw.multisampling.enabled = random.below(4) != 0;
      if (random.below(4) == 0) draw.scissor = Viewport{3, 2, 9, 11};
      if (random.below(4) == 0) draw.cull = CullMode::back;
      if (random.below(4) == 0 && draw.vertices.size() > 1) draw.vertices[0] = draw.vertices[1];
    }
    for (const Policy& policy : all) {
      check(scene, policy, seen);
      if (HasFatalFailure()) FAIL() << round;
    }
  }
  EXPECT_GT(seen.covered, 100000u);
  for (const char* absence : {"it is a poin", "it is a line", "the triangle", "it reaches o",
                              "as triangle.", "it has no ar", "no sample li"})
    EXPECT_GT(seen.absences[absence], 10) << absence;
  EXPECT_EQ(seen.absences.size(), 7u);
}

TEST(PrimitiveBlocks, ATargetSeenUpsideDownHasItsTiesTurned) {
  Scene scene = blank_scene(4, 4);
  scene.draws = {make_draw(
      Primitive::triangles,
      std::vector<Point>{at(0, 0.5), at(4, 0.5), at(4, 3.5), at(0, 0.5), at(4, 3.5), at(0, 3.5)})};
  for (const char* ties : {"left-bottom", "left-top"})
    for (const char* rows : {"bottom-up", "top-down"}) {
      Policy policy;
      policy.rules = {{"triangle.fill-rule", ties}, {"triangle.row-order", rows}};
      Seen seen;
      check(scene, policy, seen);
      // One of the rows 0 and 3.
      EXPECT_EQ(seen.covered, 12u) << ties << " " << rows;
    }
}

}  // namespace
}  // namespace edgecase
