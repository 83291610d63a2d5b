// SPDX-License-Identifier: MIT
//
// Times of several rounds, and ratios of them. Rounds are interleaved: each times everything that
// is compared, in turn, so that a machine that slows down affects all of it.
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

// The spread of numbers in any order; zeros if there are none.
Spread spread_of(std::vector<double> numbers);

// Quotients round by round: for times, how much faster the second is.
Spread ratio_of(const std::vector<double>& numerators, const std::vector<double>& denominators);

// The average duration of a call in seconds. Calls until `seconds` have passed, at least once.
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
