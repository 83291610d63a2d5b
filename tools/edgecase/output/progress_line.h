// SPDX-License-Identifier: MIT
//
// Progress on a terminal: one line of standard error that is written over, with rate and time left.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>

namespace edgecase {

class ProgressLine {
 public:
  // `choice`: "auto" shows it where standard error is a terminal, "never" does not. `noun` is what
  // is counted: "cases".
  ProgressLine(const std::string& choice, std::string noun);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // May be called from any thread.
  void update(std::size_t done, std::size_t total);
  // The same where no total is known; `more` is what stands behind number and rate.
  void update(std::size_t done, const std::string& more);
  // Takes the line away.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  // Is the line to be written? Seconds since the start, then.
  std::optional<double> due();
  bool enabled_;
  std::string noun_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
  std::mutex mutex_;
};

}  // namespace edgecase
