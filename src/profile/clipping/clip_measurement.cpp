// SPDX-License-Identifier: MIT
#include "profile/clipping/clip_measurement.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "casefile/scene/viewport.h"
#include "generate/random_source.h"
#include "generate/scene_parts.h"
#include "profile/rule_tally.h"

namespace edgecase {
namespace {

constexpr std::size_t kShare = 100;
constexpr std::size_t kLeast = 40;
constexpr int kSize = 32;  // pixels
// Generators of one seed and different purpose have nothing in common.
constexpr std::uint64_t kStreams = 0x5f00;  // and a ClipPlace

std::size_t count_of(std::size_t scenes_per_kind) {
  return std::max(kLeast, scenes_per_kind / kShare);
}

// Sixteenths of a pixel from the centre of the target, as clip coordinates with w = 1.
float clip_of(std::int64_t sixteenths) {
  return static_cast<float>(sixteenths) / (16 * kSize / 2);
}

float inside(RandomSource& random) {
  return clip_of(random.between(-8 * kSize + 1, 8 * kSize - 1));
}

// So many pixels beyond the side, or the one across.
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

const char* name_of(ClipPlace place) {
  constexpr std::array kNames{"little", "much", "beyond-8192", "near", "far", "behind"};
  return kNames[static_cast<std::size_t>(place)];
}

Scene clip_scene(std::uint64_t seed, Surface surface, ClipPlace place, std::uint64_t index) {
  RandomSource random(seed, kStreams + static_cast<std::uint64_t>(place), index);
  Scene scene = scene_of(surface, kSize, Primitive::triangles, std::array<Point, 3>{});
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

std::size_t clip_scene_count(std::size_t scenes_per_kind) {
  return kClipPlaces * count_of(scenes_per_kind);
}

ClipFindings measure_clipping(Renderer& renderer, const ClipMeasureQuestion& question,
                              const ObservationProgress& progress, const std::atomic<bool>* stop) {
  const std::string rule = name_of(RuleId::clip_volume);
  SceneDrawing drawing(renderer, progress, stop, clip_scene_count(question.scenes_per_kind));
  ClipFindings findings;
  Tally all = tally_of(rule);
  for (int i = 0; i < kClipPlaces; ++i) {
    const auto place = static_cast<ClipPlace>(i);
    std::vector<Scene> scenes;
    for (std::size_t s = 0; s < count_of(question.scenes_per_kind); ++s)
      scenes.push_back(clip_scene(question.seed, question.surface, place, s));
    Tally tally = tally_of(rule);
    for (const Observation& seen :
         drawing.seen(std::string("clip ") + name_of(place), std::move(scenes))) {
      if (!seen.failure.empty()) continue;
      const auto primitives = primitives_of(seen.scene);
      std::vector<bool> yields;
      for (const ClipMethod method : values_of<ClipMethod>()) {
        CoverageChoice choice = question.triangles;
        choice.clip = method;
        yields.push_back(is_drawn_by(choice, primitives[0], seen));
      }
      tally.add(yields);
      all.add(yields);
    }
    findings.traits.push_back(tally.fitting(rule + ":" + name_of(place)));
  }
  findings.traits.push_back(all.fitting(rule));
  const Trait& found = findings.traits.back();
  if (found.rate.of > 0 && found.alternative != kNoneFits)
    findings.choices[rule] = found.alternative;
  drawing.finish();
  findings.drawn = drawing.counts();
  return findings;
}

}  // namespace edgecase
