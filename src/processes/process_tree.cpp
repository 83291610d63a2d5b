// SPDX-License-Identifier: MIT
#include "processes/process_tree.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace edgecase {
namespace {

namespace fs = std::filesystem;

// Fork bombs may be faster than we are; they are not followed for ever.
constexpr int kMostSweeps = 100;

struct Programs {
  std::mutex mutex;
  std::set<pid_t> running;
  std::set<pid_t> strangers;  // children of ours that are no program's, such as a browser
};

// Never destroyed: a static renderer may end its program after all that was made later is gone.
Programs& programs() {
  static Programs& all = *new Programs;
  return all;
}

// The parent of a process, from its line in /proc: "PID (NAME) STATE PARENT ...". The name may hold
// brackets and blanks. Nothing if the process is gone.
std::optional<pid_t> parent_of(const fs::path& folder) {
  // A process that ends while its line is read is an error (ESRCH): getline makes it a bad stream,
  // an iterator over the buffer would throw it.
  std::ifstream in(folder / "stat");
  std::string line;
  if (!std::getline(in, line, '\0')) return std::nullopt;
  const std::size_t name_end = line.rfind(')');
  constexpr std::size_t kToParent = 4;  // ") S "
  pid_t parent = 0;
  if (name_end == line.npos || name_end + kToParent >= line.size()) return std::nullopt;
  const char* begin = line.data() + name_end + kToParent;
  const auto read = std::from_chars(begin, line.data() + line.size(), parent);
  return read.ec == std::errc{} ? std::optional(parent) : std::nullopt;
}

fs::path folder_of(pid_t process) {
  return fs::path("/proc") / std::to_string(process);
}

using Children = std::multimap<pid_t, pid_t>;  // by parent

Children children_of_all() {
  Children children;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename().string();
    pid_t process = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), process);
    if (read.ec != std::errc{} || read.ptr != name.data() + name.size()) continue;
    if (const auto parent = parent_of(entry.path())) children.emplace(*parent, process);
  }
  return children;
}

struct Descendant {
  pid_t parent;
  pid_t process;
};

// Parents before their children.
std::vector<Descendant> descendants_of(pid_t root, const Children& children) {
  std::vector<Descendant> found = {{0, root}};
  for (std::size_t at = 0; at < found.size(); ++at) {
    const pid_t parent = found[at].process;
    const auto [begin, end] = children.equal_range(parent);
    for (auto child = begin; child != end; ++child) found.push_back({parent, child->second});
  }
  found.erase(found.begin());
  return found;
}

// Its number may belong to another process by now. A descriptor stays with the process that had the
// number when it was made, and the parent shows whether that was the one found.
void kill_if_still(const Descendant& one) {
  const auto descriptor = static_cast<int>(syscall(SYS_pidfd_open, one.process, 0));
  if (descriptor < 0) return;
  const auto parent = parent_of(folder_of(one.process));
  if (parent == one.parent || parent == getpid())
    syscall(SYS_pidfd_send_signal, descriptor, SIGKILL, nullptr, 0);
  close(descriptor);
}

// Whether the process has ended. One that is our child by now is reaped then.
bool has_ended(const Descendant& one, const Programs& all) {
  const auto parent = parent_of(folder_of(one.process));
  if (!parent || all.running.contains(one.process)) return true;
  if (*parent == getpid()) return waitpid(one.process, nullptr, WNOHANG) == one.process;
  return *parent != one.parent;
}

// Waits for what the end of its program ends, too: who drives a browser leaves a process that
// removes the browser's folder. Not for long: another one may mean to stay.
void await_end_of(const std::vector<Descendant>& below, const Programs& all) {
  constexpr std::chrono::milliseconds kNap{10};
  constexpr int kMostNaps = 200;
  for (int nap = 0; nap < kMostNaps; ++nap) {
    if (std::ranges::all_of(below, [&](const Descendant& one) { return has_ended(one, all); }))
      return;
    std::this_thread::sleep_for(kNap);
  }
}

int reap(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::vector<pid_t> own_children(const Children& children) {
  const auto [begin, end] = children.equal_range(getpid());
  std::vector<pid_t> found;
  for (auto child = begin; child != end; ++child) found.push_back(child->second);
  return found;
}

// Our children that are neither programs nor strangers.
std::vector<pid_t> orphans_among(const Children& children, const Programs& all) {
  std::vector<pid_t> orphans = own_children(children);
  std::erase_if(orphans, [&](pid_t child) { return all.strangers.contains(child); });
  return orphans;
}

// Kills the orphans that do not end by themselves, with their descendants.
void end_orphans(const Programs& all) {
  std::vector<Descendant> left;
  for (const pid_t orphan : orphans_among(children_of_all(), all))
    left.push_back({getpid(), orphan});
  await_end_of(left, all);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    const Children children = children_of_all();
    const std::vector<pid_t> orphans = orphans_among(children, all);
    if (orphans.empty()) return;
    for (const pid_t orphan : orphans) {
      for (const Descendant& one : descendants_of(orphan, children)) kill_if_still(one);
      ::kill(orphan, SIGKILL);  // not reaped yet, so that the number is still its own
      reap(orphan);
    }
  }
}

}  // namespace

int start_program(const std::function<int(pid_t&)>& start, pid_t& program) {
  Programs& all = programs();
  const std::lock_guard lock(all.mutex);
  if (all.running.empty()) {
    const std::vector<pid_t> others = own_children(children_of_all());
    all.strangers = {others.begin(), others.end()};
    prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
  }
  const int error = start(program);
  if (error == 0) all.running.insert(program);
  return error;
}

int end_program(pid_t program) {
  Programs& all = programs();
  const std::lock_guard lock(all.mutex);
  const std::vector<Descendant> below = descendants_of(program, children_of_all());
  ::kill(-program, SIGKILL);
  const int status = reap(program);
  all.running.erase(program);
  await_end_of(below, all);
  for (const Descendant& one : below) kill_if_still(one);
  if (!all.running.empty()) return status;
  end_orphans(all);
  prctl(PR_SET_CHILD_SUBREAPER, 0, 0, 0, 0);
  return status;
}

}  // namespace edgecase
