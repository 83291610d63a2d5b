// SPDX-License-Identifier: MIT
#include "tests/diff/output/output_judging.h"

#include <fmt/format.h>

#include "raster/rasterizer.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/raster/random_operations.h"

namespace edgecase {
namespace {

void add_culling_and_offsets(Scene& scene, RandomScenes& random) {
  for (Draw& draw : scene.draws) {
    if (random.below(4) == 0) draw.cull = static_cast<CullMode>(random.below(4));
    if (scene.target.depth != DepthFormat::none && random.below(3) == 0)
      draw.polygon_offset = PolygonOffset{static_cast<float>(random.below(3) - 1),
                                          static_cast<float>(random.below(5) - 2) * 64, 0};
  }
}

}  // namespace

Scene random_output_scene(RandomScenes& random, int size) {
  Scene scene = random.next({size, Fixed::kOne / 4, 5, true});
  give_operations(scene, random);
  add_culling_and_offsets(scene, random);
  return scene;
}

Scene random_multisampled_output_scene(RandomScenes& random) {
  RandomPoints points(static_cast<std::uint64_t>(random.below(1 << 30)));
  Scene scene;
  for (int i = 0; i < 4; ++i) {
    std::vector<Point> corners;
    for (int v = 0; v < 3; ++v) corners.push_back(points.point(-1, 9, 16));
    Scene one = multisampled_scene(8, 4, Primitive::triangles, corners);
    if (i == 0) {
      scene = one;
      continue;
    }
    scene.draws.push_back(one.draws.front());
  }
  give_operations(scene, random);
  add_culling_and_offsets(scene, random);
  for (Draw& draw : scene.draws) {
    draw.interpolation = random.below(2) == 0 ? Interpolation::flat : Interpolation::smooth;
    draw.multisampling.enabled = random.below(4) != 0;
    draw.multisampling.alpha_to_coverage = random.below(4) == 0;
  }
  return scene;
}

Result judge_output(const Scene& scene, const Policy& policy, const Rendering& rendered,
                    Latitude latitude, int subpixel_bits) {
  Policy judging = policy;
  judging.latitude = latitude;
  return judged(scene, rendered, judging, subpixel_bits);
}

std::string described(const Result& result) {
  std::string text = name_of(result.verdict);
  for (std::size_t i = 0; i < result.disagreements.size() && i < 6; ++i) {
    const Disagreement& d = result.disagreements[i];
    text += fmt::format("\n({}, {}) sample {}: {}, {}: {}", d.x, d.y, d.sample, name_of(d.rule),
                        text_of(d.cause), d.explanation);
  }
  for (const ValueAggregate& v : result.values)
    text += fmt::format("\n{} {} {}: {} of {}, worst {} for {}", v.attribute, name_of(v.rule),
                        text_of(v.cause), v.differing.size(), v.compared, v.worst_rendered,
                        v.worst_exact);
  return text;
}

}  // namespace edgecase
