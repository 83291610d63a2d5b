// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "diff/compare.h"
#include "diff/coverage/coverage_compare.h"
#include "diff/coverage/legality.h"
#include "diff/judge.h"
#include "model/threads.h"
#include "profile/clipping/clipping.h"
#include "profile/coverage/coverage.h"
#include "profile/evidence/inference.h"
#include "profile/output/output.h"
#include "profile/profile.h"
#include "profile/samples/samples.h"
#include "profile/textures/textures.h"
#include "profile/values/values.h"
#include "raster/rasterizer.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

// Scenes in which a renderer does not follow its own profile, or follows it beyond the
// specification, sorted into clusters.
class CounterExamples {
 public:
  // `policy` is the profile; the reported sub-pixel bits are for ruling 4.
  CounterExamples(Policy policy, Surface surface, int reported_subpixel_bits);

  // Compares an observation with the profile and the specification, and keeps it if it fails.
  // Returns true if the profile draws every primitive as it was drawn.
  bool add(const Observation& observation);

  // Scenes with something that the specification does not allow, whatever the profile; valid after
  // clusters().
  std::size_t illegal_scenes() const { return illegal_scenes_; }
  // Judges the kept observations. Call once.
  std::vector<ProfileCluster> clusters();

 private:
  Policy policy_;
  Surface surface_;
  int bits_;
  RuleChoices choices_;
  RuleChoices standard_;
  std::vector<CaseResults> kept_;
  std::map<std::string, Scene> scenes_;  // by id
  std::size_t illegal_scenes_ = 0;
};

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

// Each subject depends on the findings of those before it.
constexpr std::array kSubjects{&kCoverageSubject, &kClippingSubject, &kValueSubject,
                               &kTextureSubject,  &kSampleSubject,   &kOutputSubject};

// The measurement of one surface.
class SurfaceMeasurement {
 public:
  SurfaceMeasurement(Surface surface, const MeasureOptions& options)
      : options_(options),
        question_{options.seed, surface, options.scenes_per_kind, options.searched_scenes} {
    profile_.surface = surface;
    findings().found = resolve(Policy{}, surface);
  }

  std::size_t total() const {
    std::size_t sum = 0;
    for (const Subject* subject : kSubjects) sum += subject->scene_count(question_.scenes_per_kind);
    return sum;
  }
  const RendererInfo& renderer() const { return info_; }
  SurfaceProfile take() { return std::move(profile_); }

  void run(Renderer& renderer, const ObservationProgress& progress) {
    for (const Subject* subject : kSubjects) {
      measure_subject(*subject, renderer, question_, progress, options_.stop, findings());
      info_ = renderer.info();
      if (findings().drawn.scenes == 0) {
        profile_.unavailable = findings().drawn.first_failure;
        return;
      }
    }
    gather_counter_examples();
  }

 private:
  SurfaceFindings& findings() { return profile_.findings; }

  void gather_counter_examples() {
    Policy policy = policy_of(findings().choices);
    policy.name = options_.name;
    CounterExamples examples(std::move(policy), profile_.surface, info_.subpixel_bits);
    for (const auto& observations : std::exchange(findings().observations, {}))
      for (const Observation& observation : observations) {
        if (options_.stop != nullptr && options_.stop->load()) throw MeasurementStopped{};
        if (observation.failure.empty()) examples.add(observation);
      }
    profile_.clusters = examples.clusters();
    profile_.illegal_scenes = examples.illegal_scenes();
  }

  const MeasureOptions& options_;
  Question question_;
  RendererInfo info_;
  SurfaceProfile profile_;
};

using Measurements = std::vector<std::unique_ptr<SurfaceMeasurement>>;

// Runs the measurements on as many threads as the options say.
void run_all(const Measurements& measurements, const MakeRenderer& make_renderer,
             const MeasureOptions& options) {
  std::size_t total = 0;
  for (const auto& measurement : measurements) total += measurement->total();
  std::atomic<std::size_t> done = 0;
  std::atomic<std::size_t> next = 0;
  const auto work = [&](std::size_t) {
    for (std::size_t i = next++; i < measurements.size(); i = next++) {
      const auto renderer = make_renderer();
      measurements[i]->run(*renderer, [&](std::size_t more) {
        const std::size_t now = done += more;
        if (options.progress) options.progress(now, total);
      });
    }
  };
  run_threads(static_cast<std::size_t>(std::max(options.jobs, 0)), work);
}

// The findings of the first surface apply to all; others list their deviations.
Policy policy_of(const Profile& profile) {
  Policy policy;
  policy.name = profile.renderer.name;
  for (const SurfaceProfile& surface : profile.surfaces) {
    const Choices& choices = surface.findings.choices;
    if (policy.rules.empty()) {
      policy.rules = choices;
      continue;
    }
    Choices own;
    for (const auto& [rule, alternative] : choices)
      if (!policy.rules.contains(rule) || policy.rules[rule] != alternative)
        own[rule] = alternative;
    if (!own.empty()) policy.surfaces[surface.surface] = std::move(own);
  }
  return policy;
}

}  // namespace

Profile measure(const MakeRenderer& make_renderer, const MeasureOptions& options) {
  Measurements measurements;
  for (const Surface surface : options.surfaces)
    measurements.push_back(std::make_unique<SurfaceMeasurement>(surface, options));
  run_all(measurements, make_renderer, options);

  Profile profile;
  profile.renderer = measurements.front()->renderer();
  profile.renderer.name = options.name;
  profile.seed = options.seed;
  profile.scenes_per_kind = options.scenes_per_kind;
  for (auto& measurement : measurements) profile.surfaces.push_back(measurement->take());
  profile.policy = policy_of(profile);
  return profile;
}

}  // namespace edgecase
