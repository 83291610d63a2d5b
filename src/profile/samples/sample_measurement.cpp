// SPDX-License-Identifier: MIT
#include "profile/samples/sample_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "generate/random_scenes.h"
#include "profile/inference.h"
#include "profile/samples/sample_places.h"
#include "profile/samples/sample_scenes.h"
#include "profile/samples/sample_sweeps.h"
#include "profile/samples/sample_traits.h"
#include "profile/scene_drawing.h"
#include "rules/samples/sample_mask.h"

namespace edgecase {
namespace {

// Shares of the number of random scenes of a kind, and the least numbers.
constexpr std::size_t kTriangleShare = 4;
constexpr std::size_t kLineShare = 8;
constexpr std::size_t kWideLineShare = 20;
constexpr std::size_t kLeastRandom = 100;
constexpr std::size_t kPlaneScenes = 16;  // of each question
constexpr std::size_t kResolveScenes = 4;
constexpr std::array kCounts{2, 4, 8, 16};
constexpr int kPreferred = 4;

std::size_t share_of(std::size_t scenes_per_kind, std::size_t share) {
  return std::max(kLeastRandom, scenes_per_kind / share);
}

std::vector<const Observation*> pointers(const std::vector<Observation>& observations) {
  std::vector<const Observation*> result;
  for (const Observation& observation : observations) result.push_back(&observation);
  return result;
}

class SampleMeasurement {
 public:
  SampleMeasurement(Renderer& renderer, const SampleMeasureQuestion& question,
                    const ObservationProgress& progress, const std::atomic<bool>* stop)
      : question_(question),
        drawing_(renderer, progress, stop, sample_scene_count(question.scenes_per_kind)),
        rules_(question.found) {}

  SampleFindings run() {
    if (question_.surface == Surface::window)
      findings_.profile.unavailable = "a window's samples cannot be chosen";
    else
      measure_all();
    drawing_.finish();
    findings_.drawn = drawing_.counts();
    return std::move(findings_);
  }

 private:
  void measure_all() {
    find_counts();
    if (!findings_.profile.unavailable.empty()) return;
    find_positions();
    find_triangles();
    find_lines();
    find_line_sides();
    find_mask();
    find_invocations();
    find_depths();
    find_switch();
    find_alpha();
    find_resolve();
  }

  RuleChoices found() const {
    Policy policy;
    policy.rules = rules_;
    return resolve(policy, Surface::fbo);
  }

  std::vector<Scene> planes(PrimitiveKind kind, const Multisampling& use,
                            DepthFormat depth = DepthFormat::none) const {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < kPlaneScenes; ++i)
      scenes.push_back(plane_scene(question_.seed, kind, samples_, use, depth, i));
    return scenes;
  }

  // Draws planes of triangles and of lines.
  std::vector<DrawnScene> told_planes(const std::string& family, const Multisampling& use,
                                      DepthFormat depth = DepthFormat::none) {
    std::vector<DrawnScene> all =
        drawing_.told(family, planes(PrimitiveKind::triangle, use, depth));
    for (DrawnScene& one : drawing_.told(family + " line", planes(PrimitiveKind::line, use, depth)))
      all.push_back(std::move(one));
    return all;
  }

  // A trait whose id is a rule's is followed from here on.
  void adopt(Trait trait) {
    if (trait.rate.of > 0 && trait.id.find(':') == std::string::npos) {
      rules_[trait.id] = trait.alternative;
      findings_.choices[trait.id] = trait.alternative;
    }
    findings_.traits.push_back(std::move(trait));
  }

  void adopt_sample_rule(const std::string& rule, const std::string& detail, ToldOf what,
                         std::span<const DrawnScene> told) {
    adopt(infer_sample_rule(rule, rule + detail, what, told, rules_));
  }

