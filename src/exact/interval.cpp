// SPDX-License-Identifier: MIT
#include "exact/interval.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// One unit in the last place outwards covers the half unit by which the hardware may have rounded.
Interval outward(double low, double high) {
  if (std::isnan(low) || std::isnan(high)) return Interval::everything();
  return {std::nextafter(low, -kInfinity), std::nextafter(high, kInfinity)};
}

}  // namespace

Interval Interval::everything() {
  return {-kInfinity, kInfinity};
}

double Interval::magnitude() const {
  return std::max(std::fabs(low), std::fabs(high));
}

Interval operator+(Interval a, Interval b) {
  return outward(a.low + b.low, a.high + b.high);
}

Interval operator-(Interval a, Interval b) {
  return outward(a.low - b.high, a.high - b.low);
}

Interval operator*(Interval a, Interval b) {
  const double products[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  for (double product : products)
    if (std::isnan(product)) return Interval::everything();
  const auto [low, high] = std::minmax_element(std::begin(products), std::end(products));
  return outward(*low, *high);
}

Interval operator/(Interval a, Interval b) {
  if (b.contains(0)) return Interval::everything();
  const double quotients[] = {a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high};
  for (double quotient : quotients)
    if (std::isnan(quotient)) return Interval::everything();
  const auto [low, high] = std::minmax_element(std::begin(quotients), std::end(quotients));
  return outward(*low, *high);
}

Interval hull(Interval a, Interval b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

Interval widened(Interval value, double relative) {
  // Rounded up: where an end cancels against the margin, the margin's own error is what is left.
  const double margin = std::nextafter(value.magnitude() * relative, kInfinity);
  return outward(value.low - margin, value.high + margin);
}

}  // namespace edgecase
