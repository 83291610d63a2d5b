// SPDX-License-Identifier: MIT
#include "profile/values/values.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "profile/evidence/tally.h"
#include "profile/values/value_scenes.h"

namespace edgecase {
namespace {

// Shares of the number of random scenes of a kind, and the least numbers.
constexpr std::size_t kErrorShare = 40;   // of each mode
constexpr std::size_t kTraitShare = 100;  // of each mode
constexpr std::size_t kDerivativeShare = 200;
constexpr std::size_t kLeastErrors = 8;
constexpr std::size_t kLeastTraits = 24;
constexpr std::size_t kLeastDerivatives = 16;
constexpr std::size_t kDepthScenes = 8;  // of each format
constexpr std::size_t kSamplesPerScene = 24;

constexpr std::array kFormats{DepthFormat::depth16, DepthFormat::depth24, DepthFormat::depth32f};

struct Numbers {
  std::size_t errors;
  std::size_t traits;
  std::size_t derivatives;

  explicit Numbers(std::size_t scenes_per_kind)
      : errors(std::max(kLeastErrors, scenes_per_kind / kErrorShare)),
        traits(std::max(kLeastTraits, scenes_per_kind / kTraitShare)),
        derivatives(std::max(kLeastDerivatives, scenes_per_kind / kDerivativeShare)) {}
};

bool is_flat(const ValueMode& mode) {
  return mode.interpolation == Interpolation::flat;
}

class ValueMeasurement {
 public:
  ValueMeasurement(const Question& question, SceneDrawing& drawing, SurfaceFindings& findings)
      : question_(question),
        numbers_(question.scenes_per_kind),
        drawing_(drawing),
        found_(findings.found),
        findings_(findings) {}

  void run() {
    find_traits();
    find_derivatives();
    count_errors();
    isolate_examples();
    find_depths();
    // Texture coordinates are interpolated in the same way, and in the same quads.
    findings_.found.values = resolve(policy_of(findings_.choices), question_.surface).values;
  }

 private:
  std::vector<SampledScene> sample(const std::string& family, const std::vector<Scene>& scenes) {
    std::vector<std::optional<SampledScene>> kept(scenes.size());
    drawing_.draw(family, scenes, [&](std::size_t i, const Rendering& rendering) {
      kept[i] = sampled(scenes[i], rendering, kSamplesPerScene);
    });
    std::vector<SampledScene> result;
    for (auto& scene : kept)
      if (scene) result.push_back(std::move(*scene));
    return result;
  }

  std::vector<Scene> scenes_of(const ValueMode& mode, ValuePurpose purpose,
                               std::size_t count) const {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < count; ++i)
      scenes.push_back(value_scene({question_.seed, question_.surface, mode, purpose}, i));
    return scenes;
  }

  void adopt(std::vector<Trait> traits) {
    for (Trait& trait : traits) findings_.adopt(std::move(trait));
  }

  void find_traits() {
    std::vector<SampledScene> scenes;
    for (const ValueMode& mode : all_value_modes()) {
      if (is_flat(mode)) continue;
      for (SampledScene& scene :
           sample(name_of(mode), scenes_of(mode, ValuePurpose::traits, numbers_.traits)))
        scenes.push_back(std::move(scene));
    }
    adopt(infer_values(scenes, found_));
  }

  void find_derivatives() {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < numbers_.derivatives; ++i)
      scenes.push_back(derivative_scene(question_.seed, question_.surface, i));
    adopt(infer_derivatives(sample("derivative", scenes), found_));
  }

  void count_errors() {
    ValueErrorTable table(found_, drawing_.latitude_bits());
    for (const ValueMode& mode : all_value_modes()) {
      const std::string family = name_of(mode);
      const auto scenes = scenes_of(mode, ValuePurpose::errors, numbers_.errors);
      drawing_.draw(family, scenes, [&](std::size_t i, const Rendering& rendering) {
        table.add(mode, scene_id(family, i), scenes[i], rendering);
      });
    }
    findings_.values = std::move(table.rows());
  }

  // Replaces an example's scene by its primitive alone if that shows the same.
  void isolate_examples() {
    std::vector<std::pair<ValueExample*, ValueKind>> examples;
    std::vector<Scene> scenes;
    for (ValueErrors& row : findings_.values)
      for (auto* example : {&row.worst_ulp, &row.worst_relative, &row.smallest_beyond}) {
        if (!*example || primitives_of((*example)->scene).size() == 1) continue;
        examples.emplace_back(&**example, row.kind);
        scenes.push_back(only_primitive((*example)->scene, (*example)->primitive));
      }
    drawing_.draw(
        "alone", scenes,
        [&](std::size_t i, const Rendering& rendering) {
          ValueExample& example = *examples[i].first;
          if (!shows(rendering, example, examples[i].second)) return;
          example.scene = scenes[i];
          example.primitive = 0;
        },
        Counted::nothing);
  }

  static bool shows(const Rendering& rendering, const ValueExample& example, ValueKind kind) {
    return std::ranges::any_of(rendering.fragments, [&](const Fragment& fragment) {
      return PixelPosition{fragment.x, fragment.y} == example.pixel &&
             reported(rendering, fragment, kind, example.component) == example.rendered;
    });
  }

  // A depth format that a surface lacks is not counted as a failure.
  void find_depths() {
    for (const DepthFormat format : kFormats) {
      std::vector<Scene> scenes;
      for (std::size_t i = 0; i < kDepthScenes; ++i)
        scenes.push_back(depth_scene(question_.seed, question_.surface, format, i));
      DepthTrait trait(format);
      drawing_.draw(
          tasks_of(std::string("depth ") + name_of(format), scenes),
          [&](std::size_t, const Outcome& outcome) {
            if (const auto* failure = std::get_if<Failure>(&outcome))
              trait.add_failure(text_of(*failure));
            else
              trait.add(std::get<Rendering>(outcome));
          },
          Counted::progress);
      findings_.adopt(trait.trait());
    }
  }

  const Question& question_;
  Numbers numbers_;
  SceneDrawing& drawing_;
  RuleChoices found_;
  SurfaceFindings& findings_;
};

std::size_t scene_count(std::size_t scenes_per_kind) {
  const Numbers numbers(scenes_per_kind);
  const auto flat = static_cast<std::size_t>(std::ranges::count_if(all_value_modes(), is_flat));
  const std::size_t modes = all_value_modes().size();
  return modes * numbers.errors + (modes - flat) * numbers.traits + numbers.derivatives +
         kFormats.size() * kDepthScenes;
}

}  // namespace

std::size_t error_scene_count(std::size_t scenes_per_kind) {
  return Numbers(scenes_per_kind).errors;
}

const Subject kValueSubject{
    scene_count, [](const Question& question, SceneDrawing& drawing, SurfaceFindings& findings) {
      ValueMeasurement(question, drawing, findings).run();
    }};

}  // namespace edgecase