  void find_counts() {
    SampleProfile& profile = findings_.profile;
    for (const int samples : kCounts) {
      const Scene scene =
          plane_scene(question_.seed, PrimitiveKind::triangle, samples, {}, DepthFormat::none, 0);
      const std::string refusal = drawing_.refusal_of(scene);
      if (refusal.empty() && (samples_ == 0 || samples == kPreferred)) samples_ = samples;
      profile.counts.push_back({samples, refusal});
    }
    profile.samples = samples_;
    if (samples_ == 0) profile.unavailable = profile.counts[1].refusal;
  }

  void find_positions() {
    const Snap snap = found().triangles.snap;
    for (const AskedSamples& asked : findings_.profile.counts) {
      if (!asked.refusal.empty()) continue;
      const auto sweeps =
          drawing_.seen(fmt::format("sweep-{}", asked.samples), sweep_scenes(asked.samples));
      findings_.profile.positions.push_back(measured_positions(sweeps, snap));
      if (asked.samples != samples_) continue;
      for (const MeasuredPosition& position : findings_.profile.positions.back().positions)
        positions_.push_back(position.reported);
    }
    // Ties need some positions; whoever reports none has those of exact.
    if (positions_.empty()) positions_ = standard_pattern(samples_);
  }

  std::vector<Observation> random(MultisampledKind kind, const std::string& family,
                                  std::size_t share) {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < share_of(question_.scenes_per_kind, share); ++i)
      scenes.push_back(random_multisampled_scene(question_.seed, kind, positions_, i));
    SampleProfile& profile = findings_.profile;
    profile.random_scenes += scenes.size();
    profile.with_ties += static_cast<std::size_t>(
        std::count_if(scenes.begin(), scenes.end(),
                      [&](const Scene& scene) { return has_tie(scene, positions_); }));
    return drawing_.seen(family, std::move(scenes));
  }

  void keep(std::vector<Observation> observations) {
    std::move(observations.begin(), observations.end(), std::back_inserter(findings_.observations));
  }

  void adopt_inferred(const InferredRule& rule, const std::string& detail,
                      const std::string& single_sampled) {
    Trait trait{name_of(rule.rule) + detail,
                rule.alternative,
                rule.rate,
                rule.runner_up,
                rule.runner_up_rate,
                ""};
    if (!single_sampled.empty() && single_sampled != rule.alternative)
      trait.remark = fmt::format("not as with one sample: {}", single_sampled);
    adopt(std::move(trait));
  }

  // Scenes that are drawn as the rules found so far have it.
  Trait as_found(std::string id, const std::vector<Observation>& observations) const {
    Trait trait{std::move(id), "as the profile has them", {}, "", {}, ""};
    const RuleChoices choices = found();
    for (const Observation& observation : observations) {
      if (!observation.failure.empty()) continue;
      const auto primitives = primitives_of(observation.scene);
      ++trait.rate.of;
      if (is_drawn_by(choices.of(primitives[0].kind), primitives[0], observation))
        ++trait.rate.agreeing;
    }
    return trait;
  }

  // The rule of a single-sampled target that an inferred one is compared with; empty for others.
  std::string single_sampled(const std::string& rule) const {
    const auto found = question_.found.find(rule);
    return found == question_.found.end() ? "" : found->second;
  }

  std::string swept_placement() const {
    for (const MeasuredPositions& measured : findings_.profile.positions)
      if (measured.samples == samples_) return measured.placement;
    return "";
  }

  void find_triangles() {
    auto triangles = random(MultisampledKind::triangle, "multisampled-triangle", kTriangleShare);
    const auto all = pointers(triangles);
    const Inference placement =
        infer({PrimitiveKind::triangle, found(), OpenRules::placement}, all);
    for (const InferredRule& rule : placement.rules) adopt_inferred(rule, "", "");
    const std::string swept = swept_placement();
    if (!placement.rules.empty() && swept != placement.rules[0].alternative)
      findings_.traits.back().remark =
          fmt::format("sweeps find {}", swept.empty() ? "nothing catalogued" : swept);
    const Inference inference =
        infer({PrimitiveKind::triangle, placement.choice, OpenRules::coverage}, all);
    for (const InferredRule& rule : inference.rules)
      adopt_inferred(rule, ":multisampled", single_sampled(name_of(rule.rule)));
    adopt(as_found("triangle.coverage:multisampled", triangles));
    keep(std::move(triangles));
  }

