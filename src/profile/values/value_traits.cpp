// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "diff/values/value_diff.h"
#include "profile/evidence/tally.h"
#include "profile/values/values.h"
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

double largest_value(const Interpolant& formula) {
  double largest = 0;
  for (int v = 0; v < vertices_of(formula.kind); ++v)
    largest = std::max(largest, formula.values[static_cast<std::size_t>(v)].magnitude());
  return largest;
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

std::vector<Trait> infer_values(std::span<const SampledScene> scenes, RuleChoices& found) {
  // The first pass finds the other rules, the second one uses them.
  infer_once(scenes, found);
  return infer_once(scenes, found);
}

}  // namespace edgecase
