// SPDX-License-Identifier: MIT
//
// Elementary functions that answer the same on every processor.
//
// Of its functions of doubles glibc has variants with fused multiplication and without, and takes
// one when a program starts; their last bits differ now and then. Of those of long doubles there is
// one each. An answer is theirs, rounded to a double: off by little more than half a unit in the
// last place.
//
// Square roots, scaling by powers of two and rounding are exact or correctly rounded everywhere;
// they need nothing of this.
#pragma once

#include <cmath>

namespace edgecase {

inline double cosine(double radians) {
  return static_cast<double>(std::cos(static_cast<long double>(radians)));
}

inline double sine(double radians) {
  return static_cast<double>(std::sin(static_cast<long double>(radians)));
}

// e to the power.
inline double exponential(double power) {
  return static_cast<double>(std::exp(static_cast<long double>(power)));
}

inline double power_of_2(double power) {
  return static_cast<double>(std::exp2(static_cast<long double>(power)));
}

// Of 0 or more; of 0 it is minus infinity.
inline double binary_logarithm(double value) {
  return static_cast<double>(std::log2(static_cast<long double>(value)));
}

// Of 0 or more.
inline long double raised(long double base, long double power) {
  return std::pow(base, power);
}

inline double raised(double base, double power) {
  return static_cast<double>(
      raised(static_cast<long double>(base), static_cast<long double>(power)));
}

}  // namespace edgecase
