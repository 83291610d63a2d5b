// SPDX-License-Identifier: MIT
#include "run/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <mutex>
#include <utility>
#include <variant>
#include <vector>

#include "base/threads.h"
#include "model/renderer.h"
#include "recording/recording.h"
#include "run/renderers.h"
#include "suite/case_store.h"
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
    if (place->block != block_)
      lines_ = recording_->lines(place->block, longest_answer(*task.scene));
    block_ = place->block;
    return recording::outcome_of(lines_.at(place->line), *task.scene);
  } catch (const std::exception& error) {
    return Failure{FailureKind::garbage,
                   fmt::format("the recording holds no answer that can be read: {}", error.what())};
  }
}

namespace {

// What a block holds, in samples of targets: some megabytes of answers. Larger blocks deflate
// little better, and reading one case means reading its block.
constexpr std::size_t kBlockWeight = std::size_t{1} << 16;
// Thrown out of a renderer's sink when recording should end.
struct Stopped {};

class Recorder {
 public:
  Recorder(const Suite& suite, const RecordOptions& options)
      : suite_(suite),
        options_(options),
        slices_(cut_cases(suite.cases, {kBlockWeight})),
        made_(slices_.size()) {}

  Recorded operator()() {
    const auto jobs = static_cast<std::size_t>(std::max(1, options_.jobs));
    run_threads(std::min(jobs, slices_.size()), [this](std::size_t) { work(); });
    return collect();
  }

 private:
  struct Made {
    std::vector<RecordedBlock> blocks;
    RendererInfo renderer;
    std::size_t failures = 0;
  };

  bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

  void work() {
    auto made = make_renderer(options_.renderer, options_.renderer_options);
    Renderer& renderer = *std::get<std::unique_ptr<Renderer>>(made);
    for (std::size_t next = next_++; next < slices_.size() && !stopped(); next = next_++)
      record(slices_[next], renderer, made_[next]);
  }

  void record(const CaseSlice& slice, Renderer& renderer, Made& made) {
    std::vector<Case> cases;
    for (std::size_t i = slice.begin; i < slice.end; ++i) cases.push_back(suite_.cases[i]);
    std::vector<Task> tasks;
    for (const Case& one : cases) tasks.push_back({one.id, &one.scene});
    std::vector<RecordedBlock::Scene> scenes;
    std::vector<std::string> lines;
    std::size_t bytes = 0;
    const auto end_block = [&] {
      if (!lines.empty()) made.blocks.push_back(make_block(std::move(scenes), lines));
      scenes.clear();
      lines.clear();
      bytes = 0;
    };
    try {
      renderer.render(tasks, [&](std::size_t index, Outcome outcome) {
        // A failure may come from being stopped itself.
        const auto* failure = std::get_if<Failure>(&outcome);
        if (stopped() && failure != nullptr) throw Stopped{};
        if (failure != nullptr) note(*failure, made);
        std::string line = recording::stored_line(outcome);
        bytes += line.size() + sizeof(line);
        if (bytes > kLongestBlock) {
          const std::size_t own = line.size() + sizeof(line);
          end_block();
          bytes = own;
        }
        scenes.push_back({tasks[index].id, digest_of(scene_json(*tasks[index].scene))});
        lines.push_back(std::move(line));
        report_progress();
        if (stopped()) throw Stopped{};
      });
    } catch (const Stopped&) {
    }
    made.renderer = renderer.info();
    end_block();
  }

  void note(const Failure& failure, Made& made) {
    ++made.failures;
    if (failure.kind != FailureKind::unavailable) return;
    const std::lock_guard lock(mutex_);
    unavailable_ = failure.reason;
  }

  void report_progress() {
    const std::size_t done = ++done_;
    if (options_.progress) options_.progress(done, suite_.cases.size());
  }

  Recorded collect() {
    Recorded recorded;
    recorded.is_complete = done_ == suite_.cases.size();
    recorded.unavailable = unavailable_;
    recorded.renderer.name = options_.renderer;
    std::vector<RecordedBlock> blocks;
    for (Made& made : made_) {
      // One that never got an answer knows nothing of the renderer.
      if (recorded.renderer.device.empty() && !made.renderer.name.empty())
        recorded.renderer = std::move(made.renderer);
      recorded.failures += made.failures;
      for (RecordedBlock& block : made.blocks) {
        recorded.cases += block.scenes.size();
        blocks.push_back(std::move(block));
      }
    }
    RecordingHead head{options_.tool, recorded.renderer, recorded.is_complete};
    // Of a recording: as if the renderer itself had been asked again.
    head.renderer.name = known_as(recorded.renderer);
    if (is_recording(address_of(recorded.renderer))) head.renderer.traits.erase(kRecordedTrait);
    head.renderer.traits.erase(kAddressTrait);
    recorded.bytes = recording_bytes(head, blocks);
    return recorded;
  }

  const Suite& suite_;
  const RecordOptions& options_;
  std::vector<CaseSlice> slices_;
  std::vector<Made> made_;  // by slice
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> done_ = 0;
  std::mutex mutex_;
  std::string unavailable_;
};

}  // namespace

Recorded record_suite(const Suite& suite, const RecordOptions& options) {
  return Recorder(suite, options)();
}

}  // namespace edgecase
