// SPDX-License-Identifier: MIT
//
// The order in which the threads of a run take its cases.
#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "suite/case_store.h"

namespace edgecase {

// Cases that one renderer is to draw.
struct Share {
  std::size_t renderer = 0;
  CaseSlice cases;
  bool is_large = false;  // one case, which takes a hundred times the memory of a small one
};

// All renderers draw a slice, one after the other, before the next one: then few exact renderings
// wait for the last renderer.
std::vector<Share> shares_of(const CaseStore& cases, std::size_t renderers);

// Hands out shares to threads: to one thread in order; to several the large ones first, a few at a
// time while there are others, which takes least memory and leaves no large one to the end. Each
// thread has a stretch of the others, since neighbours repeat the programs and states that its
// renderers have made already; when it is done, it takes from the end of the longest stretch that
// is left. Safe to use from several threads.
class ShareQueue {
 public:
  ShareQueue(std::vector<Share> shares, std::size_t jobs);

  std::size_t size() const { return shares_.size(); }
  // `thread`: from 0, below `jobs`. Nothing if no share is left.
  std::optional<Share> take(std::size_t thread);
  // A share that was taken is done.
  void finish(const Share& share);
  // Nothing is handed out any more.
  void close();

 private:
  struct Stretch {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t left() const { return end - begin; }
  };

  const Share& take_large();

  std::mutex mutex_;
  std::vector<Share> shares_;
  const std::size_t most_large_;  // at a time, while others are left
  std::size_t large_ = 0;         // that are being done
  std::size_t next_large_ = 0;
  std::size_t large_end_ = 0;
  std::vector<Stretch> stretches_;  // of the others, by thread
};

}  // namespace edgecase
