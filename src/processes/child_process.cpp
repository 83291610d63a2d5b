// SPDX-License-Identifier: MIT
#include "processes/child_process.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <thread>

#include "processes/process_tree.h"

namespace edgecase {

namespace {

using std::chrono::milliseconds;

constexpr std::size_t kChunk = std::size_t{1} << 16;
constexpr std::size_t kMuch = std::size_t{1} << 20;  // bytes; more are freed when not in use
constexpr std::size_t kErrorOutput = 2000;
// How long a program may take to end after its input was closed, or after it closed its output.
constexpr milliseconds kFarewell{500};
// How often a program that neither reads nor writes is checked, because a grandchild may keep its
// output open after its death; and how often `stop` is checked.
constexpr milliseconds kGlance{100};

// Blocks SIGPIPE on this thread and swallows the one that a write of ours raised, so that neither
// the process's signal handlers nor other threads notice.
class SigpipeGuard {
 public:
  SigpipeGuard() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~SigpipeGuard() {
    const timespec now{};
    if (!was_pending_)
      while (sigtimedwait(&pipe_, nullptr, &now) < 0 && errno == EINTR) {
      }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  SigpipeGuard(const SigpipeGuard&) = delete;
  SigpipeGuard& operator=(const SigpipeGuard&) = delete;

 private:
  sigset_t pipe_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

}  // namespace

std::variant<std::unique_ptr<ChildProcess>, std::string> ChildProcess::start(
    const Command& command) {
  auto spawned = spawn(command);
  if (auto* error = std::get_if<std::string>(&spawned)) return std::move(*error);
  return std::unique_ptr<ChildProcess>(new ChildProcess(std::get<Spawned>(std::move(spawned))));
}

ChildProcess::ChildProcess(Spawned spawned)
    : pid_(spawned.pid),
      input_(std::move(spawned.input)),
      output_(std::move(spawned.output)),
      errors_(std::move(spawned.errors)),
      life_(std::move(spawned.life)) {}

ChildProcess::~ChildProcess() {
  if (pid_ < 0) return;
  input_.close();
  wait_for_end(kFarewell);
  reap();
}

// Drops the part of the request that the program will never read.
void ChildProcess::write_some() {
  const SigpipeGuard guard;
  while (!has_written()) {
    const ssize_t count = ::write(input_.number(), unsent_.data() + sent_, unsent_.size() - sent_);
    if (count < 0 && errno != EAGAIN && errno != EINTR) break;
    if (count < 0) return;
    sent_ += static_cast<std::size_t>(count);
  }
  unsent_.clear();
  sent_ = 0;
}

// False at the end of its output.
bool ChildProcess::read_some() {
  std::array<char, kChunk> chunk;
  const ssize_t count = ::read(output_.number(), chunk.data(), chunk.size());
  if (count < 0) return errno == EAGAIN || errno == EINTR;
  received_.append(chunk.data(), static_cast<std::size_t>(count));
  return count > 0;
}

void ChildProcess::drain_errors() {
  std::array<char, kChunk> chunk;
  const ssize_t count =
      errors_.is_open() ? ::read(errors_.number(), chunk.data(), chunk.size()) : 0;
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (count <= 0) return errors_.close();
  error_output_.append(chunk.data(), static_cast<std::size_t>(count));
  if (error_output_.size() > kErrorOutput)
    error_output_.erase(0, error_output_.size() - kErrorOutput);
}

bool ChildProcess::take_line(std::string& answer) {
  const std::size_t end = received_.find('\n', searched_);
  searched_ = received_.size();
  if (end == std::string::npos) return false;
  answer = received_.substr(0, end);
  received_.erase(0, end + 1);
  searched_ = 0;
  return true;
}

std::size_t ChildProcess::announced_length() const {
  std::uint64_t length = 0;
  if (received_.size() - taken_ < sizeof(length)) return 0;
  std::memcpy(&length, received_.data() + taken_, sizeof(length));
  return static_cast<std::size_t>(length);
}

bool ChildProcess::take_message(std::string_view& answer) {
  constexpr std::size_t kHead = sizeof(std::uint64_t);
  const std::size_t length = announced_length();
  if (received_.size() - taken_ < kHead || received_.size() - taken_ - kHead < length) return false;
  answer = std::string_view(received_).substr(taken_ + kHead, length);
  taken_ += kHead + length;
  return true;
}

// Reuses the room of answered messages; frees it if it is as large as a picture.
void ChildProcess::make_room() {
  received_.erase(0, taken_);
  taken_ = 0;
  if (received_.capacity() > kMuch && received_.size() < kMuch / 2) received_.shrink_to_fit();
}

void ChildProcess::forget_message() {
  if (received_.capacity() > kMuch) make_room();
}

// Waits until something can be read or written, and does so. Returns a status if the exchange is
// over.
std::optional<ChildProcess::Status> ChildProcess::turn(Clock::time_point deadline,
                                                       const std::atomic<bool>* stop) {
  if (stop != nullptr && stop->load()) return Status::stopped;
  const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
  if (left.count() <= 0) return Status::timed_out;
  std::array<pollfd, 3> polled{{
      {output_.number(), POLLIN, 0},
      {has_written() ? -1 : input_.number(), POLLOUT, 0},
      {errors_.number(), POLLIN, 0},
  }};
  const int ready =
      poll(polled.data(), polled.size(), static_cast<int>(std::min(left, kGlance).count()));
  if (polled[2].revents != 0 && ready > 0) drain_errors();
  if (ready > 0 && polled[1].revents != 0) write_some();
  if (ready > 0 && polled[0].revents != 0 && !read_some()) return Status::ended;
  if (ready == 0 && has_ended()) return Status::ended;
  return std::nullopt;
}

// The program's last output may be an answer, but there is no process for the next scene. Its
// standard error says why.
ChildProcess::Status ChildProcess::end(bool answered) {
  wait_for_end(kFarewell);
  return answered ? Status::answered : Status::ended;
}

ChildProcess::Status ChildProcess::exchange(std::string_view request, std::string& answer,
                                            std::size_t max_line_length, Clock::time_point deadline,
                                            const std::atomic<bool>* stop) {
  unsent_ = std::string(request) + "\n";
  sent_ = 0;
  bool answered = false;
  while (true) {
    // A line that comes before the whole request was read is still an answer to it, but the rest of
    // the request must go out first, or the next one would start in its middle.
    answered = answered || take_line(answer);
    if (answered && has_written()) return Status::answered;
    if (received_.size() > max_line_length) return Status::too_long;
    const auto status = turn(deadline, stop);
    if (status == Status::ended) return end(answered || take_line(answer));
    if (status) return *status;
  }
}

void ChildProcess::send(std::string_view message) {
  const std::uint64_t length = message.size();
  unsent_.append(reinterpret_cast<const char*>(&length), sizeof(length));
  unsent_ += message;
  write_some();
}

ChildProcess::Status ChildProcess::receive(std::string_view& answer, std::size_t max_length,
                                           Clock::time_point deadline,
                                           const std::atomic<bool>* stop) {
  while (!take_message(answer)) {
    const std::size_t length = announced_length();
    if (length > max_length) return Status::too_long;
    make_room();
    if (length > kMuch) received_.reserve(length + kChunk);
    const auto status = turn(deadline, stop);
    if (status == Status::ended) return end(take_message(answer));
    if (status) return *status;
  }
  return Status::answered;
}

const std::string& ChildProcess::unasked_output(milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  auto left = patience;
  while (received_.empty() && output_.is_open() && left.count() >= 0) {
    pollfd polled{output_.number(), POLLIN, 0};
    if (poll(&polled, 1, static_cast<int>(std::min(left, kGlance).count())) > 0 && !read_some())
      break;
    drain_errors();
    left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
    if (left.count() == 0) break;
  }
  return received_;
}

bool ChildProcess::finish(milliseconds patience) {
  input_.close();
  const auto deadline = Clock::now() + patience;
  while (!has_ended() && Clock::now() < deadline) {
    read_some();
    wait_for_end(milliseconds(10));
  }
  while (has_ended() && output_.is_open()) {
    const std::size_t before = received_.size();
    if (!read_some() || received_.size() == before) break;
  }
  reap();
  return ended_by_itself_;
}

bool ChildProcess::has_ended() {
  if (pid_ < 0) return true;
  siginfo_t info{};
  // WNOWAIT leaves the program to be reaped: until then no other process can get its number.
  if (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0) return true;
  return info.si_pid == pid_;
}

bool ChildProcess::wait_for_end(milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  milliseconds nap{1};
  while (!has_ended()) {
    if (Clock::now() >= deadline) return false;
    // Its last output may be longer than the pipe.
    drain_errors();
    std::this_thread::sleep_for(nap);
    nap = std::min(nap * 2, milliseconds(20));
  }
  return true;
}

void ChildProcess::reap() {
  if (pid_ < 0) return;
  ended_by_itself_ = has_ended();
  wait_status_ = end_program(pid_);
  pid_ = -1;
  for (std::size_t before = error_output_.size() + 1;
       errors_.is_open() && before != error_output_.size();) {
    before = error_output_.size();
    drain_errors();
  }
  input_.close();
  output_.close();
  errors_.close();
  life_.close();
}

std::string ChildProcess::how_it_ended() const {
  if (pid_ >= 0 || !ended_by_itself_) return "";
  if (WIFEXITED(wait_status_)) return fmt::format("exit status {}", WEXITSTATUS(wait_status_));
  const int signal = WTERMSIG(wait_status_);
  return fmt::format("signal {} ({})", signal, strsignal(signal));
}

int ChildProcess::exit_status() const {
  return pid_ < 0 && ended_by_itself_ && WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : -1;
}

}  // namespace edgecase
