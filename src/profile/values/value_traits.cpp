// SPDX-License-Identifier: MIT
#include "profile/values/value_traits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "diff/values/value_diff.h"
#include "profile/profile_text.h"
#include "raster/attributes.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostCandidates = 3;

struct Candidate {
  const char* name;
  ValueChoice values;
};

// Votes of one kind of primitive.
struct Votes {
  std::array<std::size_t, kMostCandidates> agreeing{};
  std::size_t of = 0;

  Votes& operator+=(const Votes& other) {
    for (std::size_t i = 0; i < agreeing.size(); ++i) agreeing[i] += other.agreeing[i];
    of += other.of;
    return *this;
  }
  Rate rate(std::size_t candidate) const { return {agreeing[candidate], of}; }
  // The most votes, the first of several.
  std::size_t best() const {
    return static_cast<std::size_t>(std::max_element(agreeing.begin(), agreeing.end()) -
                                    agreeing.begin());
  }
};

bool is_number(Interval value) {
  return std::isfinite(value.low) && std::isfinite(value.high);
}

bool overlap(Interval a, Interval b) {
  return a.low <= b.high && b.low <= a.high;
}

double largest_value(const Interpolant& formula) {
  double largest = 0;
  for (int v = 0; v < vertices_of(formula.kind); ++v)
    largest = std::max(largest, formula.values[static_cast<std::size_t>(v)].magnitude());
  return largest;
}

// How far the rendered component is from each candidate's exact value, as a share of the largest
// value at a vertex. False where the candidates are too near to each other to tell.
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
      // What one operation may make up needs no closer look.
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
  Ballot(std::span<const Candidate> candidates, const RuleChoices& found)
      : candidates_(candidates), found_(found) {}

  void add(const SampledScene& sampled_scene) {
    const Scene& scene = sampled_scene.scene;
    const auto primitives = primitives_of(scene);
    for (const SampledScene::Sample& sample : sampled_scene.samples) {
      const ScenePrimitive& primitive = primitives[static_cast<std::size_t>(sample.primitive)];
      if (primitive.state->interpolation == Interpolation::flat) continue;
      vote(primitive, scene.target, sample);
    }
  }

  const Votes& of(PrimitiveKind kind) const {
    return kind == PrimitiveKind::line ? lines_ : triangles_;
  }
  Votes all() const {
    Votes sum = lines_;
    return sum += triangles_;
  }

 private:
  void vote(const ScenePrimitive& primitive, const Target& target,
            const SampledScene::Sample& sample) {
    std::vector<PrimitiveAttributes> attributes;
    for (const Candidate& candidate : candidates_) {
      RuleChoices choices = found_;
      choices.values = candidate.values;
      attributes.push_back(attributes_of(primitive, choices, target));
    }
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
    const double least = *std::min_element(
        distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(candidates_.size()));
    // NaN is near to nothing.
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (distances[i] == least) ++votes.agreeing[i];
  }

  std::span<const Candidate> candidates_;
  const RuleChoices& found_;
  Votes lines_;
  Votes triangles_;
};

// The winner, or the first candidate where nothing decides.
std::size_t decide(const char* id, std::span<const Candidate> candidates,
                   const std::vector<SampledScene>& scenes, const RuleChoices& found,
                   ValueTraits& result) {
  Ballot ballot(candidates, found);
  for (const SampledScene& scene : scenes) ballot.add(scene);
  const Votes votes = ballot.all();
  const std::size_t best = votes.best();
  Trait trait{id, candidates[best].name, votes.rate(best), "", {}, ""};
  if (votes.of == 0) {
    trait.remark = "no sample tells the alternatives apart";
    result.traits.push_back(std::move(trait));
    return 0;
  }
  std::size_t second = best == 0 ? 1 : 0;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (i != best && votes.agreeing[i] > votes.agreeing[second]) second = i;
  trait.runner_up = candidates[second].name;
  trait.runner_up_rate = votes.rate(second);
  const Votes& lines = ballot.of(PrimitiveKind::line);
  const Votes& triangles = ballot.of(PrimitiveKind::triangle);
  if (lines.of > 0 && triangles.of > 0 && lines.best() != triangles.best())
    trait.remark =
        fmt::format("lines and triangles differ: lines are {} ({}), triangles {} ({})",
                    candidates[lines.best()].name, percent(lines.rate(lines.best())),
                    candidates[triangles.best()].name, percent(triangles.rate(triangles.best())));
  result.traits.push_back(std::move(trait));
  return best;
}

Candidate with_perspective(ValueChoice values, const char* name, PerspectiveChoice choice) {
  values.perspective = choice;
  return {name, values};
}

Candidate with_parameter(ValueChoice values, const char* name, LineParameter parameter) {
  values.line_parameter = parameter;
  return {name, values};
}

Candidate with_positions(ValueChoice values, const char* name, AttributePositions positions) {
  values.positions = positions;
  return {name, values};
}

// Each rule in turn, the others as they were last found.
ValueTraits infer_once(const std::vector<SampledScene>& scenes, const RuleChoices& found,
                       ValueChoice values) {
  ValueTraits result;
  const std::array perspective{with_perspective(values, "as-set", PerspectiveChoice::as_set),
                               with_perspective(values, "always", PerspectiveChoice::always),
                               with_perspective(values, "never", PerspectiveChoice::never)};
  values = perspective[decide(name_of(RuleId::attribute_perspective), perspective, scenes, found,
                              result)]
               .values;
  const std::array parameter{with_parameter(values, "projection", LineParameter::projection),
                             with_parameter(values, "major-axis", LineParameter::major_axis)};
  values =
      parameter[decide(name_of(RuleId::attribute_smooth), parameter, scenes, found, result)].values;
  const std::array positions{with_positions(values, "unsnapped", AttributePositions::unsnapped),
                             with_positions(values, "snapped", AttributePositions::snapped)};
  values = positions[decide(name_of(RuleId::attribute_positions), positions, scenes, found, result)]
               .values;
  result.values = values;
  return result;
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

ValueTraits infer_values(const std::vector<SampledScene>& scenes, const RuleChoices& found) {
  // Once to know the other rules, once more under them.
  const ValueTraits first = infer_once(scenes, found, found.values);
  return infer_once(scenes, found, first.values);
}

}  // namespace edgecase
