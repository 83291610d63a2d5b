// SPDX-License-Identifier: MIT
#include "profile/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>

#include "diff/coverage/legality.h"
#include "generate/random_scenes.h"
#include "profile/clipping/clip_measurement.h"
#include "profile/counter_examples.h"
#include "profile/output/output_measurement.h"
#include "profile/probes/probe_scenes.h"
#include "profile/probes/probe_traits.h"
#include "profile/samples/sample_measurement.h"
#include "profile/textures/texture_measurement.h"
#include "profile/values/value_measurement.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

constexpr std::array kKinds = {PrimitiveKind::point, PrimitiveKind::triangle, PrimitiveKind::line};
// Shares of the number of random scenes of a kind.
constexpr std::size_t kWideLineShare = 10;
constexpr std::size_t kSharedEdgeShare = 4;

using Observations = std::vector<Observation>;

template <class Probe>
Observations observations_of(const std::vector<Probe>& probes, const char* family) {
  Observations result(probes.size());
  for (std::size_t i = 0; i < probes.size(); ++i) {
    result[i].id = fmt::format("{}/{:05}", family, i);
    result[i].scene = probes[i].scene;
  }
  return result;
}

template <class MakeScene>
Observations random_observations(std::size_t count, const std::string& family, MakeScene make) {
  Observations result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i].id = fmt::format("{}/{:05}", family, i);
    result[i].scene = make(i);
  }
  return result;
}

// All scenes that one surface is measured with.
struct Scenes {
  std::vector<DiamondProbe> diamonds;
  std::vector<EdgeProbe> edges;
  std::vector<JointProbe> joints;
  std::vector<SharedEdgeProbe> shared_edges;
  std::vector<ClipProbe> clips;
  std::vector<Scene> provoking;

  std::array<Observations, 3> random;  // in the order of kKinds
  Observations wide_lines;
  Observations random_shared_edges;
  Observations seen_diamonds;
  Observations seen_edges;
  Observations seen_joints;
  Observations seen_shared_edges;
  Observations seen_clips;
  Observations seen_unclipped;

  Scenes(Surface surface, std::uint64_t seed, std::size_t count)
      : diamonds(diamond_probes(surface)),
        edges(edge_probes(surface)),
        joints(joint_probes(surface)),
        shared_edges(shared_edge_probes(surface)),
        clips(clip_probes(surface)),
        provoking(provoking_probes(surface)) {
    for (std::size_t k = 0; k < kKinds.size(); ++k)
      random[k] = random_observations(count, name_of(kKinds[k]), [&](std::size_t i) {
        return random_scene({seed, kKinds[k], surface}, i);
      });
    wide_lines = random_observations(count / kWideLineShare, "wide-line", [&](std::size_t i) {
      return random_wide_line(seed, surface, i);
    });
    random_shared_edges =
        random_observations(count / kSharedEdgeShare, "shared-edge",
                            [&](std::size_t i) { return shared_edge_scene(seed, surface, i); });
    seen_diamonds = observations_of(diamonds, "diamond-probe");
    seen_edges = observations_of(edges, "edge-probe");
    seen_joints = observations_of(joints, "joint-probe");
    seen_shared_edges = observations_of(shared_edges, "shared-edge-probe");
    seen_clips = observations_of(clips, "clip-probe");
    seen_unclipped = observations_of(clips, "unclipped-probe");
    for (std::size_t i = 0; i < clips.size(); ++i) seen_unclipped[i].scene = clips[i].unclipped;
  }

  std::vector<Observations*> all() {
    std::vector<Observations*> result;
    for (Observations& observations : random) result.push_back(&observations);
    for (Observations* observations :
         {&wide_lines, &random_shared_edges, &seen_diamonds, &seen_edges, &seen_joints,
          &seen_shared_edges, &seen_clips, &seen_unclipped})
      result.push_back(observations);
    return result;
  }
};

bool is_one_primitive(const Draw& draw) {
  return draw.vertices.size() == static_cast<std::size_t>(vertices_of(kind_of(draw.primitive)));
}

