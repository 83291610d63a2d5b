// SPDX-License-Identifier: MIT
//
// xdg-open ends at once if it hands the file to a desktop, or runs as long as a browser that it
// starts itself. So we wait only a moment. It runs in a session of its own, so that Ctrl-C and the
// end of this program do not affect the browser.
#include "tools/edgecase/output/open_report.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <thread>

namespace edgecase {
namespace {

constexpr const char* kOpener = "xdg-open";
constexpr std::chrono::milliseconds kMoment{2000};

// Discards the output of xdg-open.
class QuietActions {
 public:
  QuietActions() {
    posix_spawn_file_actions_init(&actions_);
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&actions_, descriptor, "/dev/null", O_RDWR, 0);
  }
  ~QuietActions() { posix_spawn_file_actions_destroy(&actions_); }
  QuietActions(const QuietActions&) = delete;
  QuietActions& operator=(const QuietActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

// Starts xdg-open; returns an error as in errno, or 0.
int start(const std::string& path, pid_t& child) {
  const QuietActions actions;
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
  std::string program = kOpener;
  std::string argument = path;
  char* const words[] = {program.data(), argument.data(), nullptr};
  const int error = posix_spawnp(&child, kOpener, actions.get(), &attributes, words, environ);
  posix_spawnattr_destroy(&attributes);
  return error;
}

}  // namespace

std::string open_in_browser(const std::string& path) {
  std::error_code ignored;
  const std::string file = std::filesystem::absolute(path, ignored).string();
  pid_t child = 0;
  if (const int error = start(file, child); error == ENOENT)
    return fmt::format("there is no {} here", kOpener);
  else if (error != 0)
    return fmt::format("{} cannot be started: {}", kOpener, std::strerror(error));
  const auto deadline = std::chrono::steady_clock::now() + kMoment;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() >= deadline) return "";  // at work
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return fmt::format("{} finds no browser", kOpener);
}

}  // namespace edgecase