  void find_lines() {
    auto lines = random(MultisampledKind::line, "multisampled-line", kLineShare);
    const Inference inference =
        infer({PrimitiveKind::line, found(), OpenRules::coverage}, pointers(lines));
    for (const InferredRule& rule : inference.rules)
      if (rule.rule == RuleId::line_multisampled)
        adopt_inferred(rule, "", "");
      else
        adopt_inferred(rule, ":multisampled-lines", single_sampled(name_of(rule.rule)));
    adopt(as_found("line.coverage:multisampled", lines));
    keep(std::move(lines));
    auto wide = random(MultisampledKind::wide_line, "multisampled-wide-line", kWideLineShare);
    adopt(as_found("line.coverage:multisampled-wide", wide));
    keep(std::move(wide));
  }

  void find_line_sides() {
    const auto probes = line_side_probes(positions_);
    std::vector<Scene> scenes;
    for (const LineSideProbe& probe : probes) scenes.push_back(probe.scene);
    const auto observations = drawing_.seen("line-side-probe", std::move(scenes));
    findings_.tables.push_back(line_side_table(probes, observations));
    adopt(line_side_trait(probes, observations, found().lines));
  }

  void find_mask() {
    std::vector<Scene> masked;
    for (std::size_t i = 0; i < kPlaneScenes; ++i) {
      Multisampling use;
      use.mask = static_cast<std::uint32_t>(5 * i + 1) & mask_of_all(samples_);
      for (const PrimitiveKind kind : {PrimitiveKind::triangle, PrimitiveKind::line})
        masked.push_back(plane_scene(question_.seed, kind, samples_, use, DepthFormat::none, i));
    }
    const auto masks = drawing_.told("sample-mask", std::move(masked));
    adopt_sample_rule(name_of(RuleId::sample_mask), "", ToldOf::invocations, masks);
    adopt_sample_rule(name_of(RuleId::sample_mask), ":writes", ToldOf::writes, masks);
  }

  void find_invocations() {
    std::vector<DrawnScene> all;
    std::vector<DrawnScene> plain;
    std::vector<DrawnScene> centroid;
    for (const InvocationsAsked& asked : ways_to_ask_for_invocations()) {
      InvocationRow row = empty_row(asked, samples_);
      const std::string family = fmt::format("{} {}", asked.name, row.location);
      std::vector<DrawnScene> drawn =
          drawing_.told(family, planes(PrimitiveKind::triangle, asked.use));
      for (const DrawnScene& one : drawn) add_invocations(one.rendering, row);
      if (asked.name == "once")
        (asked.use.location == AttributeLocation::center ? plain : centroid) = drawn;
      std::move(drawn.begin(), drawn.end(), std::back_inserter(all));
      findings_.profile.invocations.push_back(std::move(row));
    }
    adopt_sample_rule(name_of(RuleId::sample_shading_rate), "", ToldOf::invocations, all);
    // Whether lines have their attributes elsewhere is told by lines alone.
    auto lines = drawing_.told("once line", planes(PrimitiveKind::line, {}));
    find_line_parameter(lines);
    std::move(lines.begin(), lines.end(), std::back_inserter(plain));
    adopt_sample_rule(name_of(RuleId::attribute_location), "", ToldOf::colors, plain);
    adopt_sample_rule(name_of(RuleId::attribute_centroid), "", ToldOf::colors, centroid);
  }

  // Multisampled lines may be interpolated otherwise than those of one sample; what follows is
  // about multisampled ones alone.
  void find_line_parameter(std::span<const DrawnScene> lines) {
    Trait trait = infer_line_parameter(lines, rules_);
    if (trait.rate.of > 0) {
      const std::string before = single_sampled(name_of(RuleId::attribute_smooth));
      if (!before.empty() && before != trait.alternative)
        trait.remark = fmt::format("not as with one sample: {}", before);
      rules_[name_of(RuleId::attribute_smooth)] = trait.alternative;
    }
    adopt(std::move(trait));
  }

