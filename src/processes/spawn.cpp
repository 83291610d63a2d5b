// SPDX-License-Identifier: MIT
#include "processes/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "processes/process_tree.h"

extern char** environ;

namespace edgecase {
namespace {

constexpr int kPipeSize = 1 << 20;
// Where the program holds an end of the pipe that ties it to us.
constexpr int kLifeDescriptor = 3;

struct Pipe {
  Descriptor read;
  Descriptor write;
};

std::vector<std::string> environment_of(const Command& command) {
  std::vector<std::string> result;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::string name = text.substr(0, text.find('='));
    if (command.environment.count(name) == 0 &&
        std::find(command.unset.begin(), command.unset.end(), name) == command.unset.end())
      result.push_back(text);
  }
  for (const auto& [name, value] : command.environment) result.push_back(name + "=" + value);
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

void set_nonblocking(int descriptor) {
  fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
  // Fewer switches between the two processes; a smaller pipe works as well.
  fcntl(descriptor, F_SETPIPE_SZ, kPipeSize);
}

// posix_spawn's attributes and file actions, destroyed in every case.
struct SpawnSettings {
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_t actions;

  SpawnSettings() {
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_init(&actions);
    sigset_t none;
    sigemptyset(&none);
    sigset_t defaults;
    sigemptyset(&defaults);
    for (int signal : {SIGPIPE, SIGINT, SIGTERM, SIGQUIT, SIGXFSZ}) sigaddset(&defaults, signal);
    posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
  }
  ~SpawnSettings() {
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
};

bool make_pipe(Pipe& pipe) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return false;
  pipe.read = Descriptor(ends[0]);
  pipe.write = Descriptor(ends[1]);
  // Should we run without standard streams, a pipe may take their numbers: dup2 onto itself would
  // then be lost in the child, so keep clear of them.
  for (Descriptor* end : {&pipe.read, &pipe.write})
    if (end->number() <= STDERR_FILENO)
      *end = Descriptor(fcntl(end->number(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  return pipe.read.is_open() && pipe.write.is_open();
}

// A program that reads notices our end by that of its input; one that never reads does not. So the
// kernel is asked to send SIGKILL to its group when a pipe is closed of which we alone have the
// writing end: SIGIO, with another signal in its place. PR_SET_PDEATHSIG would tie it to
// the thread that started it, and would leave its own children alive. Nothing ties a program to us
// between its start and this call, a few microseconds.
void tie_to_us(int end, pid_t program) {
  fcntl(end, F_SETOWN, -program);
  fcntl(end, F_SETSIG, SIGKILL);
  fcntl(end, F_SETFL, fcntl(end, F_GETFL) | O_ASYNC);
}

}  // namespace

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

void Descriptor::close() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

std::variant<Spawned, std::string> spawn(const Command& command) {
  Pipe in;
  Pipe out;
  Pipe err;
  Pipe life;
  if (!make_pipe(in) || !make_pipe(out) || !make_pipe(err) || !make_pipe(life))
    return fmt::format("no pipe can be made: {}", strerror(errno));
  SpawnSettings settings;
  posix_spawn_file_actions_adddup2(&settings.actions, in.read.number(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&settings.actions, out.write.number(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&settings.actions, err.write.number(), STDERR_FILENO);
  // Last, since the others may have this number in us.
  posix_spawn_file_actions_adddup2(&settings.actions, life.read.number(), kLifeDescriptor);
  if (!command.folder.empty())
    posix_spawn_file_actions_addchdir_np(&settings.actions, command.folder.c_str());
  std::vector<std::string> arguments = command.argv;
  std::vector<std::string> environment = environment_of(command);
  Spawned spawned;
  const auto start = [&](pid_t& pid) {
    return posix_spawnp(&pid, arguments.front().c_str(), &settings.actions, &settings.attributes,
                        pointers(arguments).data(), pointers(environment).data());
  };
  const int failure = start_program(start, spawned.pid);
  if (failure != 0)
    return fmt::format("'{}' cannot be started: {}", command.argv.front(), strerror(failure));
  tie_to_us(life.read.number(), spawned.pid);
  spawned.input = std::move(in.write);
  spawned.output = std::move(out.read);
  spawned.errors = std::move(err.read);
  spawned.life = std::move(life.write);
  for (const Descriptor* end : {&spawned.input, &spawned.output, &spawned.errors})
    set_nonblocking(end->number());
  return spawned;
}

}  // namespace edgecase
