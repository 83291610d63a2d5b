// SPDX-License-Identifier: MIT
//
// Elementary functions with the same results on every processor.
//
// For functions of doubles glibc has variants with and without fused multiplication and picks one
// when a program starts; their last bits sometimes differ. Functions of long doubles have one
// variant each. Results here are those, rounded to a double, and err by little more than half a
// unit in the last place.
//
// Square roots, scaling by powers of two and rounding are exact or correctly rounded everywhere, so
// they are not wrapped here.
#pragma once

#include <cmath>

namespace edgecase {

inline double cosine(double radians) {
  return static_cast<double>(std::cos(static_cast<long double>(radians)));
}

inline double sine(double radians) {
  return static_cast<double>(std::sin(static_cast<long double>(radians)));
}

// e^power.
inline double exponential(double power) {
  return static_cast<double>(std::exp(static_cast<long double>(power)));
}

inline double power_of_2(double power) {
  return static_cast<double>(std::exp2(static_cast<long double>(power)));
}

// The base-2 logarithm of a value >= 0; minus infinity for 0.
inline double binary_logarithm(double value) {
  return static_cast<double>(std::log2(static_cast<long double>(value)));
}

// base^power, for a base >= 0.
inline long double raised(long double base, long double power) {
  return std::pow(base, power);
}

inline double raised(double base, double power) {
  return static_cast<double>(
      raised(static_cast<long double>(base), static_cast<long double>(power)));
}

}  // namespace edgecase
