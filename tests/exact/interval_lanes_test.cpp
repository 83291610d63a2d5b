// SPDX-License-Identifier: MIT
//
// Lanes are what the operators of exact/interval.h make of one interval at a time: to the bit, by
// every set of vector instructions that this machine has.
#include "exact/interval_lanes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <random>
#include <string>

#include "kernels/kernels.h"

namespace edgecase {
namespace {

constexpr std::size_t kLanes = 16;

// Numbers of a fixed sequence.
class Numbers {
 public:
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 engine_{5};
};

// Ordinary numbers, and those that an instruction may treat otherwise.
double drawn_number(Numbers& numbers) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kSpecial[] = {0.0,     -0.0,  1.0,    -1.0,     kInfinity, -kInfinity,   5e-324,
                                 -5e-324, 1e308, -1e308, 2.2e-308, 0x1p-1070, 1.0 + 0x1p-52};
  if (numbers.integer(0, 2) == 0) return kSpecial[numbers.integer(0, std::ssize(kSpecial) - 1)];
  return std::ldexp(static_cast<double>(numbers.integer(-1 << 30, 1 << 30)),
                    static_cast<int>(numbers.integer(-60, 30)));
}

Interval drawn(Numbers& numbers) {
  const double a = drawn_number(numbers);
  const double b = numbers.integer(0, 3) == 0 ? a : drawn_number(numbers);
  return a < b ? Interval(a, b) : Interval(b, a);
}

Interval of_one(LaneOperation operation, Interval a, Interval b) {
  switch (operation) {
    case LaneOperation::add:
      return a + b;
    case LaneOperation::subtract:
      return a - b;
    case LaneOperation::multiply:
      return a * b;
    case LaneOperation::divide:
      return a / b;
  }
  return {};
}

bool is_same(Interval a, Interval b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return bits(a.low) == bits(b.low) && bits(a.high) == bits(b.high);
}

TEST(IntervalLanes, EachLaneIsWhatOneIntervalWouldBe) {
  int compared = 0;
  for (const std::string& target : kernel_names()) {
    ASSERT_TRUE(use_kernels(target));
    Numbers numbers;
    for (int round = 0; round < 2000; ++round) {
      IntervalLanes<kLanes> a, b;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        a.set(lane, drawn(numbers));
        b.set(lane, drawn(numbers));
      }
      for (const auto operation : {LaneOperation::add, LaneOperation::subtract,
                                   LaneOperation::multiply, LaneOperation::divide})
        for (const double relative : {kNotWidened, 0.0, 1e-5}) {
          const auto expected = [&](Interval x, Interval y) {
            const Interval plain = of_one(operation, x, y);
            return relative < 0 ? plain : widened(plain, relative);
          };
          const IntervalLanes<kLanes> both = by_lane(operation, a, b, relative);
          const IntervalLanes<kLanes> one = by_lane(operation, a, b[3], relative);
          for (std::size_t lane = 0; lane < kLanes; ++lane) {
            ASSERT_TRUE(is_same(both[lane], expected(a[lane], b[lane])))
                << target << ' ' << static_cast<int>(operation) << ": " << a[lane].low << " to "
                << a[lane].high << " with " << b[lane].low << " to " << b[lane].high;
            ASSERT_TRUE(is_same(one[lane], expected(a[lane], b[3]))) << target;
            ++compared;
          }
        }
    }
  }
  use_kernels(kernel_names().front());
  EXPECT_GT(compared, 2 * 2000 * 12 * 16);
}

TEST(IntervalLanes, TheHullHoldsAllLanes) {
  IntervalLanes<32> lanes;
  for (std::size_t i = 0; i < 32; ++i) lanes.set(i, {static_cast<double>(i % 7), 9.0 + (i == 20)});
  lanes.set(31, {-2, 3});
  EXPECT_TRUE(is_same(hull_of(lanes), {-2, 10}));
}

}  // namespace
}  // namespace edgecase
