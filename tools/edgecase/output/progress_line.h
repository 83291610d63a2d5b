// SPDX-License-Identifier: MIT
//
// Progress on a terminal: one line of standard error that is overwritten, with rate and time left.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>

namespace edgecase {

class ProgressLine {
 public:
  // `choice`: "auto" shows progress if standard error is a terminal, "never" does not. `noun`: the
  // counted things, "cases".
  ProgressLine(const std::string& choice, std::string noun);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // May be called from any thread.
  void update(std::size_t done, std::size_t total);
  // The same without a total; `more`: the text behind number and rate.
  void update(std::size_t done, const std::string& more);
  // Removes the line.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  // The seconds since the start if the line is due; otherwise nothing.
  std::optional<double> due();
  bool enabled_;
  std::string noun_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
  std::mutex mutex_;
};

}  // namespace edgecase
