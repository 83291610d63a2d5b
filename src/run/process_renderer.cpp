// SPDX-License-Identifier: MIT
#include "run/process_renderer.h"

#include <fmt/format.h>

#include <algorithm>

#include "wire/answer_line.h"
#include "wire/request_line.h"

namespace edgecase {

namespace {

constexpr int kMostSilentDeaths = 3;
// The exit status by which a program says that it cannot work here at all.
constexpr int kUnavailableStatus = 3;
constexpr std::size_t kLongestQuote = 300;

// The smallest scene: one pixel, nothing drawn.
Scene empty_scene() {
  Scene scene;
  scene.target.width = 1;
  scene.target.height = 1;
  scene.viewport = {0, 0, 1, 1};
  return scene;
}

// Room for a thousand fragments in each pixel of a small target, for several in each of a large
// one; and for the chains of textures whose levels the renderer generates, 32 bytes a number.
std::size_t longest_answer(const Scene& scene) {
  constexpr std::size_t kBase = std::size_t{1} << 26;
  constexpr std::size_t kPerSample = 1024;
  // A chain has at most twice the numbers of its first level.
  constexpr std::size_t kPerNumber = 2 * 32;
  std::size_t chains = 0;
  for (const auto& texture : scene.textures)
    if (texture->generated) chains += kPerNumber * texture->levels[0].texels.size();
  const auto samples = static_cast<std::size_t>(scene.target.width) *
                       static_cast<std::size_t>(scene.target.height) *
                       static_cast<std::size_t>(scene.target.samples);
  return std::min(kMaxLineLength, kBase + chains + kPerSample * samples);
}

// Runs of pixels cannot tell which samples are covered: several samples take whole answers.
bool takes_coverage(const Task& task) {
  return task.coverage_only && task.scene->target.samples == 1;
}

// The end of a text as one line of printable characters.
std::string last_words(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  if (text.size() > kLongestQuote) text = "..." + text.substr(text.size() - kLongestQuote);
  std::replace(text.begin(), text.end(), '\n', '|');
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return text;
}

}  // namespace

ProcessRenderer::ProcessRenderer(ProcessSpec spec) : spec_(std::move(spec)) {
  info_.name = spec_.name;
  if (spec_.command.argv.empty()) unavailable_ = "the renderer names no program";
}

void ProcessRenderer::render(std::span<const Task> tasks, const OutcomeSink& sink) {
  for (std::size_t i = 0; i < tasks.size(); ++i) sink(i, render_one(tasks[i]));
}

Outcome ProcessRenderer::render_one(const Task& task) {
  if (!unavailable_.empty()) return Failure{FailureKind::unavailable, unavailable_};
  Outcome outcome = attempt(task);
  if (silent_deaths_ < kMostSilentDeaths || ever_answered_) return outcome;
  // Three scenes in a row may each be fatal to a program that works: ask for next to nothing.
  if (answers_an_empty_scene()) return outcome;
  if (unavailable_.empty())
    unavailable_ = fmt::format("the program failed {} times without ever answering; lastly, {}",
                               kMostSilentDeaths, std::get<Failure>(outcome).reason);
  return Failure{FailureKind::unavailable, unavailable_};
}

bool ProcessRenderer::answers_an_empty_scene() {
  const Scene scene = empty_scene();
  attempt({"start-up", &scene});
  return ever_answered_;
}

bool ProcessRenderer::start() {
  child_answered_ = false;
  auto started = ChildProcess::start(spec_.command);
  if (const auto* error = std::get_if<std::string>(&started)) {
    unavailable_ = *error;
    return false;
  }
  child_ = std::move(std::get<std::unique_ptr<ChildProcess>>(started));
  return true;
}

Outcome ProcessRenderer::attempt(const Task& task) {
  // What lies there before the scene is asked for is no answer to it, but a second one to the scene
  // before. Only a new process is sure to be in step.
  if (child_ != nullptr && !child_->unasked_output(std::chrono::milliseconds{0}).empty())
    child_.reset();
  if (child_ == nullptr && !start()) return Failure{FailureKind::unavailable, unavailable_};
  const Scene& scene = *task.scene;
  const std::string scene_text = scene_json(scene);
  const std::string request = request_line(task.id, scene_text, takes_coverage(task));
  std::string answer;
  const auto status = child_->exchange(request, answer, longest_answer(scene),
                                       ChildProcess::Clock::now() + patience(), spec_.stop);
  if (status == ChildProcess::Status::answered) return read(answer, digest_of(scene_text), task);
  Failure failure = failure_of(status);
  child_.reset();
  return failure;
}

Outcome ProcessRenderer::read(const std::string& line, const std::string& digest,
                              const Task& task) {
  child_answered_ = true;
  ever_answered_ = true;
  silent_deaths_ = 0;
  auto parsed = parse_answer(line, digest, *task.scene, takes_coverage(task));
  if (const auto* error = std::get_if<WireError>(&parsed)) {
    // Nobody knows what else is on its way: only a new process is sure to be in step.
    child_->kill();
    Failure failure{FailureKind::garbage,
                    "its answer is refused: " + error->message + quote_errors()};
    child_.reset();
    return failure;
  }
  Answer& answer = std::get<Answer>(parsed);
  if (answer.claims) {
    info_ = std::move(*answer.claims);
    info_.name = spec_.name;
  }
  return std::move(answer.outcome);
}

// A program that has shown that it can start is given less time to do so again.
std::chrono::milliseconds ProcessRenderer::patience() const {
  if (child_answered_) return spec_.timeout;
  return spec_.timeout + (ever_answered_ ? spec_.restart_timeout : spec_.startup_timeout);
}

Failure ProcessRenderer::failure_of(ChildProcess::Status status) {
  const bool silent = !child_answered_;
  child_->kill();
  if (status == ChildProcess::Status::stopped)
    return {FailureKind::timed_out, "the run was interrupted"};
  if (silent) ++silent_deaths_;
  if (silent && child_->exit_status() == kUnavailableStatus) {
    unavailable_ = "the program cannot work here" + quote_errors();
    return {FailureKind::unavailable, unavailable_};
  }
  if (status == ChildProcess::Status::too_long)
    return {FailureKind::garbage,
            "its answer goes on without a line break, far beyond what this scene can need"};
  if (status == ChildProcess::Status::timed_out) {
    return {FailureKind::timed_out,
            fmt::format("no answer within {} ms{}", patience().count(), quote_errors())};
  }
  const std::string how = child_->how_it_ended();
  const std::string when = silent ? "before its first answer" : "while drawing this scene";
  return {FailureKind::crashed, fmt::format("the program {} {}{}",
                                            how.empty() ? "closed its output" : "ended with " + how,
                                            when, quote_errors())};
}

std::string ProcessRenderer::quote_errors() const {
  const std::string words = last_words(child_->error_output());
  return words.empty() ? "" : fmt::format("; it said: {}", words);
}

}  // namespace edgecase
