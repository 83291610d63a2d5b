// SPDX-License-Identifier: MIT
#include "profile/scene_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

namespace edgecase {
namespace {

// Scenes of one size together: some window systems pay for every change of size.
std::vector<std::size_t> by_size(const std::vector<Scene>& scenes) {
  std::vector<std::size_t> order(scenes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Target& s = scenes[a].target;
    const Target& t = scenes[b].target;
    return std::tie(s.width, s.height) < std::tie(t.width, t.height);
  });
  return order;
}

}  // namespace

std::vector<Observation> SceneDrawing::seen(const std::string& family, std::vector<Scene> scenes) {
  std::vector<Observation> observations(scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    observations[i].id = fmt::format("{}/{:05}", family, i);
    observations[i].scene = std::move(scenes[i]);
  }
  observe(
      renderer_, observations, [&](std::size_t more) { count(more); }, stop_);
  for (const Observation& observation : observations) note(observation.failure);
  return observations;
}

std::vector<DrawnScene> SceneDrawing::told(const std::string& family, std::vector<Scene> scenes) {
  const std::vector<std::size_t> order = by_size(scenes);
  std::vector<Task> tasks;
  for (const std::size_t i : order)
    tasks.push_back({fmt::format("{}/{:05}", family, i), &scenes[i]});
  std::vector<std::optional<Rendering>> renderings(scenes.size());
  renderer_.render(tasks, [&](std::size_t i, Outcome outcome) {
    if (stop_ != nullptr && stop_->load()) throw MeasurementStopped{};
    count(1);
    if (auto* rendering = std::get_if<Rendering>(&outcome)) {
      note("");
      renderings[order[i]] = std::move(*rendering);
      return;
    }
    const auto& failure = std::get<Failure>(outcome);
    note(fmt::format("{}: {}", name_of(failure.kind), failure.reason));
  });
  std::vector<DrawnScene> result;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    if (renderings[i]) result.push_back({std::move(scenes[i]), std::move(*renderings[i])});
  return result;
}

std::string SceneDrawing::refusal_of(const Scene& scene) {
  const Task task{"refusal", &scene};
  std::string refusal;
  renderer_.render({&task, 1}, [&](std::size_t, const Outcome& outcome) {
    if (const auto* failure = std::get_if<Failure>(&outcome)) refusal = failure->reason;
  });
  count(1);
  if (refusal.empty()) ++counts_.scenes;
  return refusal;
}

void SceneDrawing::finish() {
  count(left_);
}

void SceneDrawing::count(std::size_t scenes) {
  const std::size_t more = std::min(scenes, left_);
  left_ -= more;
  if (progress_ && more > 0) progress_(more);
}

void SceneDrawing::note(const std::string& failure) {
  ++(failure.empty() ? counts_.scenes : counts_.not_drawn);
  if (counts_.first_failure.empty()) counts_.first_failure = failure;
}

}  // namespace edgecase
