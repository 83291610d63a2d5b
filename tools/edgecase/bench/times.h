// SPDX-License-Identifier: MIT
//
// Times of several rounds, and ratios of them. Rounds are interleaved: within one, everything that
// is held against each other is timed in turn, so that a machine that slows down slows all of it.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

namespace edgecase {

struct Spread {
  double median = 0;
  double low = 0;  // of all rounds
  double high = 0;
};

// Of numbers in any order; zeros of none.
Spread spread_of(std::vector<double> numbers);

// Quotients round by round: how much faster the second is, where the numbers are times.
Spread ratio_of(const std::vector<double>& numerators, const std::vector<double>& denominators);

// What one call takes on average, in seconds: called until `seconds` have passed, once at least.
template <class Call>
double time_of(double seconds, Call call) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  std::size_t calls = 0;
  double passed = 0;
  do {
    call();
    ++calls;
    passed = std::chrono::duration<double>(Clock::now() - start).count();
  } while (passed < seconds);
  return passed / static_cast<double>(calls);
}

}  // namespace edgecase
