// SPDX-License-Identifier: MIT
//
// Blending (GL 4.6 core, 17.3.6) combines a fragment's colour with the stored one. The colour mask
// says which components of the result are written (17.4.2).
//
// The target holds 8-bit values. The source colour, the constant and the factors are therefore
// clamped to 0 to 1 first. The result is clamped in the same way.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "exact/interval.h"
#include "model/fragment_operations.h"
#include "rules/rule.h"
#include "rules/values/framebuffer.h"

namespace edgecase {

Rule blend_equation_rule();  // blend.equation
Rule blend_rounding_rule();  // blend.rounding
Rule color_mask_rule();      // color.mask
inline constexpr int kRulingOnBlendedCodes = 61;

enum class BlendMethod {
  as_set,
  ignored,          // the source replaces the destination
  color_for_alpha,  // alpha is blended by the colour's term
  swapped,          // source and destination factors are exchanged
  // The two forms of `over` are exchanged: colours by {src_alpha, one_minus_src_alpha} as by {one,
  // one_minus_src_alpha}, and the other way round.
  over_as_premultiplied,
  over_as_straight,
  // MIN and MAX compare products by the factors, which they must not know; or the source's product
  // by its own alpha.
  factors_in_min_and_max,
  source_alpha_in_min_and_max,
  differences_wrapped,  // a difference below 0 is 1 more, not 0
};
template <>
inline constexpr auto kNames<BlendMethod> = std::to_array<TabledAlternative<BlendMethod>>(
    {{BlendMethod::as_set, "as-set", Openness::mandated,
      "the draw's equations and factors; those of colour apply to red, green and blue"},
     {BlendMethod::ignored, "ignored", Openness::illegal, "the source replaces the destination"},
     {BlendMethod::color_for_alpha, "color-for-alpha", Openness::illegal,
      "alpha is blended by the equation and the factors of colour"},
     {BlendMethod::swapped, "swapped", Openness::illegal,
      "the factors of source and destination are exchanged"},
     {BlendMethod::over_as_premultiplied, "over-as-premultiplied", Openness::illegal,
      "over of a straight colour omits the product by its alpha, as if the colour were "
      "premultiplied"},
     {BlendMethod::over_as_straight, "over-as-straight", Openness::illegal,
      "over of a premultiplied colour multiplies it by its alpha once more"},
     {BlendMethod::factors_in_min_and_max, "factors-in-min-and-max", Openness::illegal,
      "min and max compare the products by the factors, which they must ignore"},
     {BlendMethod::source_alpha_in_min_and_max, "source-alpha-in-min-and-max", Openness::illegal,
      "min and max multiply the source's colour by its alpha first"},
     {BlendMethod::differences_wrapped, "differences-wrapped", Openness::illegal,
      "a difference below 0 wraps round to the other end of the range instead of being clamped"}});

// Where a result is rounded on its way to 8 bits. More are added as renderers are found to use
// them.
enum class BlendRounding {
  once,           // the exact result, to nearest, a tie to the even value
  source_first,   // source colour and constant too, before the equation
  every_product,  // these, and both products
  shifted,        // the same; a product p of two codes is (p + p/256 + 128)/256, in integers
};
template <>
inline constexpr auto kNames<BlendRounding> = std::to_array<TabledAlternative<BlendRounding>>(
    {{BlendRounding::once, "once", Openness::open,
      "the exact result is rounded to the nearest value, a tie to the even one"},
     {BlendRounding::source_first, "source-first", Openness::open,
      "source colour and constant are rounded to 8 bits first, then the result"},
     {BlendRounding::every_product, "every-product", Openness::open,
      "source colour, constant, factors and both products are rounded to 8 bits"},
     {BlendRounding::shifted, "shifted-products", Openness::open,
      "the same, but a product p of two codes becomes (p + p/256 + 128)/256 without remainders, in "
      "place of p/255; it is off by little more than half a code at most"}});

enum class ColorMaskMethod { as_set, ignored };
template <>
inline constexpr auto kNames<ColorMaskMethod> = std::to_array<TabledAlternative<ColorMaskMethod>>(
    {{ColorMaskMethod::as_set, "as-set", Openness::mandated,
      "components that the draw masks keep the stored value"},
     {ColorMaskMethod::ignored, "ignored", Openness::illegal, "all components are written"}});

struct BlendChoice {
  BlendMethod method = BlendMethod::as_set;
  BlendRounding rounding = BlendRounding::once;
  ColorMaskMethod mask = ColorMaskMethod::as_set;
};

// Red, green, blue, alpha as a target stores them.
using Rgba8 = std::array<std::uint8_t, 4>;
using Rgba8Range = std::array<Unorm8Range, 4>;

// True if no stored component stays as it is.
inline bool writes_all_components(const FragmentOperations& operations, ColorMaskMethod method) {
  return method == ColorMaskMethod::ignored ||
         std::ranges::all_of(operations.color_mask, [](bool written) { return written; });
}

// The stored colour after a fragment that has passed all tests. `source`: its colour, any number,
// NaN counts as 0. If it is blended, the double counts as the exact number; else it is stored as by
// to_unorm8.
Rgba8 written_color(const FragmentOperations& operations, const std::array<double, 4>& source,
                    const Rgba8& destination, const BlendChoice& choice);

// The permitted results, component by component: blending is computed with a precision that is no
// lower than that of the destination's components (17.3.6.1), so source, constant, factors,
// products and sum may each be rounded to either neighbouring multiple of 1/255.
Rgba8Range permitted_color(const FragmentOperations& operations,
                           const std::array<Interval, 4>& source, const Rgba8Range& destination,
                           ColorMaskMethod mask = ColorMaskMethod::as_set);

// The formula of blending (GL 4.6 core, tables 17.1 and 17.2), once for every kind of number:
// exact, an interval, or rounded at each step.
//
// A kind of number has +, - and a product whose neutral element is `one`; a range has its ends
// `low` and `high`, other kinds have an order.

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

// True if min and max compare products, as the alternatives do that apply factors there.
constexpr bool weighs_extremes(BlendMethod method) {
  return method == BlendMethod::factors_in_min_and_max ||
         method == BlendMethod::source_alpha_in_min_and_max;
}

// A difference; below 0 one more, if it is wrapped round.
template <class Number>
Number difference(const Number& a, const Number& b, const Number& one, BlendMethod method) {
  const Number result = a - b;
  if (method != BlendMethod::differences_wrapped) return result;
  if constexpr (IsRange<Number>) {
    if (result.low >= 0) return result;
    return result.high < 0 ? result + one : Number{0, one.high};
  } else {
    return result < one - one ? Number{result + one} : result;
  }
}

// A component of the result, before clamping.
template <class Number>
Number blended(const BlendTerm& term, const BlendOperands<Number>& of, std::size_t component,
               BlendMethod method = BlendMethod::as_set) {
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
      return difference<Number>(source(), destination(), of.one * of.one, method);
    case BlendEquation::reverse_subtract:
      return difference<Number>(destination(), source(), of.one * of.one, method);
    case BlendEquation::min:
      if (weighs_extremes(method)) return lesser<Number>(source(), destination());
      return lesser<Number>(of.source[component], of.destination[component]) * of.one;
    case BlendEquation::max:
      if (weighs_extremes(method)) return greater<Number>(source(), destination());
      return greater<Number>(of.source[component], of.destination[component]) * of.one;
  }
  return source();
}

}  // namespace edgecase
