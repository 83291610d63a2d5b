// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "model/threads.h"
#include "profile/clipping/clipping.h"
#include "profile/counter_examples.h"
#include "profile/coverage/coverage.h"
#include "profile/evidence/tally.h"
#include "profile/output/output.h"
#include "profile/profile.h"
#include "profile/samples/samples.h"
#include "profile/textures/textures.h"
#include "profile/values/values.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

// Each subject depends on the findings of those before it.
constexpr std::array kSubjects{&kCoverageSubject, &kClippingSubject, &kValueSubject,
                               &kTextureSubject,  &kSampleSubject,   &kOutputSubject};

// The measurement of one surface.
class SurfaceMeasurement {
 public:
  SurfaceMeasurement(Surface surface, const MeasureOptions& options)
      : options_(options), question_{options.seed, surface, options.scenes_per_kind} {
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
