// SPDX-License-Identifier: MIT
#include "processes/process_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "casefile/json/text.h"
#include "casefile/scene/scene_reader.h"
#include "wire/message.h"
#include "wire/request_line.h"

namespace edgecase {

namespace {

constexpr int kMostSilentDeaths = 3;
// The exit status of a program that cannot work on this machine.
constexpr int kUnavailableStatus = 3;
constexpr std::size_t kLongestQuote = 300;
constexpr std::size_t kLongestRefusal = 1000;
// The most requests that a worker has at a time, and the most bytes of them: what fits into a pipe.
constexpr std::size_t kMostAsked = 16;
constexpr std::size_t kMostAskedBytes = std::size_t{1} << 19;

// The smallest scene: one pixel, nothing drawn.
Scene empty_scene() {
  Scene scene;
  scene.target.width = 1;
  scene.target.height = 1;
  scene.viewport = {0, 0, 1, 1};
  return scene;
}

// Runs of pixels do not say which samples are covered, so multisampled targets need whole answers.
bool takes_coverage(const Task& task) {
  return task.coverage_only && task.scene->target.samples == 1;
}

// The end of a text as one line of printable characters. Programs may write any bytes, and the cut
// may split a character; invalid UTF-8 would make files with this text unreadable.
std::string last_words(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  const bool is_cut = text.size() > kLongestQuote;
  if (is_cut) text.erase(0, text.size() - kLongestQuote);
  std::replace(text.begin(), text.end(), '\n', '|');
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return (is_cut ? "..." : "") + clean_line(std::move(text));
}

}  // namespace

// For each sample of each pass the numbers of its pixel, depth, stencil and hits; fragments, four
// times as many as there may be and as fill the target, but no more than one of each primitive at
// each sample; for generated mip chains, 32 bytes a number; for claims and for small mistakes, a
// sum that takes little memory to read.
std::size_t longest_answer(const Scene& scene) {
  constexpr double kBase = 1 << 23;
  constexpr double kPerSample = 256;
  // A chain has at most twice the numbers of its first level.
  constexpr double kPerNumber = 2 * 32;
  const double per_fragment = scene.details.any() ? 1024 : 256;
  double chains = 0;
  for (const auto& texture : scene.textures)
    if (texture->generated)
      chains += kPerNumber * static_cast<double>(texture->levels[0].texels.size());
  double primitives = 0;  // at most one a vertex
  for (const Draw& draw : scene.draws) primitives += static_cast<double>(draw.vertices.size());
  const double samples =
      static_cast<double>(scene.target.width) * scene.target.height * scene.target.samples;
  const auto passes = static_cast<double>(std::max<std::size_t>(1, scene.supersampling.size()));
  const double drawn = static_cast<double>(most_drawn_samples(scene)) + passes * samples;
  const double fragments = std::min(4 * drawn, passes * samples * primitives);
  const double bytes = kBase + passes * (chains + samples * kPerSample) + fragments * per_fragment;
  return static_cast<std::size_t>(std::min(bytes, static_cast<double>(kMaxLineLength)));
}

std::chrono::milliseconds startup_patience(std::chrono::milliseconds timeout) {
  return std::clamp(4 * timeout, std::chrono::milliseconds(5'000),
                    std::chrono::milliseconds(30'000));
}

ProcessRenderer::ProcessRenderer(ProcessSpec spec) : spec_(std::move(spec)) {
  info_.name = spec_.name;
  if (spec_.command.argv.empty()) unavailable_ = "the renderer names no program";
  if (spec_.takes_messages) spec_.command.argv.push_back(kMessagesOption);
}

void ProcessRenderer::render(std::span<const Task> tasks, const OutcomeSink& sink) {
  // If a sink threw, some scenes are unanswered.
  if (!asked_.empty()) end_child();
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    Outcome outcome = render_one(tasks[i]);
    send_ahead(tasks.subspan(i + 1));
    sink(i, std::move(outcome));
  }
}

// Lets the child draw the next scenes while the last answer is compared. Several at once, because
// waking an idle child costs as much as comparing some hundred fragments.
void ProcessRenderer::send_ahead(std::span<const Task> tasks) {
  if (!spec_.takes_messages || child_ == nullptr || !child_answered_) return;
  if (asked_.size() > kMostAsked / 2) return;
  std::size_t bytes = 0;
  for (const Asked& one : asked_) bytes += one.bytes;
  while (asked_.size() < std::min(kMostAsked, tasks.size()) && bytes < kMostAskedBytes) {
    send(tasks[asked_.size()]);
    bytes += asked_.back().bytes;
  }
}

void ProcessRenderer::send(const Task& task) {
  const OutgoingRequest request = request_message(task.id, *task.scene, takes_coverage(task));
  child_->send(request.bytes);
  asked_.push_back({&task, request.digest, request.bytes.size()});
}

void ProcessRenderer::end_child() {
  child_.reset();
  asked_.clear();
}

Outcome ProcessRenderer::render_one(const Task& task) {
  if (!unavailable_.empty()) return Failure{FailureKind::unavailable, unavailable_};
  Outcome outcome = attempt(task);
  if (silent_deaths_ < kMostSilentDeaths || ever_answered_) return outcome;
  // A working program may crash at three scenes in a row, so try the simplest scene.
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
  return spec_.takes_messages ? attempt_message(task) : attempt_line(task);
}

Outcome ProcessRenderer::attempt_line(const Task& task) {
  // Output before the request is a second answer to the previous scene. Only a new process is
  // surely in step.
  if (child_ != nullptr && !child_->unasked_output(std::chrono::milliseconds{0}).empty())
    end_child();
  if (child_ == nullptr && !start()) return Failure{FailureKind::unavailable, unavailable_};
  const Scene& scene = *task.scene;
  const std::string scene_text = scene_json(scene);
  const std::string request = request_line(task.id, scene_text, takes_coverage(task));
  std::string answer;
  const auto status = child_->exchange(request, answer, longest_answer(scene),
                                       ChildProcess::Clock::now() + patience(), spec_.stop);
  if (status == ChildProcess::Status::answered) {
    note_answer();
    auto parsed = parse_answer(answer, digest_of(scene_text), scene, takes_coverage(task));
    if (const auto* error = std::get_if<WireError>(&parsed)) return refuse(error->message);
    auto& read = std::get<Answer>(parsed);
    return take(std::move(read.outcome), std::move(read.claims));
  }
  Failure failure = failure_of(status);
  end_child();
  return failure;
}

// A failure belongs to the first scene without an answer, because the worker draws them in order;
// the next ones are requested again. Its time starts when the previous answer has come.
Outcome ProcessRenderer::attempt_message(const Task& task) {
  if (child_ == nullptr && !start()) return Failure{FailureKind::unavailable, unavailable_};
  if (asked_.empty()) send(task);
  const Asked asked = asked_.front();
  std::string_view answer;
  const auto status = child_->receive(answer, longest_answer(*task.scene),
                                      ChildProcess::Clock::now() + patience(), spec_.stop);
  if (status == ChildProcess::Status::answered) {
    asked_.pop_front();
    note_answer();
    auto parsed = parse_answer_message(answer, asked.digest, *task.scene, takes_coverage(task));
    child_->forget_message();
    if (const auto* error = std::get_if<WireError>(&parsed)) return refuse(error->message);
    auto& read = std::get<Answer>(parsed);
    digest_ = read.digest;
    return take(std::move(read.outcome), std::move(read.claims));
  }
  Failure failure = failure_of(status);
  end_child();
  return failure;
}

void ProcessRenderer::note_answer() {
  child_answered_ = true;
  ever_answered_ = true;
  silent_deaths_ = 0;
}

// More output may follow, so only a new process is surely in step.
Outcome ProcessRenderer::refuse(const std::string& why) {
  child_->kill();
  // It may quote the answer.
  const std::string words(beginning_of(clean_line(why), kLongestRefusal));
  Failure failure{FailureKind::garbage, "its answer is refused: " + words + quote_errors()};
  end_child();
  return failure;
}

Outcome ProcessRenderer::take(Outcome outcome, std::optional<RendererInfo> claims) {
  if (claims) {
    info_ = std::move(*claims);
    info_.name = spec_.name;
  }
  return outcome;
}

// A program that has started once gets less time for a restart.
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