// The measurement of one surface.
class SurfaceMeasurement {
 public:
  SurfaceMeasurement(Surface surface, const MeasureOptions& options)
      : options_(options), scenes_(surface, options.seed, options.scenes_per_kind) {
    profile_.surface = surface;
    for (const Observations* observations : scenes_.all()) total_ += observations->size();
    total_ += clip_scene_count(options.scenes_per_kind);
    total_ += value_scene_count(options.scenes_per_kind);
    total_ += texture_scene_count(options.scenes_per_kind);
    total_ += sample_scene_count(options.scenes_per_kind);
    total_ += output_scene_count(options.scenes_per_kind);
  }

  std::size_t total() const { return total_; }
  const RendererInfo& renderer() const { return info_; }
  // The rules that were found to be followed.
  const Choices& choices() const { return choices_; }
  SurfaceProfile take() { return std::move(profile_); }

  void run(Renderer& renderer, const ObservationProgress& progress) {
    for (Observations* observations : scenes_.all())
      observe(renderer, *observations, progress, options_.stop);
    provoking_outcomes_ = render_all(renderer, scenes_.provoking, options_.stop);
    info_ = renderer.info();
    count_scenes();
    if (profile_.scenes == 0) {
      profile_.unavailable = profile_.first_failure;
      return;
    }
    infer_choices();
    ask_probes();
    ask_clipping(renderer, progress);
    ask_values(renderer, progress);
    ask_textures(renderer, progress);
    ask_samples(renderer, progress);
    ask_output(renderer, progress);
    gather_counter_examples();
  }

 private:
  void count_scenes() {
    for (const Observations* observations : scenes_.all())
      for (const Observation& observation : *observations) {
        ++(observation.failure.empty() ? profile_.scenes : profile_.not_drawn);
        if (profile_.first_failure.empty()) profile_.first_failure = observation.failure;
      }
    for (const Observations& observations : scenes_.random)
      for (const Observation& observation : observations) {
        ++profile_.random_scenes;
        if (has_tie(observation.scene)) ++profile_.with_ties;
      }
  }

  void count(const DrawnCounts& drawn) {
    profile_.scenes += drawn.scenes;
    profile_.not_drawn += drawn.not_drawn;
    if (profile_.first_failure.empty()) profile_.first_failure = drawn.first_failure;
  }

  void adopt(const Inference& inference) {
    for (const InferredRule& rule : inference.rules) {
      choices_[name_of(rule.rule)] = rule.alternative;
      profile_.traits.push_back({name_of(rule.rule), rule.alternative, rule.rate, rule.runner_up,
                                 rule.runner_up_rate, ""});
    }
  }

  // What a kind of primitive is judged by: the random scenes, and those probes of clipping that a
  // large viewport holds whole, which alone have vertices left of and below the target.
  std::vector<const Observation*> scenes_for(PrimitiveKind kind) const {
    std::vector<const Observation*> result;
    for (std::size_t k = 0; k < kKinds.size(); ++k)
      if (kKinds[k] == kind)
        for (const Observation& observation : scenes_.random[k]) result.push_back(&observation);
    for (const Observation& observation : scenes_.seen_unclipped) {
      const Draw& draw = observation.scene.draws[0];
      const bool plain = draw.line_width == Fixed::from_integer(1);
      if (kind_of(draw.primitive) == kind && plain && observation.scene.draws.size() == 1 &&
          is_one_primitive(draw))
        result.push_back(&observation);
    }
    return result;
  }

  void infer_choices() {
    found_ = resolve(Policy{}, profile_.surface);
    for (std::size_t k = 0; k < kKinds.size(); ++k) {
      CoverageChoice& choice = kKinds[k] == PrimitiveKind::point  ? found_.points
                               : kKinds[k] == PrimitiveKind::line ? found_.lines
                                                                  : found_.triangles;
      // Lines that are areas have their ties decided as triangles have.
      if (kKinds[k] == PrimitiveKind::line) choice.ties = found_.triangles.ties;
      const Inference inference =
          infer({kKinds[k], found_, OpenRules::coverage}, scenes_for(kKinds[k]));
      choice = inference.choice.of(kKinds[k]);
      adopt(inference);
    }
    std::vector<const Observation*> wide_lines;
    for (const Observation& observation : scenes_.wide_lines) wide_lines.push_back(&observation);
    const Inference wide = infer({PrimitiveKind::line, found_, OpenRules::width}, wide_lines);
    found_.lines = wide.choice.lines;
    adopt(wide);
  }

