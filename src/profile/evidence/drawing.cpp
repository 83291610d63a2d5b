// SPDX-License-Identifier: MIT
#include "profile/evidence/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

#include "diff/coverage/legality.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

std::vector<std::size_t> order_by_size(std::span<const Task> tasks) {
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Target& s = tasks[a].scene->target;
    const Target& t = tasks[b].scene->target;
    return std::tie(s.width, s.height) < std::tie(t.width, t.height);
  });
  return order;
}

// The coverage of a rendering's fragments on a multisampled target, by primitive and sample.
std::vector<SampleCoverage> covered_by_fragments(const Scene& scene, const Rendering& rendering) {
  const auto samples = static_cast<std::size_t>(scene.target.samples);
  std::vector<SampleCoverage> covered(primitives_of(scene).size(), SampleCoverage(samples));
  for (const Fragment& fragment : rendering.fragments)
    for (std::size_t s = 0; s < samples; ++s)
      if ((fragment.coverage >> s & 1) != 0)
        covered[static_cast<std::size_t>(fragment.primitive)][s].push_back(
            {fragment.x, fragment.y});
  return covered;
}

void fill_in(Observation& observation, const Outcome& outcome) {
  if (const auto* failure = std::get_if<Failure>(&outcome)) {
    observation.failure = text_of(*failure);
    return;
  }
  const auto& rendering = std::get<Rendering>(outcome);
  if (observation.scene.target.samples > 1) {
    observation.samples = covered_by_fragments(observation.scene, rendering);
    observation.positions = rendering.sample_positions;
    return;
  }
  observation.drawn.resize(primitives_of(observation.scene).size());
  for (const Fragment& fragment : rendering.fragments)
    observation.drawn[static_cast<std::size_t>(fragment.primitive)].push_back(
        {fragment.x, fragment.y});
}

}  // namespace

bool is_drawn_by(const CoverageChoice& choice, const ScenePrimitive& primitive,
                 const Observation& observation) {
  const Target& target = observation.scene.target;
  const auto index = static_cast<std::size_t>(primitive.index);
  if (target.samples == 1)
    return covered_pixels(primitive, target, choice) == observation.drawn[index];
  return covered_samples(primitive, target, choice, observation.positions) ==
         observation.samples[index];
}

DrawnCounts& DrawnCounts::operator+=(const DrawnCounts& more) {
  scenes += more.scenes;
  not_drawn += more.not_drawn;
  if (first_failure.empty()) first_failure = more.first_failure;
  return *this;
}

std::string text_of(const Failure& failure) {
  return fmt::format("{}: {}", name_of(failure.kind), failure.reason);
}

std::string scene_id(const std::string& family, std::size_t index) {
  return fmt::format("{}/{:05}", family, index);
}

std::vector<Task> tasks_of(const std::string& family, std::span<const Scene> scenes) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    tasks.push_back({scene_id(family, i), &scenes[i]});
  return tasks;
}

Scene only_primitive(const Scene& scene, int index) {
  Scene result = scene;
  result.draws.clear();
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    if (primitive.index != index) continue;
    Draw draw = *primitive.state;
    draw.primitive = primitive.kind == PrimitiveKind::triangle ? Primitive::triangles
                     : primitive.kind == PrimitiveKind::line   ? Primitive::lines
                                                               : Primitive::points;
    draw.vertices.clear();
    for (int v = 0; v < vertices_of(primitive.kind); ++v)
      draw.vertices.push_back(*primitive.vertices[static_cast<std::size_t>(v)]);
    result.draws.push_back(std::move(draw));
  }
  return result;
}

void SceneDrawing::draw(std::span<const Task> tasks, const Visit& visit, Counted counted) {
  const std::vector<std::size_t> order = order_by_size(tasks);
  std::vector<Task> ordered;
  for (const std::size_t i : order) ordered.push_back(tasks[i]);
  renderer_.render(ordered, [&](std::size_t n, Outcome outcome) {
    if (stop_ != nullptr && stop_->load()) throw MeasurementStopped{};
    const auto* failure = std::get_if<Failure>(&outcome);
    if (counted == Counted::scenes) note(failure == nullptr ? "" : text_of(*failure));
    if (counted != Counted::nothing) report(1);
    visit(order[n], std::move(outcome));
  });
}

void SceneDrawing::draw(const std::string& family, std::span<const Scene> scenes,
                        const VisitRendering& visit, Counted counted) {
  draw(
      tasks_of(family, scenes),
      [&](std::size_t i, Outcome outcome) {
        if (auto* rendering = std::get_if<Rendering>(&outcome)) visit(i, std::move(*rendering));
      },
      counted);
}

void SceneDrawing::observe(std::span<Observation> observations) {
  std::vector<Task> tasks;
  for (const Observation& one : observations)
    tasks.push_back({one.id, &one.scene, one.scene.target.samples == 1});
  draw(
      tasks, [&](std::size_t i, const Outcome& outcome) { fill_in(observations[i], outcome); },
      Counted::progress);
  for (const Observation& one : observations) note(one.failure);
}

std::vector<Observation> SceneDrawing::observed(const std::string& family,
                                                std::vector<Scene> scenes) {
  std::vector<Observation> observations(scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    observations[i].id = scene_id(family, i);
    observations[i].scene = std::move(scenes[i]);
  }
  observe(observations);
  return observations;
}

std::vector<DrawnScene> SceneDrawing::drawn(const std::string& family, std::vector<Scene> scenes) {
  std::vector<std::optional<Rendering>> renderings(scenes.size());
  draw(family, scenes,
       [&](std::size_t i, Rendering rendering) { renderings[i] = std::move(rendering); });
  std::vector<DrawnScene> result;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    if (renderings[i]) result.push_back({std::move(scenes[i]), std::move(*renderings[i])});
  return result;
}

std::string SceneDrawing::refusal_of(const Scene& scene) {
  const Task task{"refusal", &scene};
  std::string refusal;
  renderer_.render({&task, 1}, [&](std::size_t, const Outcome& outcome) {
    if (const auto* failure = std::get_if<Failure>(&outcome)) refusal = failure->reason;
  });
  report(1);
  if (refusal.empty()) ++counts_.scenes;
  return refusal;
}

int SceneDrawing::latitude_bits() const {
  return edgecase::latitude_bits(renderer_.info().subpixel_bits);
}

void SceneDrawing::report(std::size_t scenes) {
  const std::size_t more = std::min(scenes, left_);
  left_ -= more;
  if (progress_ && more > 0) progress_(more);
}

void SceneDrawing::note(const std::string& failure) {
  ++(failure.empty() ? counts_.scenes : counts_.not_drawn);
  if (counts_.first_failure.empty()) counts_.first_failure = failure;
}

}  // namespace edgecase
