// SPDX-License-Identifier: MIT
#include "search/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <variant>

#include "diff/compare.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

// Groups scenes by size, since changes of size are slow in some window systems.
std::vector<std::size_t> by_size(std::span<const Scene> scenes) {
  std::vector<std::size_t> order(scenes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const auto size = [&](std::size_t i) {
      const Target& target = scenes[i].target;
      return std::tuple(target.surface, target.width, target.height);
    };
    return size(a) < size(b);
  });
  return order;
}

}  // namespace

Trial::Trial(Renderer& renderer, TrialOptions options)
    : renderer_(renderer), options_(std::move(options)), policy_(options_.policy) {
  if (options_.profile) profile_ = *options_.profile;
}

void Trial::read(Surface surface, RunReading reading) {
  options_.readings.insert_or_assign(surface, std::move(reading));
}

TrialAnswer Trial::ask(const Scene& scene) {
  return std::move(ask(std::span(&scene, 1)).front());
}

std::vector<TrialAnswer> Trial::ask(std::span<const Scene> scenes) {
  const auto stopped = [&] { return options_.stop != nullptr && options_.stop->load(); };
  const std::vector<std::size_t> order = by_size(scenes);
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < order.size(); ++k)
    tasks.push_back({fmt::format("search/{}", asked_ + k), &scenes[order[k]]});
  std::vector<TrialAnswer> answers(scenes.size());
  if (stopped()) throw SearchStopped{};
  renderer_.render(tasks, [&](std::size_t k, Outcome outcome) {
    // Being stopped may itself cause a failure.
    if (stopped()) throw SearchStopped{};
    const Scene& scene = scenes[order[k]];
    answers[order[k]] = judged(scene, compare_outcome(scene, std::move(outcome)));
    ++asked_;
  });
  return answers;
}

Result Trial::compare_outcome(const Scene& scene, Outcome outcome) const {
  if (auto* failure = std::get_if<Failure>(&outcome)) return not_run(std::move(*failure));
  const auto& rendering = std::get<Rendering>(outcome);
  const RendererFacts facts = facts_of(renderer_.info(), profile_ ? &*profile_ : nullptr);
  // The renderer may have other sample positions; exact then uses these, too.
  const Rendering exact = rasterize_without_details(scene, policy_, rendering.sample_positions);
  return compare(scene, policy_, exact, rendering, facts);
}

TrialAnswer Trial::judged(const Scene& scene, Result result) const {
  Result* const one = &result;
  const std::span<Result* const> results(&one, 1);
  const Surface surface = scene.target.surface;
  const auto reading = options_.readings.find(surface);
  if (reading == options_.readings.end())
    judge(results, options_.policy.latitude);
  else
    judge(results, options_.policy.latitude, reading->second);
  std::vector<Signature> signatures = signatures_of(result, surface);
  return {std::move(result), std::move(signatures)};
}

}  // namespace edgecase
