// SPDX-License-Identifier: MIT
#include "profile/samples/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "generate/random_scenes.h"
#include "profile/evidence/inference.h"
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

void append(std::vector<DrawnScene>& all, std::vector<DrawnScene> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

class SampleMeasurement {
 public:
  SampleMeasurement(const Question& question, SceneDrawing& drawing, SurfaceFindings& findings)
      : question_(question),
        drawing_(drawing),
        single_sampled_(findings.choices),
        rules_(findings.choices),
        findings_(findings),
        profile_(findings.samples) {}

  void run() {
    if (question_.surface == Surface::window) {
      profile_.unavailable = "a window's samples cannot be chosen";
      return;
    }
    find_counts();
    if (!profile_.unavailable.empty()) return;
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

 private:
  RuleChoices found() const { return resolve(policy_of(rules_), Surface::fbo); }

  std::vector<Scene> planes(PrimitiveKind kind, const Multisampling& use,
                            DepthFormat depth = DepthFormat::none) const {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < kPlaneScenes; ++i)
      scenes.push_back(plane_scene(question_.seed, kind, samples_, use, depth, i));
    return scenes;
  }

  // Draws planes of triangles and of lines.
  std::vector<DrawnScene> drawn_planes(const std::string& family, const Multisampling& use,
                                       DepthFormat depth = DepthFormat::none) {
    std::vector<DrawnScene> all =
        drawing_.drawn(family, planes(PrimitiveKind::triangle, use, depth));
    append(all, drawing_.drawn(family + " line", planes(PrimitiveKind::line, use, depth)));
    return all;
  }

  // If a trait names a rule, its alternative is followed from here on.
  void adopt(Trait trait) {
    if (trait.id.is_rule() && trait.rate.of > 0) rules_[name_of(trait.id.rule)] = trait.alternative;
    findings_.adopt(std::move(trait));
  }

  void adopt_sample_rule(const TraitId& id, SampleEvidence evidence,
                         std::span<const DrawnScene> scenes) {
    adopt(infer_sample_rule(id, evidence, scenes, rules_));
  }

  // Adds a remark if a rule has another alternative on targets with one sample.
  void remark_on_difference(Trait& trait) const {
    const auto before = single_sampled_.find(name_of(trait.id.rule));
    if (before != single_sampled_.end() && before->second != trait.alternative)
      trait.remark = fmt::format("not as with one sample: {}", before->second);
  }

  void find_counts() {
    for (const int samples : kCounts) {
      const Scene scene =
          plane_scene(question_.seed, PrimitiveKind::triangle, samples, {}, DepthFormat::none, 0);
      const std::string refusal = drawing_.refusal_of(scene);
      if (refusal.empty() && (samples_ == 0 || samples == kPreferred)) samples_ = samples;
      profile_.counts.push_back({samples, refusal});
    }
    profile_.samples = samples_;
    if (samples_ == 0) profile_.unavailable = profile_.counts[1].refusal;
  }

  void find_positions() {
    const Snap snap = found().triangles.snap;
    for (const AskedSamples& asked : profile_.counts) {
      if (!asked.refusal.empty()) continue;
      const auto sweeps =
          drawing_.observed(fmt::format("sweep-{}", asked.samples), sweep_scenes(asked.samples));
      profile_.positions.push_back(measured_positions(sweeps, snap));
      if (asked.samples != samples_) continue;
      for (const MeasuredPosition& position : profile_.positions.back().positions)
        positions_.push_back(position.reported);
    }
    // Ties need positions: if none are reported, exact's are used.
    if (positions_.empty()) positions_ = standard_pattern(samples_);
  }

  std::vector<Observation> random(MultisampledKind kind, const std::string& family,
                                  std::size_t share) {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < share_of(question_.scenes_per_kind, share); ++i)
      scenes.push_back(random_multisampled_scene(question_.seed, kind, positions_, i));
    profile_.random_scenes += scenes.size();
    profile_.with_ties += static_cast<std::size_t>(
        std::count_if(scenes.begin(), scenes.end(),
                      [&](const Scene& scene) { return has_tie(scene, positions_); }));
    return drawing_.observed(family, std::move(scenes));
  }

  // `probe`: for a rule that also applies to single-sampled targets.
  void adopt_inferred(const InferredRule& rule, const std::string& probe = "") {
    Trait trait{
        {rule.rule, probe}, rule.alternative, rule.rate, rule.runner_up, rule.runner_up_rate};
    if (!probe.empty()) remark_on_difference(trait);
    adopt(std::move(trait));
  }

  // The share of scenes drawn as under the rules found so far.
  Trait as_found(const char* question, const std::vector<Observation>& observations) const {
    Trait trait{TraitId(question), "as the profile has them"};
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

  std::string swept_placement() const {
    for (const MeasuredPositions& measured : profile_.positions)
      if (measured.samples == samples_) return measured.placement;
    return "";
  }

  void find_triangles() {
    auto triangles = random(MultisampledKind::triangle, "multisampled-triangle", kTriangleShare);
    const auto all = pointers(triangles);
    const Inference placement =
        infer({PrimitiveKind::triangle, found(), OpenRules::placement}, all);
    for (const InferredRule& rule : placement.rules) adopt_inferred(rule);
    const std::string swept = swept_placement();
    if (!placement.rules.empty() && swept != placement.rules[0].alternative)
      findings_.traits.back().remark =
          fmt::format("sweeps find {}", swept.empty() ? "nothing catalogued" : swept);
    const Inference inference =
        infer({PrimitiveKind::triangle, placement.choice, OpenRules::coverage}, all);
    for (const InferredRule& rule : inference.rules) adopt_inferred(rule, "multisampled");
    adopt(as_found("triangle.coverage:multisampled", triangles));
    findings_.observations.push_back(std::move(triangles));
  }

  void find_lines() {
    auto lines = random(MultisampledKind::line, "multisampled-line", kLineShare);
    const Inference inference =
        infer({PrimitiveKind::line, found(), OpenRules::coverage}, pointers(lines));
    for (const InferredRule& rule : inference.rules)
      if (rule.rule == RuleId::line_multisampled)
        adopt_inferred(rule);
      else
        adopt_inferred(rule, "multisampled-lines");
    adopt(as_found("line.coverage:multisampled", lines));
    findings_.observations.push_back(std::move(lines));
    auto wide = random(MultisampledKind::wide_line, "multisampled-wide-line", kWideLineShare);
    adopt(as_found("line.coverage:multisampled-wide", wide));
    findings_.observations.push_back(std::move(wide));
  }

  void find_line_sides() {
    const auto probes = line_side_probes(positions_);
    std::vector<Scene> scenes;
    for (const LineSideProbe& probe : probes) scenes.push_back(probe.scene);
    const auto observations = drawing_.observed("line-side-probe", std::move(scenes));
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
    const auto masks = drawing_.drawn("sample-mask", std::move(masked));
    adopt_sample_rule(RuleId::sample_mask, SampleEvidence::invocations, masks);
    adopt_sample_rule({RuleId::sample_mask, "writes"}, SampleEvidence::writes, masks);
  }

  void find_invocations() {
    std::vector<DrawnScene> all;
    std::vector<DrawnScene> plain;
    std::vector<DrawnScene> centroid;
    for (const InvocationsAsked& asked : ways_to_ask_for_invocations()) {
      InvocationRow row = empty_row(asked, samples_);
      const std::string family = fmt::format("{} {}", asked.name, row.location);
      std::vector<DrawnScene> drawn =
          drawing_.drawn(family, planes(PrimitiveKind::triangle, asked.use));
      for (const DrawnScene& one : drawn) add_invocations(one.rendering, row);
      if (asked.name == "once")
        (asked.use.location == AttributeLocation::center ? plain : centroid) = drawn;
      std::move(drawn.begin(), drawn.end(), std::back_inserter(all));
      profile_.invocations.push_back(std::move(row));
    }
    adopt_sample_rule(RuleId::sample_shading_rate, SampleEvidence::invocations, all);
    // Only lines show whether lines evaluate attributes elsewhere.
    auto lines = drawing_.drawn("once line", planes(PrimitiveKind::line, {}));
    find_line_parameter(lines);
    std::move(lines.begin(), lines.end(), std::back_inserter(plain));
    adopt_sample_rule(RuleId::attribute_location, SampleEvidence::colors, plain);
    adopt_sample_rule(RuleId::attribute_centroid, SampleEvidence::colors, centroid);
  }

  // Multisampled lines may be interpolated differently from those with one sample; what follows
  // concerns only multisampled ones.
  void find_line_parameter(std::span<const DrawnScene> lines) {
    Trait trait = infer_line_parameter(lines, rules_);
    if (trait.rate.of > 0) {
      remark_on_difference(trait);
      rules_[name_of(trait.id.rule)] = trait.alternative;
    }
    adopt(std::move(trait));
  }

  void find_depths() {
    auto depths = drawn_planes("depth", {}, DepthFormat::depth32f);
    // A mask without sample 0 shows a fault of its own.
    Multisampling masked;
    masked.mask = mask_of_all(samples_) - 1;
    append(depths, drawn_planes("depth masked", masked, DepthFormat::depth32f));
    adopt_sample_rule(RuleId::sample_depth, SampleEvidence::all_depths, depths);
    adopt_sample_rule({RuleId::sample_depth, "fragment"}, SampleEvidence::fragment_depths, depths);
  }

  // Depths are evidence for it, too, so sample depths must be known before.
  void find_switch() {
    Multisampling off;
    off.enabled = false;
    const auto all = drawn_planes("multisampling-off", off, DepthFormat::depth32f);
    adopt_sample_rule(RuleId::sample_enable, SampleEvidence::switched_off, all);
    adopt_sample_rule({RuleId::sample_enable, "writes"}, SampleEvidence::writes, all);
  }

  void find_alpha() {
    const std::vector<float> alphas = probing_alphas(samples_);
    std::vector<Scene> scenes;
    for (std::size_t from = 0; from < alphas.size(); from += kAlphasPerScene)
      scenes.push_back(alpha_scene(
          samples_,
          std::span(alphas).subspan(from, std::min(kAlphasPerScene, alphas.size() - from))));
    std::vector<DrawnScene> alpha_scenes = drawing_.drawn("alpha", std::move(scenes));
    profile_.alphas = alpha_runs(alpha_scenes);
    append(alpha_scenes, drawing_.drawn("alpha plane", alpha_planes(false)));
    const auto per_sample = drawing_.drawn("alpha per sample", alpha_planes(true));
    alpha_scenes.insert(alpha_scenes.end(), per_sample.begin(), per_sample.end());
    adopt_sample_rule(RuleId::sample_alpha_to_coverage, SampleEvidence::writes, alpha_scenes);
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
    adopt(infer_resolve(drawing_.drawn("resolve", std::move(scenes))));
  }

  const Question& question_;
  SceneDrawing& drawing_;
  const Choices single_sampled_;  // the rules found for targets with one sample
  Choices rules_;                 // those, and the rules found for multisampled targets
  int samples_ = 0;
  SamplePositions positions_;
  SurfaceFindings& findings_;
  SampleProfile& profile_;
};

std::size_t scene_count(std::size_t scenes_per_kind) {
  const std::size_t random = share_of(scenes_per_kind, kTriangleShare) +
                             share_of(scenes_per_kind, kLineShare) +
                             share_of(scenes_per_kind, kWideLineShare);
  const std::size_t probes = line_side_probes(standard_pattern(kPreferred)).size();
  const std::size_t alphas = (probing_alphas(kPreferred).size() - 1) / kAlphasPerScene + 1;
  // Planes of invocations, and those of eleven further questions.
  const std::size_t planes = (ways_to_ask_for_invocations().size() + 11) * kPlaneScenes;
  return kCounts.size() + kSweepScenes + random + probes + planes + alphas + kResolveScenes;
}

}  // namespace

const Subject kSampleSubject{
    scene_count, [](const Question& question, SceneDrawing& drawing, SurfaceFindings& findings) {
      SampleMeasurement(question, drawing, findings).run();
    }};

}  // namespace edgecase
