// SPDX-License-Identifier: MIT
#include "run/share_queue.h"

#include <malloc.h>

#include <algorithm>
#include <utility>

namespace edgecase {
namespace {

// The weight of twenty cases of 100x100. Threads end within one slice of each other, and the wait
// at the end of a slice is a small part of it.
constexpr SliceLimits kSlice{std::size_t{1} << 18, 20};

// A case of this weight takes a hundred times the memory of a small one.
constexpr std::size_t kLarge = std::size_t{1} << 17;

bool is_large(const CaseStore& cases, const CaseSlice& slice) {
  return slice.end - slice.begin == 1 && cases.weight(slice.begin) >= kLarge;
}

}  // namespace

std::vector<Share> shares_of(const CaseStore& cases, std::size_t renderers) {
  std::vector<Share> shares;
  for (const CaseSlice& slice : cut_cases(cases, kSlice))
    for (std::size_t r = 0; r < renderers; ++r)
      shares.push_back({r, slice, is_large(cases, slice)});
  return shares;
}

ShareQueue::ShareQueue(std::vector<Share> shares, std::size_t jobs)
    : shares_(std::move(shares)), most_large_(std::max<std::size_t>(1, jobs / 2)) {
  if (jobs > 1)
    large_end_ = static_cast<std::size_t>(
        std::stable_partition(shares_.begin(), shares_.end(),
                              [](const Share& share) { return share.is_large; }) -
        shares_.begin());
  const std::size_t others = shares_.size() - large_end_;
  for (std::size_t i = 0; i < jobs; ++i)
    stretches_.push_back({large_end_ + i * others / jobs, large_end_ + (i + 1) * others / jobs});
}

std::optional<Share> ShareQueue::take(std::size_t thread) {
  const std::lock_guard lock(mutex_);
  if (large_ < most_large_ && next_large_ < large_end_) return take_large();
  Stretch& own = stretches_[thread];
  if (own.left() > 0) return shares_[own.begin++];
  Stretch& longest = *std::ranges::max_element(stretches_, {}, &Stretch::left);
  if (longest.left() > 0) return shares_[--longest.end];
  if (next_large_ < large_end_) return take_large();
  return std::nullopt;
}

void ShareQueue::finish(const Share& share) {
  const std::lock_guard lock(mutex_);
  if (!share.is_large) return;
  if (large_end_ > 0) --large_;
  malloc_trim(0);  // its memory goes back to the system
}

void ShareQueue::close() {
  const std::lock_guard lock(mutex_);
  stretches_.assign(stretches_.size(), {});
  next_large_ = large_end_;
}

const Share& ShareQueue::take_large() {
  ++large_;
  return shares_[next_large_++];
}

}  // namespace edgecase
