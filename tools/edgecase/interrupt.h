// SPDX-License-Identifier: MIT
//
// Being asked to stop: Ctrl-C, or the signals by which CI systems and closed terminals end a run.
//
// Renderers live in process groups of their own, which no signal to ours reaches. So while any may
// be at work, the signals only raise a flag: what draws looks at it, ends its programs, and the
// command keeps what was finished.
#pragma once

#include <array>
#include <atomic>

namespace edgecase {

// While an object lives, SIGINT, SIGTERM and SIGHUP raise the flag; then they are what they were.
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

// Raised once, it stays raised.
const std::atomic<bool>& interrupted();

}  // namespace edgecase