  void find_depths() {
    auto depths = told_planes("depth", {}, DepthFormat::depth32f);
    // What follows from a mask without sample 0 is a fault of its own.
    Multisampling masked;
    masked.mask = mask_of_all(samples_) - 1;
    for (DrawnScene& one : told_planes("depth masked", masked, DepthFormat::depth32f))
      depths.push_back(std::move(one));
    adopt_sample_rule(name_of(RuleId::sample_depth), "", ToldOf::all_depths, depths);
    adopt_sample_rule(name_of(RuleId::sample_depth), ":fragment", ToldOf::fragment_depths, depths);
  }

  // Depths tell of it, too: where samples have theirs must be known.
  void find_switch() {
    Multisampling off;
    off.enabled = false;
    const auto all = told_planes("multisampling-off", off, DepthFormat::depth32f);
    adopt_sample_rule(name_of(RuleId::sample_enable), "", ToldOf::switched_off, all);
    adopt_sample_rule(name_of(RuleId::sample_enable), ":writes", ToldOf::writes, all);
  }

  void find_alpha() {
    const std::vector<float> alphas = probing_alphas(samples_);
    std::vector<Scene> scenes;
    for (std::size_t from = 0; from < alphas.size(); from += kAlphasPerScene)
      scenes.push_back(alpha_scene(
          samples_,
          std::span(alphas).subspan(from, std::min(kAlphasPerScene, alphas.size() - from))));
    std::vector<DrawnScene> told_alphas = drawing_.told("alpha", std::move(scenes));
    findings_.profile.alphas = alpha_runs(told_alphas);
    for (DrawnScene& one : drawing_.told("alpha plane", alpha_planes(false)))
      told_alphas.push_back(std::move(one));
    const auto per_sample = drawing_.told("alpha per sample", alpha_planes(true));
    told_alphas.insert(told_alphas.end(), per_sample.begin(), per_sample.end());
    adopt_sample_rule(name_of(RuleId::sample_alpha_to_coverage), "", ToldOf::writes, told_alphas);
    adopt(own_alpha_trait(per_sample, found().samples.alpha_to_coverage));
  }

  std::vector<Scene> alpha_planes(bool is_per_sample) const {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < kPlaneScenes; ++i)
      scenes.push_back(alpha_plane_scene(question_.seed, samples_, is_per_sample, i));
    return scenes;
  }

  void find_resolve() {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < kResolveScenes; ++i)
      scenes.push_back(resolve_scene(question_.seed, samples_, i));
    adopt(infer_resolve(drawing_.told("resolve", std::move(scenes))));
  }

  const SampleMeasureQuestion& question_;
  SceneDrawing drawing_;
  Choices rules_;  // those found, of one sample and of several
  int samples_ = 0;
  SamplePositions positions_;
  SampleFindings findings_;
};

}  // namespace

std::size_t sample_scene_count(std::size_t scenes_per_kind) {
  const std::size_t random = share_of(scenes_per_kind, kTriangleShare) +
                             share_of(scenes_per_kind, kLineShare) +
                             share_of(scenes_per_kind, kWideLineShare);
  const std::size_t probes = line_side_probes(standard_pattern(kPreferred)).size();
  const std::size_t alphas = (probing_alphas(kPreferred).size() - 1) / kAlphasPerScene + 1;
  // Planes of invocations, and those of eleven questions more.
  const std::size_t planes = (ways_to_ask_for_invocations().size() + 11) * kPlaneScenes;
  return kCounts.size() + kSweepScenes + random + probes + planes + alphas + kResolveScenes;
}

SampleFindings measure_samples(Renderer& renderer, const SampleMeasureQuestion& question,
                               const ObservationProgress& progress, const std::atomic<bool>* stop) {
  return SampleMeasurement(renderer, question, progress, stop).run();
}

}  // namespace edgecase
