// SPDX-License-Identifier: MIT
//
// Patience: how long comparing one answer may take.
//
// Comparing is quick, but an answer comes from another program and may be anything. So the long
// loops of a comparison ask whether to go on: a run that is told to end does not wait for it, and
// one that takes too long is given up. It belongs to the thread that compares, so that loops need
// not be handed it.
#pragma once

#include <atomic>
#include <chrono>

namespace edgecase {

// Thrown by Patience::check.
struct ComparisonStopped {};  // the run should end
struct ComparisonTooLong {};

// While an object lives, comparisons on its thread have this patience; without one, they have no
// limit.
class Patience {
 public:
  // `stop`: true when the run should end; null: never. It must outlive the object.
  Patience(const std::atomic<bool>* stop, std::chrono::milliseconds most);
  ~Patience();
  Patience(const Patience&) = delete;
  Patience& operator=(const Patience&) = delete;

  // To be called at least every few milliseconds; takes nanoseconds.
  static void check();

 private:
  void look();

  const std::atomic<bool>* const stop_;
  const std::chrono::steady_clock::time_point end_;
  unsigned looks_ = 0;
  Patience* const outer_;
};

}  // namespace edgecase