  void ask_probes() {
    auto& traits = profile_.traits;
    const Seen<DiamondProbe> diamonds{scenes_.diamonds, scenes_.seen_diamonds};
    traits.push_back(diamond_trait(diamonds, found_.lines));
    profile_.tables = diamond_tables(diamonds);
    const Seen<EdgeProbe> edges{scenes_.edges, scenes_.seen_edges};
    traits.push_back(edge_trait(edges, found_.triangles));
    for (OwnershipTable& table : edge_tables(edges)) profile_.tables.push_back(std::move(table));
    for (Trait& trait : joint_traits({scenes_.joints, scenes_.seen_joints}, found_.lines))
      traits.push_back(std::move(trait));
    Observations shared = scenes_.seen_shared_edges;
    shared.insert(shared.end(), scenes_.random_shared_edges.begin(),
                  scenes_.random_shared_edges.end());
    traits.push_back(shared_edge_trait(shared, latitude_bits(info_.subpixel_bits)));
    for (Trait& trait : clip_traits({scenes_.clips, scenes_.seen_clips}, scenes_.seen_unclipped))
      traits.push_back(std::move(trait));
    traits.push_back(provoking_trait(scenes_.provoking, provoking_outcomes_));
    if (traits.back().alternative != "as-set")
      choices_[name_of(RuleId::attribute_provoking_vertex)] = traits.back().alternative;
    found_.values.provoking = traits.back().alternative == "first"  ? ProvokingChoice::first
                              : traits.back().alternative == "last" ? ProvokingChoice::last
                                                                    : ProvokingChoice::as_set;
  }

  void ask_clipping(Renderer& renderer, const ObservationProgress& progress) {
    const ClipMeasureQuestion question{options_.seed, profile_.surface, options_.scenes_per_kind,
                                       found_.triangles};
    ClipFindings findings = measure_clipping(renderer, question, progress, options_.stop);
    for (Trait& trait : findings.traits) profile_.traits.push_back(std::move(trait));
    choices_.merge(findings.choices);
    count(findings.drawn);
  }

  void ask_values(Renderer& renderer, const ObservationProgress& progress) {
    const ValueQuestion question{options_.seed, profile_.surface, options_.scenes_per_kind, found_,
                                 latitude_bits(info_.subpixel_bits)};
    ValueFindings findings = measure_values(renderer, question, progress, options_.stop);
    for (Trait& trait : findings.traits) profile_.traits.push_back(std::move(trait));
    choices_.merge(findings.choices);
    // Textures are looked up at what is interpolated so, and in the same quads.
    Policy policy;
    policy.rules = choices_;
    found_.values = resolve(policy, profile_.surface).values;
    profile_.values = std::move(findings.errors);
    count({findings.scenes, findings.not_drawn, findings.first_failure});
  }

  void ask_textures(Renderer& renderer, const ObservationProgress& progress) {
    const TextureMeasureQuestion question{options_.seed, profile_.surface, options_.scenes_per_kind,
                                          found_};
    TextureFindings findings = measure_textures(renderer, question, progress, options_.stop);
    for (Trait& trait : findings.traits) profile_.traits.push_back(std::move(trait));
    choices_.merge(findings.choices);
    profile_.levels = std::move(findings.residuals);
    count({findings.scenes, findings.not_drawn, findings.first_failure});
  }

