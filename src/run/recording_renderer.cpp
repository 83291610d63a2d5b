// SPDX-License-Identifier: MIT
#include "run/recording_renderer.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <utility>

#include "recording/recording.h"
#include "run/renderer_names.h"
#include "wire/request_line.h"

namespace edgecase {

namespace {

std::filesystem::path path_of(const std::string& renderer) {
  return renderer.substr(kRecordingPrefix.size());
}

}  // namespace

bool is_recording(const std::string& renderer) {
  return split_name(renderer).address.starts_with(kRecordingPrefix);
}

std::string known_name_of(const std::string& renderer) {
  auto [name, address] = split_name(renderer);
  RendererInfo info;
  info.name = name;
  if (name != address) info.traits[kAddressTrait] = address;
  if (is_recording(address)) {
    const auto opened = Recording::open_head(path_of(address));
    if (const auto* head = std::get_if<RecordingHead>(&opened))
      info.traits[kRecordedTrait] = head->renderer.name;
  }
  return known_as(info);
}

std::variant<std::unique_ptr<Renderer>, std::string> open_recording(const std::string& renderer) {
  if (renderer.size() == kRecordingPrefix.size())
    return "recording: names no file; write recording:FILE, with a file that `edgecase record` "
           "made";
  auto opened = Recording::open(path_of(renderer));
  if (auto* error = std::get_if<std::string>(&opened)) return std::move(*error);
  auto recording = std::make_shared<const Recording>(std::get<Recording>(std::move(opened)));
  return std::make_unique<RecordingRenderer>(renderer, std::move(recording));
}

RecordingRenderer::RecordingRenderer(std::string name, std::shared_ptr<const Recording> recording)
    : info_(recording->head().renderer), recording_(std::move(recording)) {
  info_.traits[kRecordedTrait] = std::exchange(info_.name, std::move(name));
}

void RecordingRenderer::render(std::span<const Task> tasks, const OutcomeSink& sink) {
  for (std::size_t i = 0; i < tasks.size(); ++i) sink(i, replay(tasks[i]));
}

Outcome RecordingRenderer::replay(const Task& task) {
  const Recording::Place* place = recording_->find(task.id);
  if (place == nullptr)
    return Failure{FailureKind::unavailable,
                   recording_->head().is_complete
                       ? "not recorded: the recording does not have this case"
                       : "not recorded: the recording was interrupted before this case"};
  if (place->digest != digest_of(scene_json(*task.scene)))
    return Failure{FailureKind::unavailable,
                   "recorded from another scene: the case has changed since; record it again"};
  try {
    if (place->block != block_) lines_ = recording_->lines(place->block);
    block_ = place->block;
    return recording::outcome_of(lines_.at(place->line), *task.scene);
  } catch (const std::exception& error) {
    return Failure{FailureKind::garbage,
                   fmt::format("the recording holds no answer that can be read: {}", error.what())};
  }
}

}  // namespace edgecase
