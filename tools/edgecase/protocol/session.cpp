// SPDX-License-Identifier: MIT
#include "tools/edgecase/protocol/session.h"

#include <fmt/format.h>

#include "wire/answer_line.h"
#include "wire/request_line.h"

namespace edgecase {

namespace {

using std::chrono::milliseconds;

// In bytes: more than any scene of the examination needs.
constexpr std::size_t kLongestAnswer = std::size_t{1} << 26;
// Added to the patience for a program that has just been started.
constexpr milliseconds kStartUp{20'000};
constexpr std::size_t kLongestQuote = 200;

std::string quoted_end(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  if (text.empty()) return "";
  if (text.size() > kLongestQuote) text = "..." + text.substr(text.size() - kLongestQuote);
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = c == '\n' ? '|' : ' ';
  return "; it said: " + text;
}

}  // namespace

ProtocolSession::ProtocolSession(Command command, milliseconds patience,
                                 const std::atomic<bool>* stop)
    : command_(std::move(command)), patience_(patience), stop_(stop) {}

std::string ProtocolSession::start() {
  if (child_) return "";
  if (command_.argv.empty()) return "the renderer names no program";
  auto started = ChildProcess::start(command_);
  if (auto* error = std::get_if<std::string>(&started)) return *error;
  child_ = std::move(std::get<std::unique_ptr<ChildProcess>>(started));
  ++starts_;
  return "";
}

Reply ProtocolSession::ask(const std::string& id, const Scene& scene, bool coverage_only) {
  const std::string text = scene_json(scene);
  return ask_text(request_line(id, text, coverage_only), digest_of(text), scene, coverage_only);
}

Reply ProtocolSession::ask_text(const std::string& request, const std::string& digest,
                                const Scene& scene, bool coverage_only) {
  const bool is_new = child_ == nullptr;
  Reply reply;
  reply.problem = start();
  if (!reply.problem.empty()) return reply;
  const milliseconds patience = patience_ + (is_new ? kStartUp : milliseconds{0});
  const auto status = child_->exchange(request, reply.line, kLongestAnswer,
                                       ChildProcess::Clock::now() + patience, stop_);
  if (status != ChildProcess::Status::answered) return silence(status);
  auto parsed = parse_answer(reply.line, digest, scene, coverage_only);
  if (auto* error = std::get_if<WireError>(&parsed)) {
    reply.kind = Reply::Kind::garbage;
    reply.problem = error->message;
    return reply;
  }
  Outcome& outcome = std::get<Answer>(parsed).outcome;
  if (auto* failure = std::get_if<Failure>(&outcome)) {
    reply.kind = Reply::Kind::refusal;
    reply.problem = failure->reason;
    return reply;
  }
  reply.kind = Reply::Kind::rendering;
  reply.rendering = std::move(std::get<Rendering>(outcome));
  return reply;
}

Reply ProtocolSession::silence(ChildProcess::Status status) {
  Reply reply;
  child_->kill();
  const std::string how = child_->how_it_ended();
  reply.exit_status = child_->exit_status();
  switch (status) {
    case ChildProcess::Status::timed_out:
      reply.problem = "it does not answer in time";
      break;
    case ChildProcess::Status::too_long:
      reply.problem = "its answer goes on without a line break";
      break;
    case ChildProcess::Status::stopped:
      reply.problem = "interrupted";
      break;
    case ChildProcess::Status::answered:
    case ChildProcess::Status::ended:
      reply.problem = how.empty() ? "it closes its output" : "it ends with " + how;
      break;
  }
  reply.problem += quoted_end(child_->error_output());
  child_.reset();
  return reply;
}

}  // namespace edgecase
