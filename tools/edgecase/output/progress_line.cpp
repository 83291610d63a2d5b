// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace edgecase {
namespace {

// Errors are ignored, since the terminal may be gone.
void show(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

ProgressLine::ProgressLine(const std::string& choice, std::string noun)
    : enabled_(choice == "auto" && isatty(STDERR_FILENO) != 0), noun_(std::move(noun)) {}

std::optional<double> ProgressLine::due() {
  const auto now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return std::nullopt;
  last_ = now;
  shown_ = true;
  return std::max(std::chrono::duration<double>(now - start_).count(), 1e-3);
}

void ProgressLine::update(std::size_t done, std::size_t total) {
  if (!enabled_) return;
  const std::lock_guard lock(mutex_);
  const auto seconds = due();
  if (!seconds) return;
  const double rate = static_cast<double>(done) / *seconds;
  show(fmt::format("\r\x1b[K{} of {} {}, {:.0f} per second, {:.0f} s left", done, total, noun_,
                   rate, static_cast<double>(total - done) / std::max(rate, 1e-3)));
}

void ProgressLine::update(std::size_t done, const std::string& more) {
  if (!enabled_) return;
  const std::lock_guard lock(mutex_);
  const auto seconds = due();
  if (!seconds) return;
  show(fmt::format("\r\x1b[K{} {}, {:.0f} per second{}", done, noun_,
                   static_cast<double>(done) / *seconds, more));
}

void ProgressLine::clear() {
  const std::lock_guard lock(mutex_);
  if (shown_) show("\r\x1b[K");
  shown_ = false;
}

}  // namespace edgecase