  void ask_samples(Renderer& renderer, const ObservationProgress& progress) {
    const SampleMeasureQuestion question{options_.seed, profile_.surface, options_.scenes_per_kind,
                                         choices_};
    SampleFindings findings = measure_samples(renderer, question, progress, options_.stop);
    for (Trait& trait : findings.traits) profile_.traits.push_back(std::move(trait));
    for (OwnershipTable& table : findings.tables) profile_.tables.push_back(std::move(table));
    choices_.merge(findings.choices);
    profile_.samples = std::move(findings.profile);
    multisampled_ = std::move(findings.observations);
    count(findings.drawn);
  }

  void ask_output(Renderer& renderer, const ObservationProgress& progress) {
    const OutputMeasureQuestion question{options_.seed, profile_.surface, options_.scenes_per_kind,
                                         choices_};
    OutputFindings findings = measure_output(renderer, question, progress, options_.stop);
    for (Trait& trait : findings.traits) profile_.traits.push_back(std::move(trait));
    choices_.merge(findings.choices);
    profile_.output = std::move(findings.profile);
    count(findings.drawn);
  }

  void gather_counter_examples() {
    Policy policy;
    policy.name = options_.name;
    policy.rules = choices_;
    CounterExamples examples(std::move(policy), profile_.surface, info_.subpixel_bits);
    std::vector<Observations*> all = scenes_.all();
    all.push_back(&multisampled_);
    for (const Observations* observations : all) {
      // Whether clipping moves fragments is a trait; what it does is not catalogued yet.
      if (observations == &scenes_.seen_clips || observations == &scenes_.seen_unclipped) continue;
      for (const Observation& observation : *observations) {
        if (options_.stop != nullptr && options_.stop->load()) throw MeasurementStopped{};
        if (observation.failure.empty()) examples.add(observation);
      }
    }
    profile_.clusters = examples.clusters();
    profile_.illegal_scenes = examples.illegal_scenes();
  }

  const MeasureOptions& options_;
  Scenes scenes_;
  std::vector<Outcome> provoking_outcomes_;
  Observations multisampled_;
  std::size_t total_ = 0;
  RendererInfo info_;
  RuleChoices found_;
  Choices choices_;
  SurfaceProfile profile_;
};

// What holds on the first surface holds for all; others say where they differ.
Policy policy_of(const std::vector<std::unique_ptr<SurfaceMeasurement>>& measurements,
                 const MeasureOptions& options) {
  Policy policy;
  policy.name = options.name;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    const Choices& choices = measurements[i]->choices();
    if (policy.rules.empty()) {
      policy.rules = choices;
      continue;
    }
    Choices& own = policy.surfaces[options.surfaces[i]];
    for (const auto& [rule, alternative] : choices)
      if (!policy.rules.contains(rule) || policy.rules[rule] != alternative)
        own[rule] = alternative;
    if (own.empty()) policy.surfaces.erase(options.surfaces[i]);
  }
  return policy;
}

}  // namespace

Profile measure(const MakeRenderer& make_renderer, const MeasureOptions& options) {
  std::vector<std::unique_ptr<SurfaceMeasurement>> measurements;
  std::size_t total = 0;
  for (Surface surface : options.surfaces) {
    measurements.push_back(std::make_unique<SurfaceMeasurement>(surface, options));
    total += measurements.back()->total();
  }

  std::atomic<std::size_t> done = 0;
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    for (std::size_t i = next++; i < measurements.size(); i = next++) {
      try {
        const auto renderer = make_renderer();
        measurements[i]->run(*renderer, [&](std::size_t more) {
          const std::size_t now = done += more;
          if (options.progress) options.progress(now, total);
        });
      } catch (...) {
        const std::lock_guard lock(mutex);
        error = std::current_exception();
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < options.jobs; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  if (error) std::rethrow_exception(error);

  Profile profile;
  profile.renderer = measurements.front()->renderer();
  profile.renderer.name = options.name;
  profile.seed = options.seed;
  profile.scenes_per_kind = options.scenes_per_kind;
  profile.policy = policy_of(measurements, options);
  for (auto& measurement : measurements) profile.surfaces.push_back(measurement->take());
  return profile;
}

}  // namespace edgecase
