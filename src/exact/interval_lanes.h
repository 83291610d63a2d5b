// SPDX-License-Identifier: MIT
//
// Many intervals at once: each lane is what the operators of exact/interval.h make of one interval,
// to the bit. Vector instructions compute several lanes together.
#pragma once

#include <array>
#include <cstddef>

#include "exact/interval.h"

namespace edgecase {

// `N`: the number of lanes, a multiple of 16. Lanes are 0 at first.
template <std::size_t N>
struct IntervalLanes {
  static_assert(N % 16 == 0);
  std::array<double, N> low{};
  std::array<double, N> high{};

  Interval operator[](std::size_t lane) const { return {low[lane], high[lane]}; }
  void set(std::size_t lane, Interval value) {
    low[lane] = value.low;
    high[lane] = value.high;
  }
};

enum class LaneOperation { add, subtract, multiply, divide };

// The first operand's ends, the second's, and where the results' ends go: `count` of each, a
// multiple of 16; if `b_is_one`, only one of the second's.
struct LaneOperands {
  const double* a_low;
  const double* a_high;
  const double* b_low;
  const double* b_high;
  bool b_is_one;
  double relative;
  double* low;
  double* high;
  std::size_t count;
};
void compute_lanes(LaneOperation operation, const LaneOperands& of);

inline constexpr double kNotWidened = -1;

// Each lane is what the operator gives and then, unless `relative` is below 0, widened() by it.
template <std::size_t N>
IntervalLanes<N> by_lane(LaneOperation operation, const IntervalLanes<N>& a,
                         const IntervalLanes<N>& b, double relative) {
  IntervalLanes<N> result;
  compute_lanes(operation, {a.low.data(), a.high.data(), b.low.data(), b.high.data(), false,
                            relative, result.low.data(), result.high.data(), N});
  return result;
}
// With the same second operand for every lane.
template <std::size_t N>
IntervalLanes<N> by_lane(LaneOperation operation, const IntervalLanes<N>& a, const Interval& b,
                         double relative) {
  IntervalLanes<N> result;
  compute_lanes(operation, {a.low.data(), a.high.data(), &b.low, &b.high, true, relative,
                            result.low.data(), result.high.data(), N});
  return result;
}

template <std::size_t N>
IntervalLanes<N> operator+(const IntervalLanes<N>& a, const IntervalLanes<N>& b) {
  return by_lane(LaneOperation::add, a, b, kNotWidened);
}
template <std::size_t N>
IntervalLanes<N> operator*(const IntervalLanes<N>& a, const Interval& b) {
  return by_lane(LaneOperation::multiply, a, b, kNotWidened);
}
template <std::size_t N>
IntervalLanes<N> operator/(const IntervalLanes<N>& a, const IntervalLanes<N>& b) {
  return by_lane(LaneOperation::divide, a, b, kNotWidened);
}
template <std::size_t N>
IntervalLanes<N> operator/(const IntervalLanes<N>& a, const Interval& b) {
  return by_lane(LaneOperation::divide, a, b, kNotWidened);
}

// The smallest interval that holds all lanes.
template <std::size_t N>
Interval hull_of(const IntervalLanes<N>& lanes) {
  Interval result = lanes[0];
  for (std::size_t lane = 1; lane < N; ++lane) result = hull(result, lanes[lane]);
  return result;
}

}  // namespace edgecase
