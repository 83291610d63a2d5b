// SPDX-License-Identifier: MIT
#include "rules/textures/log2_method.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/elementary.h"
#include "rules/textures/directed.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// (1 + fraction) * 2^exponent, for finite numbers above 0; the fraction is 0 to 1 and a double.
struct Parts {
  int exponent;
  double fraction;
};

Parts parts_of(double value) {
  const int exponent = std::ilogb(value);
  return {exponent, std::scalbn(value, -exponent) - 1};
}

// The logarithm stays between the whole numbers on either side, whatever the error.
Interval exact_log2(double value) {
  const Parts parts = parts_of(value);
  if (parts.fraction == 0) return parts.exponent;
  const Interval bounds = around(binary_logarithm(value), kPlacesOfLibrary);
  return {std::max<double>(bounds.low, parts.exponent),
          std::min<double>(bounds.high, parts.exponent + 1)};
}

Interval linear_mantissa(double value) {
  const Parts parts = parts_of(value);
  return exact_sum(parts.exponent, parts.fraction);
}

// For 0 or more; numbers too small to be distinguished from 0 may have a square below it.
Interval square(Interval value) {
  return {Down::product(value.low, value.low), Up::product(value.high, value.high)};
}

// The sum with 1/2 is exact: a multiple of 2^-44 below 257.
Interval mantissa_8(double value) {
  const Parts parts = parts_of(value);
  const double steps = std::floor(parts.fraction * 256 + 0.5);
  return exact_sum(parts.exponent, exact_log2(1 + steps / 256));
}

Interval log2_of_point(double value, Log2Method method) {
  if (value <= 0) return -kInfinity;
  if (std::isinf(value)) return kInfinity;
  switch (method) {
    case Log2Method::exact:
      break;
    case Log2Method::linear_mantissa:
      return linear_mantissa(value);
    case Log2Method::linear_mantissa_of_square:
      return exact_product(log2_of(square(value), Log2Method::linear_mantissa), 0.5);
    case Log2Method::linear_mantissa_of_fourth_power:
      return exact_product(log2_of(square(square(value)), Log2Method::linear_mantissa), 0.25);
    case Log2Method::mantissa_8:
      return mantissa_8(value);
  }
  return exact_log2(value);
}

}  // namespace

Interval log2_of(Interval value, Log2Method method) {
  value = known(value);
  return {log2_of_point(value.low, method).low, log2_of_point(value.high, method).high};
}

Rule log2_rule() {
  Rule rule;
  rule.id = RuleId::texture_log2;
  rule.title = "The level of detail is the base-2 logarithm of the scale factor";
  rule.spec = "8.14.1, level of detail";
  rule.latitude = "the precision, which is not stated: 2^-6 of a level (rulings 20 and 50)";
  rule.standard = "exact";
  rule.alternatives = alternatives_of<Log2Method>();
  rule.rulings = {
      {20,
       "Logarithm: OpenGL states no precision for that of the scale factor. Permitted is a level "
       "of "
       "detail within 2^-6 of what the logarithm yields of any scale factor that ruling 19 "
       "permits, "
       "as the Khronos tests ask; what is beyond is a violation, or contested by ruling 50, "
       "whatever approximation leads there. The logarithm of 0 is reported as any number of -16 or "
       "less, which no bias leads out of magnification."},
      {50,
       "Coarse samplers: a level of detail that is off by 2^-6 to 2^-4, and a coordinate that is "
       "off by 2^-7 to 2^-4 texel, are contested: OpenGL states no precision, and the Khronos "
       "tests, which ask for 6 bits and 7, let 4 and 4 pass with a warning about quality."}};
  return rule;
}

}  // namespace edgecase
