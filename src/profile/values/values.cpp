// SPDX-License-Identifier: MIT
#include "profile/values/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "diff/values/value_diff.h"
#include "profile/evidence/inference.h"
#include "raster/attributes.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostCandidates = 4;

// The alternatives of a rule that samples vote for.
struct Candidates {
  RuleId rule;
  std::vector<std::string> names;
  std::vector<RuleChoices> choices;
};

Candidates candidates_of(RuleId rule, const RuleChoices& found) {
  Candidates candidates{rule, names_of_alternatives(rule), choices_by_alternative(found, rule)};
  if (rule == RuleId::attribute_perspective) {
    // The last alternative, w at the centre, differs from the first only on multisampled targets.
    candidates.names.pop_back();
    candidates.choices.pop_back();
  }
  return candidates;
}

// Votes of one kind of primitive.
struct Votes {
  std::array<std::size_t, kMostCandidates> agreeing{};
  std::size_t of = 0;

  Votes& operator+=(const Votes& other) {
    for (std::size_t i = 0; i < agreeing.size(); ++i) agreeing[i] += other.agreeing[i];
    of += other.of;
    return *this;
  }
};

bool is_number(Interval value) {
  return std::isfinite(value.low) && std::isfinite(value.high);
}

bool overlap(Interval a, Interval b) {
  return a.low <= b.high && b.low <= a.high;
}

// The distance of the rendered component from each candidate's exact value, relative to the largest
// value at a vertex. False if the candidates are too close to be distinguished.
bool add_distances(std::span<const Interpolant> formulas, Point sample, double rendered,
                   std::array<double, kMostCandidates>& distances) {
  if (range_of(formulas[0]) == 0) return false;
  std::array<double, kMostCandidates> exact{};
  for (std::size_t i = 0; i < formulas.size(); ++i) {
    const Interval value = interpolate_exact(formulas[i], sample);
    if (!is_number(value)) return false;
    exact[i] = middle(value);
  }
  const double scale = largest_value(formulas[0]);
  bool any_differ = false;
  for (std::size_t i = 0; i < formulas.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (exact[i] == exact[j]) continue;
      any_differ = true;
      // Differences within the error of one operation need no closer look.
      if (std::fabs(exact[i] - exact[j]) <= 1e-5 * std::fabs(exact[i]) ||
          overlap(interpolate_inexact(formulas[i], sample),
                  interpolate_inexact(formulas[j], sample)))
        return false;
    }
  if (!any_differ) return false;
  for (std::size_t i = 0; i < formulas.size(); ++i)
    distances[i] += std::fabs(rendered - exact[i]) / scale;
  return true;
}

class Ballot {
 public:
  explicit Ballot(const Candidates& candidates) : candidates_(candidates) {}

  void add(const SampledScene& sampled_scene) {
    const Scene& scene = sampled_scene.scene;
    const auto primitives = primitives_of(scene);
    for (const SampledScene::Sample& sample : sampled_scene.samples) {
      const ScenePrimitive& primitive = primitives[static_cast<std::size_t>(sample.primitive)];
      if (primitive.state->interpolation == Interpolation::flat) continue;
      vote(primitive, scene.target, sample);
    }
  }

  // The winner, or the first candidate if nothing decides.
  Trait trait() const {
    Votes all = lines_;
    all += triangles_;
    Trait trait = leading(all);
    if (all.of == 0) {
      trait.runner_up.clear();
      trait.remark = "no sample distinguishes the alternatives";
    }
    const Trait lines = leading(lines_);
    const Trait triangles = leading(triangles_);
    if (lines_.of > 0 && triangles_.of > 0 && lines.alternative != triangles.alternative)
      trait.remark = fmt::format("lines and triangles differ: lines are {} ({}), triangles {} ({})",
                                 lines.alternative, percent(lines.rate), triangles.alternative,
                                 percent(triangles.rate));
    return trait;
  }

 private:
  Trait leading(const Votes& votes) const {
    return edgecase::leading(candidates_.rule, candidates_.names,
                             std::span(votes.agreeing).first(candidates_.names.size()), votes.of);
  }

  void vote(const ScenePrimitive& primitive, const Target& target,
            const SampledScene::Sample& sample) {
    std::vector<PrimitiveAttributes> attributes;
    for (const RuleChoices& choices : candidates_.choices)
      attributes.push_back(attributes_of(primitive, choices, target));
    std::array<double, kMostCandidates> distances{};
    bool decides = false;
    for (std::size_t c = 0; c < 4; ++c) {
      std::vector<Interpolant> formulas;
      for (const PrimitiveAttributes& one : attributes) formulas.push_back(one.color[c]);
      if (add_distances(formulas, pixel_centre(sample.pixel.x, sample.pixel.y), sample.color[c],
                        distances))
        decides = true;
    }
    if (!decides) return;
    Votes& votes = primitive.kind == PrimitiveKind::line ? lines_ : triangles_;
    ++votes.of;
    const std::size_t count = candidates_.choices.size();
    const double least = *std::min_element(distances.begin(),
                                           distances.begin() + static_cast<std::ptrdiff_t>(count));
    // NaN equals nothing.
    for (std::size_t i = 0; i < count; ++i)
      if (distances[i] == least) ++votes.agreeing[i];
  }

  const Candidates& candidates_;
  Votes lines_;
  Votes triangles_;
};

// Each rule in turn, with the others as last found; `found` is updated.
std::vector<Trait> infer_once(std::span<const SampledScene> scenes, RuleChoices& found) {
  std::vector<Trait> traits;
  for (const RuleId rule :
       {RuleId::attribute_perspective, RuleId::attribute_smooth, RuleId::attribute_positions}) {
    const Candidates candidates = candidates_of(rule, found);
    Ballot ballot(candidates);
    for (const SampledScene& scene : scenes) ballot.add(scene);
    traits.push_back(ballot.trait());
    found = with_alternative(found, rule, traits.back().alternative);
  }
  return traits;
}

}  // namespace

SampledScene sampled(Scene scene, const Rendering& rendering, std::size_t most) {
  SampledScene result{std::move(scene), {}};
  const std::size_t count = rendering.fragments.size();
  const std::size_t taken = std::min(count, most);
  for (std::size_t i = 0; i < taken; ++i) {
    const Fragment& fragment = rendering.fragments[i * count / taken];
    if (!fragment.has_color) continue;
    SampledScene::Sample sample{{fragment.x, fragment.y}, fragment.primitive, fragment.color, {}};
    if (fragment.detail >= 0)
      sample.derivatives = rendering.details[static_cast<std::size_t>(fragment.detail)].derivatives;
    result.samples.push_back(sample);
  }
  return result;
}

namespace {

// attribute.perspective, attribute.smooth, attribute.positions. `found` has what is known so far,
// coverage and snapping, and receives the results.
std::vector<Trait> infer_values(std::span<const SampledScene> scenes, RuleChoices& found) {
  // The first pass finds the other rules, the second one uses them.
  infer_once(scenes, found);
  return infer_once(scenes, found);
}

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
