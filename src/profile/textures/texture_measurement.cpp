// SPDX-License-Identifier: MIT
#include "profile/textures/texture_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "profile/textures/texture_traits.h"
#include "profile/values/value_scenes.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

// Shares of the number of random scenes of a kind, and the least numbers.
constexpr std::size_t kProbeShare = 5'000;  // of each question and format
constexpr std::size_t kTraitShare = 5'000;  // of each kind of ramp
constexpr std::size_t kResidualShare = 1'250;
constexpr std::size_t kChainShare = 1'250;  // of each format
constexpr std::size_t kLeastProbes = 3;
constexpr std::size_t kLeastTraits = 2;
constexpr std::size_t kLeastResiduals = 1;
constexpr std::size_t kLeastChains = 7;
// Fragments that are looked at.
constexpr std::size_t kPerProbe = 128;
constexpr std::size_t kPerTraitRamp = 96;
constexpr std::size_t kPerRamp = 1u << 20;

constexpr std::array kFormats{TextureFormat::rgba8, TextureFormat::srgb8, TextureFormat::rgba32f};

struct Numbers {
  std::size_t probes;
  std::size_t traits;
  std::size_t residuals;
  std::size_t chains;

  explicit Numbers(std::size_t scenes_per_kind)
      : probes(std::max(kLeastProbes, scenes_per_kind / kProbeShare)),
        traits(std::max(kLeastTraits, scenes_per_kind / kTraitShare)),
        residuals(std::max(kLeastResiduals, scenes_per_kind / kResidualShare)),
        chains(std::max(kLeastChains, scenes_per_kind / kChainShare)) {}
};

class TextureMeasurement {
 public:
  TextureMeasurement(Renderer& renderer, const TextureMeasureQuestion& question,
                     const ObservationProgress& progress, const std::atomic<bool>* stop)
      : renderer_(renderer),
        question_(question),
        numbers_(question.scenes_per_kind),
        progress_(progress),
        stop_(stop),
        found_(question.found),
        found_floats_(question.found) {}

  TextureFindings run() {
    guess_bias();
    find_formats(name_of(RuleId::texture_level_weight), TextureRule::level_weight,
                 TextureQuestion::level_weight);
    find_formats(name_of(RuleId::texture_texel_grid), TextureRule::texel_grid,
                 TextureQuestion::texel_grid);
    find(name_of(RuleId::texture_wrap), TextureRule::wrap, TextureQuestion::wrap);
    find_level_of_detail();
    find(name_of(RuleId::texture_crossover), TextureRule::crossover, TextureQuestion::crossover);
    find_nearest_level();
    find_bias();
    find_anisotropy();
    find_chains();
    count_residuals();
    isolate_examples();
    return std::move(findings_);
  }

 private:
  // Hands on every rendering, with the number and the id of its scene.
  template <class Seen>
  void draw(const std::string& family, const std::vector<Scene>& scenes, Seen seen,
            bool counted = true) {
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      tasks.push_back({fmt::format("{}/{:05}", family, i), &scenes[i]});
    renderer_.render(tasks, [&](std::size_t i, const Outcome& outcome) {
      if (stop_ != nullptr && stop_->load()) throw MeasurementStopped{};
      if (counted && progress_) progress_(1);
      if (const auto* rendering = std::get_if<Rendering>(&outcome)) {
        if (counted) ++findings_.scenes;
        seen(i, tasks[i].id, *rendering);
        return;
      }
      if (!counted) return;
      const auto& failure = std::get<Failure>(outcome);
      ++findings_.not_drawn;
      if (findings_.first_failure.empty())
        findings_.first_failure = fmt::format("{}: {}", name_of(failure.kind), failure.reason);
    });
  }

  std::vector<ToldScene> told(const std::string& family, const std::vector<Scene>& scenes,
                              std::size_t most) {
    std::vector<ToldScene> result;
    draw(family, scenes, [&](std::size_t i, const std::string&, const Rendering& rendering) {
      result.push_back(told_scene(scenes[i], rendering, most));
    });
    return result;
  }

