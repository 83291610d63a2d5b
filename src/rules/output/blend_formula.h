// SPDX-License-Identifier: MIT
//
// The formula of blending (GL 4.6 core, tables 17.1 and 17.2), once for every kind of number:
// exact, an interval, or rounded at each step.
//
// A kind of number has +, - and a product whose neutral element is `one`; a range has its ends
// `low` and `high`, other kinds have an order.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "model/fragment_operations.h"

namespace edgecase {

// Red, green, blue and alpha of an operand, clamped to 0 to `one`.
template <class Number>
struct BlendOperands {
  std::array<Number, 4> source;
  std::array<Number, 4> destination;
  std::array<Number, 4> constant;
  Number one;
};

template <class Number>
concept IsRange = requires(Number value) {
  value.low;
  value.high;
};

template <class Number>
Number lesser(const Number& a, const Number& b) {
  if constexpr (IsRange<Number>)
    return {std::min(a.low, b.low), std::min(a.high, b.high)};
  else
    return std::min(a, b);
}

template <class Number>
Number greater(const Number& a, const Number& b) {
  if constexpr (IsRange<Number>)
    return {std::max(a.low, b.low), std::max(a.high, b.high)};
  else
    return std::max(a, b);
}

constexpr std::size_t kAlpha = 3;

template <class Number>
Number factor_of(BlendFactor factor, const BlendOperands<Number>& of, std::size_t component) {
  switch (factor) {
    case BlendFactor::zero:
      return of.one - of.one;
    case BlendFactor::one:
      return of.one;
    case BlendFactor::src_color:
      return of.source[component];
    case BlendFactor::one_minus_src_color:
      return of.one - of.source[component];
    case BlendFactor::dst_color:
      return of.destination[component];
    case BlendFactor::one_minus_dst_color:
      return of.one - of.destination[component];
    case BlendFactor::src_alpha:
      return of.source[kAlpha];
    case BlendFactor::one_minus_src_alpha:
      return of.one - of.source[kAlpha];
    case BlendFactor::dst_alpha:
      return of.destination[kAlpha];
    case BlendFactor::one_minus_dst_alpha:
      return of.one - of.destination[kAlpha];
    case BlendFactor::constant_color:
      return of.constant[component];
    case BlendFactor::one_minus_constant_color:
      return of.one - of.constant[component];
    case BlendFactor::constant_alpha:
      return of.constant[kAlpha];
    case BlendFactor::one_minus_constant_alpha:
      return of.one - of.constant[kAlpha];
    case BlendFactor::src_alpha_saturate:
      if (component == kAlpha) return of.one;
      return lesser<Number>(of.source[kAlpha], of.one - of.destination[kAlpha]);
  }
  return of.one;
}

// A component of the result, before clamping.
template <class Number>
Number blended(const BlendTerm& term, const BlendOperands<Number>& of, std::size_t component) {
  const auto source = [&]() -> Number {
    return of.source[component] * factor_of(term.source, of, component);
  };
  const auto destination = [&]() -> Number {
    return of.destination[component] * factor_of(term.destination, of, component);
  };
  switch (term.equation) {
    case BlendEquation::add:
      return source() + destination();
    case BlendEquation::subtract:
      return source() - destination();
    case BlendEquation::reverse_subtract:
      return destination() - source();
    case BlendEquation::min:
      return lesser<Number>(of.source[component], of.destination[component]) * of.one;
    case BlendEquation::max:
      return greater<Number>(of.source[component], of.destination[component]) * of.one;
  }
  return source();
}

}  // namespace edgecase
