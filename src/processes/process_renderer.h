// SPDX-License-Identifier: MIT
//
// ProcessRenderer: a renderer that lives in a process of its own and speaks reference/PROTOCOL.md;
// our own workers speak the same in bytes (wire/message.h). A worker gets the next few scenes while
// an answer is compared, and answers in order; other programs get one scene at a time.
//
// A crash, a hang or an invalid answer is a Failure of the present scene only; the program is then
// restarted. A program is unavailable for all scenes, and is not tried again, if it cannot be
// started, ends with exit status 3 ("cannot work here"), or dies three times without any answer.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "model/renderer.h"
#include "processes/child_process.h"

namespace edgecase {

struct ProcessSpec {
  std::string name;  // as the command line names the renderer: "osmesa:llvmpipe"
  Command command;
  // Our own worker, which takes kMessagesOption as a further argument, and then speaks in bytes.
  bool takes_messages = false;
  std::chrono::milliseconds timeout{10'000};          // from the request to the whole answer
  std::chrono::milliseconds startup_timeout{30'000};  // added for the very first answer
  std::chrono::milliseconds restart_timeout{5'000};   // added for the first one after a restart
  // Becomes true when answers are not needed any more: the present scene then fails as timed out,
  // and its outcome must be ignored. Or null.
  const std::atomic<bool>* stop = nullptr;
};

// The additional time for a renderer's first answer: four times `timeout`, but 5 to 30 seconds.
std::chrono::milliseconds startup_patience(std::chrono::milliseconds timeout);

// The most bytes of an answer to this scene, as a line or a message: several times what it can
// need. A renderer that goes on has lost its way.
std::size_t longest_answer(const Scene& scene);

// The argument that makes a worker speak in bytes.
constexpr const char* kMessagesOption = "--messages";

class ProcessRenderer final : public Renderer {
 public:
  // Starts nothing: the program starts with the first scene.
  explicit ProcessRenderer(ProcessSpec spec);

  const RendererInfo& info() const override { return info_; }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override;
  std::uint64_t outcome_digest() const override { return digest_; }

 private:
  Outcome render_one(const Task& task);
  bool start();
  Outcome attempt(const Task& task);
  Outcome attempt_line(const Task& task);
  Outcome attempt_message(const Task& task);
  void send(const Task& task);
  void send_ahead(std::span<const Task> tasks);
  void end_child();
  void note_answer();
  Outcome refuse(const std::string& why);
  Outcome take(Outcome outcome, std::optional<RendererInfo> claims);
  std::chrono::milliseconds patience() const;
  Failure failure_of(ChildProcess::Status status);
  bool answers_an_empty_scene();
  std::string quote_errors() const;

  ProcessSpec spec_;
  RendererInfo info_;
  std::unique_ptr<ChildProcess> child_;
  // Requests that the child has not answered yet, in order.
  struct Asked {
    const Task* task = nullptr;
    std::uint64_t digest = 0;
    std::size_t bytes = 0;
  };
  std::deque<Asked> asked_;
  std::uint64_t digest_ = 0;     // of the last answer, if it was bytes (Answer::digest)
  bool child_answered_ = false;  // this process has answered something
  bool ever_answered_ = false;   // any process has
  int silent_deaths_ = 0;        // processes in a row that ended or hung without any answer
  std::string unavailable_;      // why the program is not tried again; empty: it is
};

}  // namespace edgecase
