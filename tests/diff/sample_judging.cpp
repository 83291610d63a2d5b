// SPDX-License-Identifier: MIT
#include "tests/diff/sample_judging.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/support/causes.h"

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

Policy policy_with(const std::string& rule, const std::string& alternative) {
  Policy policy;
  policy.rules[rule] = alternative;
  return policy;
}

Result judged(const Scene& scene, const Rendering& rendered) {
  const Rendering exact = rasterize(scene, {}, rendered.sample_positions);
  Result result = compare(scene, {}, exact, rendered, {8, nullptr});
  Result* const only = &result;
  judge({&only, 1}, Latitude::opengl);
  return result;
}

Rendering rendered_with(const Scene& scene, const std::string& rule,
                        const std::string& alternative) {
  Rendering rendering = rasterize(scene, policy_with(rule, alternative));
  rendering.sample_positions = rasterize(scene, {}).sample_positions;
  return rendering;
}

std::set<std::string> causes_of(const Result& result) {
  std::set<std::string> causes;
  for (const Disagreement& d : result.disagreements) causes.insert(text_of(d.cause));
  for (const ValueAggregate& v : result.values) causes.insert(text_of(v.cause));
  return causes;
}

std::set<std::string> rules_of(const Result& result) {
  std::set<std::string> rules;
  for (const Disagreement& d : result.disagreements) rules.insert(name_of(d.rule));
  return rules;
}

}  // namespace edgecase
