// SPDX-License-Identifier: MIT
#include "tools/edgecase/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace edgecase {

ProgressLine::ProgressLine(const std::string& choice, std::string noun)
    : enabled_(choice == "auto" && isatty(STDERR_FILENO) != 0), noun_(std::move(noun)) {}

void ProgressLine::update(std::size_t done, std::size_t total) {
  if (!enabled_) return;
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  shown_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(done) / std::max(seconds, 1e-3);
  fmt::print(stderr, "\r\x1b[K{} of {} {}, {:.0f} per second, {:.0f} s left", done, total, noun_,
             rate, static_cast<double>(total - done) / std::max(rate, 1e-3));
  std::fflush(stderr);
}

void ProgressLine::clear() {
  const std::lock_guard lock(mutex_);
  if (shown_) fmt::print(stderr, "\r\x1b[K");
  shown_ = false;
}

}  // namespace edgecase
