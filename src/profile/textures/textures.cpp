// SPDX-License-Identifier: MIT
#include "profile/textures/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "profile/evidence/inference.h"

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
// The number of fragments examined.
constexpr std::size_t kPerProbe = 128;
constexpr std::size_t kPerTraitRamp = 96;
constexpr std::size_t kPerRamp = 1u << 20;

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

// A rule is probed in several ways if renderers may differ.
struct Way {
  TraitId id;
  TextureQuestion question;
};

// Adopts the alternative of a trait, provided that something was learnt about the rule itself.
void choose(const Trait& trait, RuleChoices& found) {
  if (trait.id.is_rule() && trait.rate.of > 0)
    found = with_alternative(found, trait.id.rule, trait.alternative);
}

class TextureMeasurement {
 public:
  TextureMeasurement(const Question& question, SceneDrawing& drawing, SurfaceFindings& findings)
      : question_(question),
        numbers_(question.scenes_per_kind),
        drawing_(drawing),
        found_(findings.found),
        found_floats_(findings.found),
        findings_(findings) {}

  void run() {
    guess_bias();
    find_formats(RuleId::texture_level_weight, TextureQuestion::level_weight);
    find_formats(RuleId::texture_texel_grid, TextureQuestion::texel_grid);
    find(RuleId::texture_wrap, TextureQuestion::wrap);
    find_level_of_detail();
    find(RuleId::texture_crossover, TextureQuestion::crossover);
    find_nearest_level();
    find_bias();
    find_anisotropy();
    find_chains();
    count_residuals();
    isolate_examples();
  }

 private:
  std::vector<LookupScene> lookup_scenes(const std::string& family, std::vector<Scene> scenes,
                                         std::size_t most) {
    std::vector<std::vector<FragmentLookup>> lookups(scenes.size());
    std::vector<bool> is_drawn(scenes.size());
    drawing_.draw(family, scenes, [&](std::size_t i, const Rendering& rendering) {
      lookups[i] = lookups_of(rendering, most);
      is_drawn[i] = true;
    });
    std::vector<LookupScene> result;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      if (is_drawn[i]) result.push_back({std::move(scenes[i]), std::move(lookups[i])});
    return result;
  }