  std::vector<ToldScene> probes(const std::string& family, TextureQuestion question,
                                TextureFormat format = TextureFormat::rgba8) {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < numbers_.probes; ++i)
      scenes.push_back(texture_probe({question_.seed, question_.surface, question, format}, i));
    return told(family, scenes, kPerProbe);
  }

  // What holds for rgba8 textures is the policy's; scenes of floats are read as floats are looked
  // up.
  void adopt_trait(Trait trait) {
    adopt(trait, found_.textures);
    const TextureChoice floats = found_floats_.textures;
    found_floats_.textures = found_.textures;
    found_floats_.textures.level_weight = floats.level_weight;
    found_floats_.textures.texel_grid = floats.texel_grid;
    if (trait.rate.of > 0 && find_rule(trait.id) != nullptr)
      findings_.choices[trait.id] = trait.alternative;
    findings_.traits.push_back(std::move(trait));
  }

  void find(const char* id, TextureRule rule, TextureQuestion question) {
    adopt_trait(infer_texture_rule(rule, id, probes(id, question), found_floats_));
  }

  void find_formats(const std::string& id, TextureRule rule, TextureQuestion question) {
    for (const TextureFormat format : kFormats) {
      const std::string full =
          format == TextureFormat::rgba8 ? id : fmt::format("{}:{}", id, name_of(format));
      const Trait trait = infer_texture_rule(rule, full, probes(full, question, format), found_);
      adopt_trait(trait);
      if (format != TextureFormat::rgba32f) continue;
      Trait plain = trait;
      plain.id = id;
      adopt(plain, found_floats_.textures);
    }
  }

  void find_level_of_detail() {
    std::vector<ToldScene> all;
    for (const RampKind kind : all_ramp_kinds())
      for (ToldScene& scene :
           told(fmt::format("level of detail {}", name_of(kind)),
                ramps(kind, RampPurpose::traits, numbers_.traits), kPerTraitRamp))
        all.push_back(std::move(scene));
    for (Trait& trait : infer_level_of_detail(all, found_floats_)) adopt_trait(std::move(trait));
  }

  // A rule is asked in several ways where renderers may differ.
  struct Way {
    const char* id;
    TextureQuestion question;
  };

  // Of footprints; where none of them lies halfway, of biases or of levels that the shader gives.
  void find_nearest_level() {
    constexpr std::array<Way, 3> kWays{
        {{"texture.nearest-level:footprint", TextureQuestion::implicit_tie},
         {"texture.nearest-level:bias", TextureQuestion::bias_tie},
         {"texture.nearest-level:lod", TextureQuestion::explicit_tie}}};
    std::vector<Trait> traits;
    for (const Way& way : kWays)
      traits.push_back(infer_texture_rule(TextureRule::nearest_level, way.id,
                                          probes(way.id, way.question), found_floats_));
    Trait main = traits[0];
    for (const Trait& trait : traits)
      if (main.rate.of == 0) main = trait;
    main.remark = fmt::format("as {} has it", main.id);
    main.id = name_of(RuleId::texture_nearest_level);
    adopt_trait(std::move(main));
    for (Trait& trait : traits) adopt_trait(std::move(trait));
  }

  // A bias that renderers add by themselves moves every level: it has to be known before all else,
  // if only roughly.
  void guess_bias() {
    given_levels_ = probes("texture.lod-bias:lod", TextureQuestion::sampler_bias);
    const Trait trait = infer_texture_rule(TextureRule::bias, name_of(RuleId::texture_lod_bias),
                                           given_levels_, found_floats_);
    adopt(trait, found_.textures);
    adopt(trait, found_floats_.textures);
  }

  // Of all ways together, that of levels which the shader gives most of all.
  void find_bias() {
    constexpr std::array<Way, 3> kWays{
        {{"texture.lod-bias:lod", TextureQuestion::sampler_bias},
         {"texture.lod-bias:sum", TextureQuestion::bias_sum},
         {"texture.lod-bias:gradients", TextureQuestion::gradients_bias}}};
    constexpr std::size_t kPerOtherProbe = kPerProbe / 8;
    std::vector<ToldScene> all;
    std::vector<Trait> traits;
    for (const Way& way : kWays) {
      std::vector<ToldScene> scenes = way.question == TextureQuestion::sampler_bias
                                          ? std::move(given_levels_)
                                          : probes(way.id, way.question);
      traits.push_back(infer_texture_rule(TextureRule::bias, way.id, scenes, found_floats_));
      for (ToldScene& scene : scenes) {
        if (way.question != TextureQuestion::sampler_bias && scene.lookups.size() > kPerOtherProbe)
          scene.lookups.resize(kPerOtherProbe);
        all.push_back(std::move(scene));
      }
    }
    adopt_trait(infer_texture_rule(TextureRule::bias, name_of(RuleId::texture_lod_bias), all,
                                   found_floats_));
    for (Trait& trait : traits) adopt_trait(std::move(trait));
  }

  // Any way to filter anisotropically is open: what fits badly is told, not followed.
  void find_anisotropy() {
    Trait trait = infer_texture_rule(
        TextureRule::anisotropy, name_of(RuleId::texture_anisotropy),
        probes(name_of(RuleId::texture_anisotropy), TextureQuestion::anisotropy), found_floats_);
    if (2 * trait.rate.agreeing >= trait.rate.of) {
      adopt_trait(std::move(trait));
      return;
    }
    trait.runner_up = trait.alternative;
    trait.runner_up_rate = trait.rate;
    trait.alternative = "not catalogued";
    trait.rate.agreeing = trait.rate.of - trait.rate.agreeing;
    trait.remark = "any way is open; what the runner-up does not yield is not catalogued";
    findings_.traits.push_back(std::move(trait));
  }

  void find_chains() {
    std::vector<ToldChain> chains;
    for (const TextureFormat format : kFormats) {
      std::vector<Scene> scenes;
      for (std::size_t i = 0; i < numbers_.chains; ++i)
        scenes.push_back(chain_scene(question_.seed, question_.surface, format, i));
      draw(fmt::format("mip chain {}", name_of(format)), scenes,
           [&](std::size_t, const std::string&, const Rendering& rendering) {
             for (const auto& [number, levels] : rendering.mip_chains)
               chains.push_back({format, levels});
           });
    }
    for (Trait& trait : infer_mip_chains(chains)) adopt_trait(std::move(trait));
  }

  std::vector<Scene> ramps(RampKind kind, RampPurpose purpose, std::size_t count) const {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < count; ++i)
      scenes.push_back(ramp_scene({question_.seed, question_.surface, kind, purpose}, i));
    return scenes;
  }

  void count_residuals() {
    ResidualTable table(found_floats_);
    for (const RampKind kind : all_ramp_kinds()) {
      const auto scenes = ramps(kind, RampPurpose::residuals, numbers_.residuals);
      draw(fmt::format("ramp {}", name_of(kind)), scenes,
           [&](std::size_t i, const std::string& id, const Rendering& rendering) {
             table.add(kind, id, scenes[i], told_lookups(rendering, kPerRamp));
           });
    }
    findings_.residuals = std::move(table.rows());
  }

  // Names the primitive alone where it shows the same without its neighbours.
  void isolate_examples() {
    std::vector<std::pair<ResidualExample*, LevelSource>> examples;
    std::vector<Scene> scenes;
    for (LevelResiduals& row : findings_.residuals)
      for (FormulaResidual& formula : row.formulas) {
        if (!formula.worst) continue;
        examples.emplace_back(&*formula.worst, row.source);
        scenes.push_back(only_primitive(formula.worst->scene, formula.worst->primitive));
      }
    draw(
        "alone", scenes,
        [&](std::size_t i, const std::string&, const Rendering& rendering) {
          ResidualExample& example = *examples[i].first;
          if (!shows(scenes[i], rendering, example, examples[i].second)) return;
          example.scene = scenes[i];
          example.primitive = 0;
        },
        false);
  }

  bool shows(const Scene& scene, const Rendering& rendering, const ResidualExample& example,
             LevelSource source) const {
    const RampLevels ramp(scene, found_floats_);
    return std::ranges::any_of(told_lookups(rendering, kPerRamp), [&](const ToldLookup& lookup) {
      return lookup.pixel == example.pixel && ramp.told(lookup, source) == example.told;
    });
  }

  Renderer& renderer_;
  const TextureMeasureQuestion& question_;
  Numbers numbers_;
  const ObservationProgress& progress_;
  const std::atomic<bool>* stop_;
  RuleChoices found_;
  RuleChoices found_floats_;  // the same, with weights and grids as textures of floats have them
  std::vector<ToldScene> given_levels_;  // those of guess_bias
  TextureFindings findings_;
};

}  // namespace

std::size_t texture_scene_count(std::size_t scenes_per_kind) {
  const Numbers numbers(scenes_per_kind);
  // Two questions of every format, nine of one.
  const std::size_t questions = 2 * kFormats.size() + 9;
  return questions * numbers.probes +
         all_ramp_kinds().size() * (numbers.traits + numbers.residuals) +
         kFormats.size() * numbers.chains;
}

TextureFindings measure_textures(Renderer& renderer, const TextureMeasureQuestion& question,
                                 const ObservationProgress& progress,
                                 const std::atomic<bool>* stop) {
  return TextureMeasurement(renderer, question, progress, stop).run();
}

}  // namespace edgecase
