// SPDX-License-Identifier: MIT
#include "tools/edgecase/interrupt.h"

#include <csignal>

namespace edgecase {
namespace {

constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> flag = false;
// A signal handler must not use locks.
static_assert(std::atomic<bool>::is_always_lock_free);

void raise_flag(int) {
  flag = true;
}

}  // namespace

InterruptGuard::InterruptGuard() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    before_[i] = std::signal(kSignals[i], raise_flag);
    // A signal that was ignored when the program started (nohup) stays ignored.
    if (before_[i] == SIG_IGN) std::signal(kSignals[i], SIG_IGN);
  }
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) std::signal(kSignals[i], before_[i]);
}

const std::atomic<bool>& interrupted() {
  return flag;
}

}  // namespace edgecase