  std::vector<LookupScene> probes(const TraitId& id, TextureQuestion question,
                                  TextureFormat format = TextureFormat::rgba8) {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < numbers_.probes; ++i)
      scenes.push_back(texture_probe({question_.seed, question_.surface, question, format}, i));
    return lookup_scenes(text_of(id), std::move(scenes), kPerProbe);
  }

  // The result for rgba8 textures is the policy's; scenes with floats use the rules of float
  // lookups.
  void adopt(Trait trait) {
    choose(trait, found_);
    const TextureChoice floats = found_floats_.textures;
    found_floats_.textures = found_.textures;
    found_floats_.textures.level_weight = floats.level_weight;
    found_floats_.textures.texel_grid = floats.texel_grid;
    findings_.adopt(std::move(trait));
  }

  void find(RuleId rule, TextureQuestion question) {
    adopt(infer_texture_rule(rule, probes(rule, question), found_floats_));
  }

  void find_formats(RuleId rule, TextureQuestion question) {
    for (const TextureFormat format : kTextureFormats) {
      const TraitId id{rule, probe_of(format)};
      Trait trait = infer_texture_rule(id, probes(id, question, format), found_);
      adopt(trait);
      if (!holds_floats(format)) continue;
      trait.id = rule;
      choose(trait, found_floats_);
    }
  }

  void find_level_of_detail() {
    std::vector<LookupScene> all;
    for (const RampKind kind : values_of<RampKind>())
      for (LookupScene& scene :
           lookup_scenes(fmt::format("level of detail {}", name_of(kind)),
                         ramps(kind, RampPurpose::traits, numbers_.traits), kPerTraitRamp))
        all.push_back(std::move(scene));
    for (Trait& trait : infer_level_of_detail(all, found_floats_)) adopt(std::move(trait));
  }

  // By footprints; if none of them is a tie, by biases or by levels from the shader.
  void find_nearest_level() {
    constexpr RuleId kRule = RuleId::texture_nearest_level;
    const std::array<Way, 3> ways{{{{kRule, "footprint"}, TextureQuestion::implicit_tie},
                                   {{kRule, "bias"}, TextureQuestion::bias_tie},
                                   {{kRule, "lod"}, TextureQuestion::explicit_tie}}};
    std::vector<Trait> traits;
    for (const Way& way : ways)
      traits.push_back(infer_texture_rule(way.id, probes(way.id, way.question), found_floats_));
    Trait main = traits[0];
    for (const Trait& trait : traits)
      if (main.rate.of == 0) main = trait;
    main.remark = fmt::format("as {} has it", text_of(main.id));
    main.id = kRule;
    adopt(std::move(main));
    for (Trait& trait : traits) adopt(std::move(trait));
  }

  // A bias that renderers add by themselves moves every level, so it has to be known first, if only
  // roughly.
  void guess_bias() {
    given_levels_ = probes({RuleId::texture_lod_bias, "lod"}, TextureQuestion::sampler_bias);
    const Trait trait = infer_texture_rule(RuleId::texture_lod_bias, given_levels_, found_floats_);
    choose(trait, found_);
    choose(trait, found_floats_);
  }

  // By all ways together, mostly by lookups of levels from the shader.
  void find_bias() {
    constexpr RuleId kRule = RuleId::texture_lod_bias;
    constexpr std::size_t kPerOtherProbe = kPerProbe / 8;
    const std::array<Way, 3> ways{{{{kRule, "lod"}, TextureQuestion::sampler_bias},
                                   {{kRule, "sum"}, TextureQuestion::bias_sum},
                                   {{kRule, "gradients"}, TextureQuestion::gradients_bias}}};
    std::vector<LookupScene> all;
    std::vector<Trait> traits;
    for (const Way& way : ways) {
      const bool is_given = way.question == TextureQuestion::sampler_bias;
      std::vector<LookupScene> scenes =
          is_given ? std::move(given_levels_) : probes(way.id, way.question);
      traits.push_back(infer_texture_rule(way.id, scenes, found_floats_));
      for (LookupScene& scene : scenes) {
        if (!is_given && scene.lookups.size() > kPerOtherProbe)
          scene.lookups.resize(kPerOtherProbe);
        all.push_back(std::move(scene));
      }
    }
    adopt(infer_texture_rule(kRule, all, found_floats_));
    for (Trait& trait : traits) adopt(std::move(trait));
  }

  // Any anisotropic filter is permitted: one that fits badly is reported and not followed.
  void find_anisotropy() {
    constexpr RuleId kRule = RuleId::texture_anisotropy;
    Trait trait =
        infer_texture_rule(kRule, probes(kRule, TextureQuestion::anisotropy), found_floats_);
    if (2 * trait.rate.agreeing >= trait.rate.of) {
      adopt(std::move(trait));
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
    std::vector<GeneratedChain> chains;
    for (const TextureFormat format : kTextureFormats) {
      std::vector<Scene> scenes;
      for (std::size_t i = 0; i < numbers_.chains; ++i)
        scenes.push_back(chain_scene(question_.seed, question_.surface, format, i));
      for (const DrawnScene& drawn :
           drawing_.drawn(fmt::format("mip chain {}", name_of(format)), std::move(scenes)))
        for (const auto& [number, levels] : drawn.rendering.mip_chains)
          chains.push_back({format, levels});
    }
    for (Trait& trait : infer_mip_chains(chains)) adopt(std::move(trait));
  }

  std::vector<Scene> ramps(RampKind kind, RampPurpose purpose, std::size_t count) const {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < count; ++i)
      scenes.push_back(ramp_scene({question_.seed, question_.surface, kind, purpose}, i));
    return scenes;
  }

  void count_residuals() {
    ResidualTable table(found_floats_);
    for (const RampKind kind : values_of<RampKind>()) {
      const std::string family = fmt::format("ramp {}", name_of(kind));
      const auto scenes = ramps(kind, RampPurpose::residuals, numbers_.residuals);
      drawing_.draw(family, scenes, [&](std::size_t i, const Rendering& rendering) {
        table.add(kind, scene_id(family, i), scenes[i], lookups_of(rendering, kPerRamp));
      });
    }
    findings_.levels = std::move(table.rows());
  }

  // Replaces an example's scene by its primitive alone if that shows the same.
  void isolate_examples() {
    std::vector<std::pair<ResidualExample*, LevelSource>> examples;
    std::vector<Scene> scenes;
    for (LevelResiduals& row : findings_.levels)
      for (FormulaResidual& formula : row.formulas) {
        if (!formula.worst) continue;
        examples.emplace_back(&*formula.worst, row.source);
        scenes.push_back(only_primitive(formula.worst->scene, formula.worst->primitive));
      }
    drawing_.draw(
        "alone", scenes,
        [&](std::size_t i, const Rendering& rendering) {
          ResidualExample& example = *examples[i].first;
          if (!shows(scenes[i], rendering, example, examples[i].second)) return;
          example.scene = scenes[i];
          example.primitive = 0;
        },
        Counted::nothing);
  }

  bool shows(const Scene& scene, const Rendering& rendering, const ResidualExample& example,
             LevelSource source) const {
    const RampLevels ramp(scene, found_floats_);
    return std::ranges::any_of(lookups_of(rendering, kPerRamp), [&](const FragmentLookup& lookup) {
      return lookup.pixel == example.pixel && ramp.reported(lookup, source) == example.reported;
    });
  }

  const Question& question_;
  Numbers numbers_;
  SceneDrawing& drawing_;
  RuleChoices found_;
  RuleChoices found_floats_;  // the same, with weights and grids for textures of floats
  std::vector<LookupScene> given_levels_;  // those of guess_bias
  SurfaceFindings& findings_;
};

std::size_t scene_count(std::size_t scenes_per_kind) {
  const Numbers numbers(scenes_per_kind);
  // Two questions for every format, nine for one.
  const std::size_t questions = 2 * kTextureFormats.size() + 9;
  return questions * numbers.probes +
         values_of<RampKind>().size() * (numbers.traits + numbers.residuals) +
         kTextureFormats.size() * numbers.chains;
}

}  // namespace

const Subject kTextureSubject{
    scene_count, [](const Question& question, SceneDrawing& drawing, SurfaceFindings& findings) {
      TextureMeasurement(question, drawing, findings).run();
    }};

}  // namespace edgecase
