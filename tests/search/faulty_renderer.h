// SPDX-License-Identifier: MIT
//
// Renderers with known faults, and what is asked of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "casefile/scene/viewport.h"
#include "model/renderer.h"
#include "raster/rasterizer.h"
#include "search/minimize.h"
#include "search/trial.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {

// What goes wrong with a scene: the rendering is changed, or there is none.
using Fault = std::function<std::optional<Failure>(const Scene&, Rendering&)>;

// The exact rasterizer under a policy, with a fault. It counts what it is asked.
class FaultyRenderer final : public Renderer {
 public:
  explicit FaultyRenderer(Fault fault, Policy policy = {})
      : fault_(std::move(fault)), policy_(std::move(policy)) {}
  const RendererInfo& info() const override {
    static const RendererInfo info{"faulty", "", "", "faulty", 8, {}};
    return info;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    ++batches;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      ++scenes;
      Rendering rendering = rasterize(*tasks[i].scene, policy_);
      auto failure = fault_ ? fault_(*tasks[i].scene, rendering) : std::nullopt;
      if (failure)
        sink(i, std::move(*failure));
      else
        sink(i, std::move(rendering));
    }
  }

  std::size_t scenes = 0;
  std::size_t batches = 0;

 private:
  Fault fault_;
  Policy policy_;
};

// Takes the fragments away of which the condition holds, as if they had never been drawn. Nothing
// else may be drawn at their pixels.
template <class Condition>
void lose(const Scene& scene, Rendering& rendering, const Condition& condition) {
  for (const Fragment& fragment : rendering.fragments) {
    if (!condition(fragment)) continue;
    const std::size_t at = rendering.pixel_index(fragment.x, fragment.y);
    rendering.hits[at] = 0;
    for (std::size_t c = 0; c < 4; ++c)
      rendering.pixels[4 * at + c] = to_unorm8(scene.target.clear[c]);
  }
  std::erase_if(rendering.fragments, condition);
}

// Loses every fragment of scenes of which the condition holds.
inline Fault blank_where(std::function<bool(const Scene&)> condition) {
  return [condition = std::move(condition)](const Scene& scene, Rendering& rendering) {
    if (condition(scene)) lose(scene, rendering, [](const Fragment&) { return true; });
    return std::optional<Failure>();
  };
}

// Loses the primitives whose first vertex lies at a point, in scenes of which the condition holds.
inline Fault lose_line_from(Point start, std::function<bool(const Scene&)> condition) {
  return [start, condition = std::move(condition)](const Scene& scene, Rendering& rendering) {
    for (const ScenePrimitive& primitive : primitives_of(scene))
      if (primitive.vertices[0]->position == start && condition(scene))
        lose(scene, rendering,
             [&](const Fragment& fragment) { return fragment.primitive == primitive.index; });
    return std::optional<Failure>();
  };
}

// Crashes at scenes of which the condition holds.
inline Fault crash_where(std::function<bool(const Scene&)> condition) {
  return [condition = std::move(condition)](const Scene& scene, Rendering&) {
    return condition(scene) ? std::optional(Failure{FailureKind::crashed, "it ended"})
                            : std::nullopt;
  };
}

// A point of sixteenths of a pixel.
inline Point sixteenths(std::int64_t x, std::int64_t y) {
  return {Fixed::from_raw(x * Fixed::kOne / 16), Fixed::from_raw(y * Fixed::kOne / 16)};
}

// Draws on a square target, all at depth 0, seen as the loader would see them.
inline Scene scene_with(int size, std::vector<Draw> draws) {
  Scene scene = blank_scene(size, size);
  scene.draws = std::move(draws);
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices) vertex.z = Fixed();
  scene.viewport = choose_viewport(scene.target, scene.draws).value();
  return scene;
}

// The first thing that the scene shows, minimised.
inline Minimized minimized(const Scene& scene, Renderer& renderer, MinimizeOptions options = {}) {
  Trial trial(renderer, {});
  return minimize(scene, trial.ask(scene).signatures.at(0), trial, options);
}

}  // namespace edgecase
