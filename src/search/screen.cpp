// SPDX-License-Identifier: MIT
#include "search/screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <variant>

#include "diff/compare.h"
#include "diff/coverage/coverage_compare.h"
#include "diff/coverage/legality.h"
#include "raster/rasterizer.h"
#include "search/trial.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostAlike = 4;  // disagreements that differ only in their pixels

using Drawn = std::vector<std::vector<PixelPosition>>;  // by primitive

Drawn drawn_of(std::size_t primitives, const Rendering& rendering) {
  Drawn drawn(primitives);
  for (const Fragment& fragment : rendering.fragments)
    drawn[static_cast<std::size_t>(fragment.primitive)].push_back({fragment.x, fragment.y});
  return drawn;
}

// The coverage under the choices, by primitive.
Drawn covered_under(const RuleChoices& choices, const Target& target,
                    std::span<const ScenePrimitive> primitives) {
  Drawn covered;
  for (const ScenePrimitive& primitive : primitives)
    covered.push_back(covered_pixels(primitive, target, choices.of(primitive.kind)));
  return covered;
}

// Keeps only what judging and reporting a result need: values may differ at every pixel, and some
// thousand results wait to be judged.
void lighten(Result& result) {
  result.pixel_counts = {};
  std::map<std::tuple<RuleId, DisagreementKind, int, int, Legality, int, bool, Cause, std::string>,
           std::size_t>
      alike;
  std::erase_if(result.disagreements, [&](const Disagreement& d) {
    return ++alike[{d.rule, d.kind, d.primitive, d.sample, d.legality, d.ruling, d.policy_agrees,
                    d.cause, d.situation}] > kMostAlike;
  });
  result.disagreements.shrink_to_fit();
}

// Groups scenes by size, since changes of size are slow in some window systems.
std::vector<std::size_t> by_size(std::span<const Scene> scenes) {
  std::vector<std::size_t> order(scenes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto size = [&](std::size_t i) {
    const Target& target = scenes[i].target;
    return std::tuple(target.surface, target.width, target.height, target.samples);
  };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  return order;
}

}  // namespace

Screen::Screen(Policy policy, std::optional<Policy> profile)
    : policy_(std::move(policy)), resolved_(policy_) {
  if (profile) profile_ = *profile;
}

Screening Screen::ask(Renderer& renderer, std::span<const Scene> scenes, bool coverage_only,
                      const std::atomic<bool>* stop) const {
  const std::vector<std::size_t> order = by_size(scenes);
  std::vector<Task> tasks;
  tasks.reserve(order.size());
  for (const std::size_t i : order)
    tasks.push_back(
        {fmt::format("fuzz/{}", i), &scenes[i], coverage_only && scenes[i].target.samples == 1});
  Screening screening;
  renderer.render(tasks, [&](std::size_t k, Outcome outcome) {
    // Being stopped may itself cause a failure.
    if (stop != nullptr && stop->load()) throw SearchStopped{};
    if (const auto* failure = std::get_if<Failure>(&outcome)) {
      if (!screening.failure) screening.failure = *failure;
    } else {
      ++screening.drawn;
    }
    const int bits = renderer.info().subpixel_bits;
    auto result = screened(scenes[order[k]], std::move(outcome), tasks[k].coverage_only, bits);
    if (!result) return;
    lighten(*result);
    screening.suspects.push_back({order[k], std::move(*result)});
  });
  std::ranges::sort(screening.suspects, {}, &Screening::Suspect::scene);
  return screening;
}

std::optional<Result> Screen::screened(const Scene& scene, Outcome outcome, bool coverage_only,
                                       int bits) const {
  if (auto* failure = std::get_if<Failure>(&outcome)) {
    if (failure->kind == FailureKind::unsupported || failure->kind == FailureKind::unavailable)
      return std::nullopt;
    return not_run(std::move(*failure));
  }
  const auto& rendering = std::get<Rendering>(outcome);
  if (coverage_only) return coverage_of(scene, rendering, bits);
  const Rendering exact = rasterize_without_details(scene, resolved_, rendering.sample_positions);
  const RendererFacts facts{bits, profile_ ? &*profile_ : nullptr};
  Result result = compare(scene, resolved_, exact, rendering, facts);
  if (result.disagreements.empty() && result.values.empty()) return std::nullopt;
  return result;
}

std::optional<Result> Screen::coverage_of(const Scene& scene, const Rendering& rendering,
                                          int bits) const {
  const Surface surface = scene.target.surface;
  const RuleChoices& policy = resolved_.on(surface);
  const auto primitives = primitives_of(scene);
  Drawn drawn = drawn_of(primitives.size(), rendering);
  Drawn covered = covered_under(policy, scene.target, primitives);
  // Pixels that the specification's own choice draws, too, are beyond doubt.
  if (drawn == covered && drawn == covered_under(standard_choices(), scene.target, primitives))
    return std::nullopt;
  std::vector<PrimitiveCoverage> coverage;
  for (std::size_t i = 0; i < primitives.size(); ++i)
    coverage.push_back({{std::move(covered[i])}, {std::move(drawn[i])}});
  Result result;
  compare_coverage({scene,
                    primitives,
                    coverage,
                    policy,
                    profile_ ? &profile_->on(surface) : nullptr,
                    policy_.latitude,
                    latitude_bits(bits),
                    false,
                    {}},
                   result);
  if (result.disagreements.empty()) return std::nullopt;
  return result;
}

}  // namespace edgecase
