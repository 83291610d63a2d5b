// SPDX-License-Identifier: MIT
#include "diff/findings/patience.h"

namespace edgecase {
namespace {

thread_local Patience* current = nullptr;

}  // namespace

Patience::Patience(const std::atomic<bool>* stop, std::chrono::milliseconds most)
    : stop_(stop), end_(std::chrono::steady_clock::now() + most), outer_(current) {
  current = this;
}

Patience::~Patience() {
  current = outer_;
}

void Patience::check() {
  if (current != nullptr) current->look();
}

void Patience::look() {
  constexpr unsigned kLooksPerTime = 64;  // at the clock
  if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) throw ComparisonStopped{};
  if (looks_++ % kLooksPerTime == 0 && std::chrono::steady_clock::now() > end_)
    throw ComparisonTooLong{};
}

}  // namespace edgecase
