// SPDX-License-Identifier: MIT
#include "profile/observation.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <variant>

#include "raster/rasterizer.h"

namespace edgecase {
namespace {

std::vector<std::vector<PixelPosition>> drawn_of(const Scene& scene, const Rendering& rendering) {
  std::vector<std::vector<PixelPosition>> drawn(primitives_of(scene).size());
  for (const Fragment& fragment : rendering.fragments)
    drawn[static_cast<std::size_t>(fragment.primitive)].push_back({fragment.x, fragment.y});
  return drawn;
}

void take(const Rendering& rendering, Observation& observation) {
  if (observation.scene.target.samples == 1) {
    observation.drawn = drawn_of(observation.scene, rendering);
    return;
  }
  observation.samples = covered_by_fragments(observation.scene, rendering);
  observation.positions = rendering.sample_positions;
}

void check(const std::atomic<bool>* stop) {
  if (stop != nullptr && stop->load()) throw MeasurementStopped{};
}

}  // namespace

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

bool is_drawn_by(const CoverageChoice& choice, const ScenePrimitive& primitive,
                 const Observation& observation) {
  const Target& target = observation.scene.target;
  const auto index = static_cast<std::size_t>(primitive.index);
  if (target.samples == 1)
    return covered_pixels(primitive, target, choice) == observation.drawn[index];
  return covered_samples(primitive, target, choice, observation.positions) ==
         observation.samples[index];
}

void observe(Renderer& renderer, std::span<Observation> observations,
             const ObservationProgress& progress, const std::atomic<bool>* stop) {
  // Scenes of one size together: some window systems pay for every change of size.
  std::vector<Observation*> by_size;
  for (Observation& observation : observations) by_size.push_back(&observation);
  std::stable_sort(by_size.begin(), by_size.end(), [](const Observation* a, const Observation* b) {
    const Target& s = a->scene.target;
    const Target& t = b->scene.target;
    return std::tie(s.width, s.height) < std::tie(t.width, t.height);
  });
  std::vector<Task> tasks;
  for (const Observation* observation : by_size)
    tasks.push_back({observation->id, &observation->scene, observation->scene.target.samples == 1});
  renderer.render(tasks, [&](std::size_t index, Outcome outcome) {
    check(stop);
    Observation& observation = *by_size[index];
    if (const auto* failure = std::get_if<Failure>(&outcome))
      observation.failure = fmt::format("{}: {}", name_of(failure->kind), failure->reason);
    else
      take(std::get<Rendering>(outcome), observation);
    if (progress) progress(1);
  });
}

std::vector<Outcome> render_all(Renderer& renderer, std::span<const Scene> scenes,
                                const std::atomic<bool>* stop) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    tasks.push_back({fmt::format("probe/{}", i), &scenes[i]});
  std::vector<Outcome> outcomes(scenes.size(), Failure{});
  renderer.render(tasks, [&](std::size_t index, Outcome outcome) {
    check(stop);
    outcomes[index] = std::move(outcome);
  });
  return outcomes;
}

}  // namespace edgecase
