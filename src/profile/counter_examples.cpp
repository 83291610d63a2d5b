// SPDX-License-Identifier: MIT
#include "profile/counter_examples.h"

#include <algorithm>
#include <utility>

#include "diff/compare.h"
#include "diff/coverage/coverage_compare.h"
#include "diff/coverage/legality.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

std::vector<PrimitiveCoverage> coverage_under(const RuleChoices& choices, const Scene& scene,
                                              std::span<const ScenePrimitive> primitives,
                                              const Observation& observation) {
  std::vector<PrimitiveCoverage> coverage;
  for (const ScenePrimitive& primitive : primitives) {
    const auto index = static_cast<std::size_t>(primitive.index);
    const bool is_multisampled = scene.target.samples > 1;
    coverage.push_back(
        {covered_samples(primitive, scene.target, choices.of(primitive.kind),
                         observation.positions),
         is_multisampled ? observation.samples[index] : SampleCoverage{observation.drawn[index]}});
  }
  return coverage;
}

bool agrees(const PrimitiveCoverage& coverage) {
  return coverage.exact == coverage.drawn;
}

}  // namespace

CounterExamples::CounterExamples(Policy policy, Surface surface, int reported_subpixel_bits)
    : policy_(std::move(policy)),
      surface_(surface),
      bits_(latitude_bits(reported_subpixel_bits)),
      choices_(resolve(policy_, surface)),
      standard_(resolve(Policy{}, surface)) {}

bool CounterExamples::add(const Observation& observation) {
  const Scene& scene = observation.scene;
  const auto primitives = primitives_of(scene);
  const auto coverage = coverage_under(choices_, scene, primitives, observation);
  const bool follows = std::all_of(coverage.begin(), coverage.end(), agrees);
  if (follows) {
    // Pixels that the specification's own choice draws, too, are beyond doubt.
    const auto own = coverage_under(standard_, scene, primitives, observation);
    if (std::all_of(own.begin(), own.end(), agrees)) return true;
  }

  Result result;
  compare_coverage({scene, primitives, coverage, choices_, nullptr, Latitude::opengl, bits_, false,
                    observation.positions},
                   result);
  if (result.disagreements.empty()) return follows;
  CaseResults one;
  one.id = observation.id;
  one.surface = name_of(surface_);
  one.width = scene.target.width;
  one.height = scene.target.height;
  one.figure = scene_figure(scene);
  one.results.push_back(std::move(result));
  kept_.push_back(std::move(one));
  scenes_.emplace(observation.id, scene);
  return follows;
}

std::vector<ProfileCluster> CounterExamples::clusters() {
  std::vector<Result*> results;
  for (CaseResults& one : kept_) results.push_back(&one.results.front());
  judge(results, Latitude::opengl);
  illegal_scenes_ = static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(),
                    [](const Result* result) { return result->verdict == Verdict::violation; }));
  std::vector<ProfileCluster> found;
  ClusterGatherer gatherer;
  for (const CaseResults& one : kept_) gatherer.add(one, one.results.front());
  for (Cluster& cluster : gatherer.take()) {
    Scene smallest = scenes_.at(cluster.smallest_case);
    found.push_back({std::move(cluster), std::move(smallest)});
  }
  return found;
}

}  // namespace edgecase
