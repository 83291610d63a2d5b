// SPDX-License-Identifier: MIT
#include "profile/samples/sample_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace edgecase {

std::vector<Observation> SampleDrawing::seen(const std::string& family, std::vector<Scene> scenes) {
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

std::vector<ToldSamples> SampleDrawing::told(const std::string& family, std::vector<Scene> scenes) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    tasks.push_back({fmt::format("{}/{:05}", family, i), &scenes[i]});
  std::vector<ToldSamples> result;
  renderer_.render(tasks, [&](std::size_t i, Outcome outcome) {
    if (stop_ != nullptr && stop_->load()) throw MeasurementStopped{};
    count(1);
    if (auto* rendering = std::get_if<Rendering>(&outcome)) {
      note("");
      result.push_back({scenes[i], std::move(*rendering)});
      return;
    }
    const auto& failure = std::get<Failure>(outcome);
    note(fmt::format("{}: {}", name_of(failure.kind), failure.reason));
  });
  return result;
}

std::string SampleDrawing::refusal_of(const Scene& scene) {
  const Task task{fmt::format("samples/{}", scene.target.samples), &scene};
  std::string refusal;
  renderer_.render({&task, 1}, [&](std::size_t, const Outcome& outcome) {
    if (const auto* failure = std::get_if<Failure>(&outcome)) refusal = failure->reason;
  });
  count(1);
  if (refusal.empty()) ++counts_.scenes;
  return refusal;
}

void SampleDrawing::finish() {
  count(left_);
}

void SampleDrawing::count(std::size_t scenes) {
  const std::size_t more = std::min(scenes, left_);
  left_ -= more;
  if (progress_ && more > 0) progress_(more);
}

void SampleDrawing::note(const std::string& failure) {
  ++(failure.empty() ? counts_.scenes : counts_.not_drawn);
  if (counts_.first_failure.empty()) counts_.first_failure = failure;
}

}  // namespace edgecase
