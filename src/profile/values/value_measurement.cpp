// SPDX-License-Identifier: MIT
#include "profile/values/value_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "profile/values/value_scenes.h"
#include "profile/values/value_traits.h"

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
  ValueMeasurement(Renderer& renderer, const ValueQuestion& question,
                   const ObservationProgress& progress, const std::atomic<bool>* stop)
      : renderer_(renderer),
        question_(question),
        numbers_(question.scenes_per_kind),
        progress_(progress),
        stop_(stop),
        found_(question.found) {}

  ValueFindings run() {
    find_traits();
    find_derivatives();
    count_errors();
    isolate_examples();
    find_depths();
    return std::move(findings_);
  }

 private:
  // Draws scenes, those of one size together, and hands on every rendering or why there is none.
  template <class Seen>
  void draw(const std::string& family, const std::vector<Scene>& scenes, Seen seen,
            bool counted = true) {
    std::vector<std::size_t> order(scenes.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const Target& s = scenes[a].target;
      const Target& t = scenes[b].target;
      return std::pair{s.width, s.height} < std::pair{t.width, t.height};
    });
    std::vector<Task> tasks;
    for (const std::size_t i : order)
      tasks.push_back({fmt::format("{}/{:05}", family, i), &scenes[i]});
    renderer_.render(tasks, [&](std::size_t index, Outcome outcome) {
      if (stop_ != nullptr && stop_->load()) throw MeasurementStopped{};
      seen(order[index], tasks[index].id, std::move(outcome));
      if (counted && progress_) progress_(1);
    });
  }

  // The rendering, where there is one; counts.
  const Rendering* drawn(const Outcome& outcome) {
    if (const auto* rendering = std::get_if<Rendering>(&outcome)) {
      ++findings_.scenes;
      return rendering;
    }
    const auto& failure = std::get<Failure>(outcome);
    ++findings_.not_drawn;
    if (findings_.first_failure.empty())
      findings_.first_failure = fmt::format("{}: {}", name_of(failure.kind), failure.reason);
    return nullptr;
  }

  std::vector<SampledScene> sample(const std::string& family, std::vector<Scene> scenes) {
    std::vector<std::optional<SampledScene>> kept(scenes.size());
    draw(family, scenes, [&](std::size_t i, const std::string&, const Outcome& outcome) {
      if (const Rendering* rendering = drawn(outcome))
        kept[i] = sampled(scenes[i], *rendering, kSamplesPerScene);
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

  void adopt(ValueTraits traits) {
    found_.values = traits.values;
    for (Trait& trait : traits.traits) {
      if (trait.rate.of > 0) findings_.choices[trait.id] = trait.alternative;
      findings_.traits.push_back(std::move(trait));
    }
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
    adopt(infer_derivatives(sample("derivative", std::move(scenes)), found_));
  }

  void count_errors() {
    ValueErrorTable table(found_, question_.bits);
    for (const ValueMode& mode : all_value_modes()) {
      const auto scenes = scenes_of(mode, ValuePurpose::errors, numbers_.errors);
      draw(name_of(mode), scenes,
           [&](std::size_t i, const std::string& id, const Outcome& outcome) {
             if (const Rendering* rendering = drawn(outcome))
               table.add(mode, id, scenes[i], *rendering);
           });
    }
    findings_.errors = std::move(table.rows());
  }

  // Names the primitive alone where it shows the same without its neighbours.
  void isolate_examples() {
    std::vector<std::pair<ValueExample*, ValueKind>> examples;
    std::vector<Scene> scenes;
    for (ValueErrors& row : findings_.errors)
      for (auto* example : {&row.worst_ulp, &row.worst_relative, &row.smallest_beyond}) {
        if (!*example || primitives_of((*example)->scene).size() == 1) continue;
        examples.emplace_back(&**example, row.kind);
        scenes.push_back(only_primitive((*example)->scene, (*example)->primitive));
      }
    draw(
        "alone", scenes,
        [&](std::size_t i, const std::string&, const Outcome& outcome) {
          const auto* rendering = std::get_if<Rendering>(&outcome);
          ValueExample& example = *examples[i].first;
          if (rendering == nullptr || !shows(*rendering, example, examples[i].second)) return;
          example.scene = scenes[i];
          example.primitive = 0;
        },
        false);
  }

  static bool shows(const Rendering& rendering, const ValueExample& example, ValueKind kind) {
    return std::any_of(
        rendering.fragments.begin(), rendering.fragments.end(), [&](const Fragment& fragment) {
          return PixelPosition{fragment.x, fragment.y} == example.pixel &&
                 told(rendering, fragment, kind, example.component) == example.rendered;
        });
  }

  void find_depths() {
    for (const DepthFormat format : kFormats) {
      std::vector<Scene> scenes;
      for (std::size_t i = 0; i < kDepthScenes; ++i)
        scenes.push_back(depth_scene(question_.seed, question_.surface, format, i));
      DepthTrait trait(format);
      draw(fmt::format("depth {}", name_of(format)), scenes,
           [&](std::size_t, const std::string&, const Outcome& outcome) {
             if (const auto* failure = std::get_if<Failure>(&outcome))
               trait.add_failure(fmt::format("{}: {}", name_of(failure->kind), failure->reason));
             else
               trait.add(std::get<Rendering>(outcome));
           });
      findings_.traits.push_back(trait.trait());
    }
  }

  Renderer& renderer_;
  const ValueQuestion& question_;
  Numbers numbers_;
  const ObservationProgress& progress_;
  const std::atomic<bool>* stop_;
  RuleChoices found_;
  ValueFindings findings_;
};

}  // namespace

std::size_t error_scene_count(std::size_t scenes_per_kind) {
  return Numbers(scenes_per_kind).errors;
}

std::size_t value_scene_count(std::size_t scenes_per_kind) {
  const Numbers numbers(scenes_per_kind);
  const auto flat = static_cast<std::size_t>(
      std::count_if(all_value_modes().begin(), all_value_modes().end(), is_flat));
  const std::size_t modes = all_value_modes().size();
  return modes * numbers.errors + (modes - flat) * numbers.traits + numbers.derivatives +
         kFormats.size() * kDepthScenes;
}

ValueFindings measure_values(Renderer& renderer, const ValueQuestion& question,
                             const ObservationProgress& progress, const std::atomic<bool>* stop) {
  return ValueMeasurement(renderer, question, progress, stop).run();
}

}  // namespace edgecase
