// SPDX-License-Identifier: MIT
#include "tests/diff/samples/sample_judging.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/rasterizer.h"
#include "tests/raster/multisampled_scenes.h"

namespace edgecase {

Scene partly_covered(int samples) {
  RandomPoints random(20);
  std::vector<Point> corners;
  for (int i = 0; i < 12; ++i) corners.push_back(random.point(1, 15, 32));
  Scene scene = multisampled_scene(16, samples, Primitive::triangles, corners);
  Draw& draw = scene.draws.front();
  draw.interpolation = Interpolation::smooth;
  for (std::size_t i = 0; i < draw.vertices.size(); ++i)
    draw.vertices[i].color = {static_cast<float>(i % 3 == 0), static_cast<float>(i % 3 == 1),
                              static_cast<float>(i) / 16, 0.5F};
  return scene;
}

Rendering rendered_with(const Scene& scene, const std::string& rule,
                        const std::string& alternative) {
  Rendering rendering = rasterize(scene, policy_with(rule, alternative));
  rendering.sample_positions = rasterize(scene, {}).sample_positions;
  return rendering;
}

}  // namespace edgecase
