// SPDX-License-Identifier: MIT
//
// Interruptions: Ctrl-C, and the signals by which CI systems and closed terminals end a run.
//
// Renderers have process groups of their own, which signals to ours do not reach. So while
// renderers may work, signals only raise a flag. Whoever draws checks it and ends its programs, and
// the command keeps the finished work.
#pragma once

#include <array>
#include <atomic>

namespace edgecase {

// While an object lives, SIGINT, SIGTERM and SIGHUP raise the flag; afterwards their previous
// handlers are restored.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  using Handler = void (*)(int);
  std::array<Handler, 3> before_;
};

// The flag; once raised, it stays raised.
const std::atomic<bool>& interrupted();

}  // namespace edgecase
