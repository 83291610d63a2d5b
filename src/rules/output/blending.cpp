// SPDX-License-Identifier: MIT
#include "rules/output/blending.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <type_traits>
#include <utility>

#include "exact/interval.h"
#include "exact/rational.h"
#include "model/rendering.h"

namespace edgecase {
namespace {

double unit_clamped(double value) {
  return std::clamp(value, 0.0, 1.0);
}

// `number` converts a double, `code` an 8-bit value.
template <class Number, class FromDouble, class FromCode>
BlendOperands<Number> operands_of(const std::array<double, 4>& source,
                                  const std::array<std::uint8_t, 4>& destination,
                                  const std::array<float, 4>& constant, FromDouble number,
                                  FromCode code) {
  BlendOperands<Number> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.source[i] = number(unit_clamped(source[i]));
    result.destination[i] = code(destination[i]);
    result.constant[i] = number(unit_clamped(static_cast<double>(constant[i])));
  }
  result.one = 1;
  return result;
}

// For a number close to a border between two codes, so that no clamping is needed.
std::uint8_t nearest_code(const Rational& value) {
  const Rational scaled = value * 255;
  const Integer below = floor_of(scaled);
  const Rational rest = scaled - below;
  const Rational half(1, 2);
  const bool is_odd = (below & 1) != 0;
  const bool is_up = rest > half || (rest == half && is_odd);
  return static_cast<std::uint8_t>(static_cast<int>(below) + (is_up ? 1 : 0));
}

// Components' nearest values, a tie to the even one. Source and constant: finite; they are clamped
// to 0 to 1. Most results lie well between the borders at which values round one way or the other,
// so an interval decides; the others are computed again as quotients of integers.
class ExactlyBlended {
 public:
  // Refers to all of them.
  ExactlyBlended(const std::array<double, 4>& source, const Rgba8& destination,
                 const std::array<float, 4>& constant)
      : source_(source),
        destination_(destination),
        constant_(constant),
        narrow_(operands_of<Interval>(
            source, destination, constant, [](double value) { return Interval(value); },
            [](int code) { return Interval(code) / 255; })) {}

  std::uint8_t code(const BlendTerm& term, std::size_t component, BlendMethod method) const {
    const Interval result = blended(term, narrow_, component, method) * 255;
    const double low = std::nearbyint(std::clamp(result.low, 0.0, 255.0));
    const double high = std::nearbyint(std::clamp(result.high, 0.0, 255.0));
    if (low == high) return static_cast<std::uint8_t>(low);
    return nearest_code(blended(
        term,
        operands_of<Rational>(
            source_, destination_, constant_, [](double value) { return rational_of(value); },
            [](int code) { return Rational(code, 255); }),
        component, method));
  }

 private:
  const std::array<double, 4>& source_;
  const Rgba8& destination_;
  const std::array<float, 4>& constant_;
  const BlendOperands<Interval> narrow_;
};

constexpr int kLargest = 255;

// A result in 1/255^2, rounded to the nearest code; there are no ties, since 255 is odd.
int code_of_square(int value) {
  return (2 * std::clamp(value, 0, kLargest * kLargest) + kLargest) / (2 * kLargest);
}

// A multiple of 1/255 with products rounded to the nearest one.
struct RoundedCode {
  int value = 0;
  friend auto operator<=>(RoundedCode, RoundedCode) = default;
  friend RoundedCode operator+(RoundedCode a, RoundedCode b) { return {a.value + b.value}; }
  friend RoundedCode operator-(RoundedCode a, RoundedCode b) { return {a.value - b.value}; }
  friend RoundedCode operator*(RoundedCode a, RoundedCode b) {
    return {code_of_square(a.value * b.value)};
  }
};

// The same with products divided by shifting.
struct ShiftedCode {
  int value = 0;
  friend auto operator<=>(ShiftedCode, ShiftedCode) = default;
  friend ShiftedCode operator+(ShiftedCode a, ShiftedCode b) { return {a.value + b.value}; }
  friend ShiftedCode operator-(ShiftedCode a, ShiftedCode b) { return {a.value - b.value}; }
  friend ShiftedCode operator*(ShiftedCode a, ShiftedCode b) {
    const int product = a.value * b.value;
    return {(product + (product >> 8) + 128) >> 8};
  }
};

// A range of multiples of 1/255 in which everything is rounded outwards; factors of a product must
// not be negative.
struct CodeRange {
  int low = 0;
  int high = 0;
  friend CodeRange operator+(CodeRange a, CodeRange b) { return {a.low + b.low, a.high + b.high}; }
  friend CodeRange operator-(CodeRange a, CodeRange b) { return {a.low - b.high, a.high - b.low}; }
  friend CodeRange operator*(CodeRange a, CodeRange b) {
    return {a.low * b.low / kLargest, (a.high * b.high + kLargest - 1) / kLargest};
  }
};

// The whole number at or below 255 times a number, without the product's rounding error.
int code_below(double value) {
  const double scaled = std::clamp(value, 0.0, 1.0) * kLargest;
  const double below = std::floor(scaled);
  const bool is_rounded_up =
      below == scaled && std::fma(std::clamp(value, 0.0, 1.0), double{kLargest}, -scaled) < 0;
  return static_cast<int>(below) - (is_rounded_up ? 1 : 0);
}

int code_above(double value) {
  const double scaled = std::clamp(value, 0.0, 1.0) * kLargest;
  const double above = std::ceil(scaled);
  const bool is_rounded_down =
      above == scaled && std::fma(std::clamp(value, 0.0, 1.0), double{kLargest}, -scaled) > 0;
  return static_cast<int>(above) + (is_rounded_down ? 1 : 0);
}

CodeRange codes_around(Interval value) {
  return {code_below(value.low), code_above(value.high)};
}

// The code nearest to an operand, a tie to the even one.
int nearest_operand(double value) {
  const double clamped = unit_clamped(value);
  const double scaled = clamped * kLargest;
  const double nearest = std::nearbyint(scaled);
  // The product is off by far less than this.
  constexpr double kNearHalf = 0.499999;
  if (std::fabs(scaled - nearest) < kNearHalf) return static_cast<int>(nearest);
  // Both are exact: how far the product is above the half, and how far the number is above that.
  const double below = std::floor(scaled);
  const double above_half = scaled - below - 0.5;
  const double error = std::fma(clamped, kLargest, -scaled);
  const bool is_odd = std::fmod(below, 2) != 0;
  const bool is_up = above_half > -error || (above_half == -error && is_odd);
  return static_cast<int>(below) + (is_up ? 1 : 0);
}

// Exchanges the colour factor of `over` for that of its other form.
void exchange_form(BlendTerm& term, BlendFactor from, BlendFactor to) {
  if (term.equation == BlendEquation::add && term.source == from &&
      term.destination == BlendFactor::one_minus_src_alpha)
    term.source = to;
}

// MIN or MAX with the source's colour by its alpha.
void weigh_by_source_alpha(BlendTerm& term, BlendFactor source) {
  if (term.equation != BlendEquation::min && term.equation != BlendEquation::max) return;
  term.source = source;
  term.destination = BlendFactor::one;
}

// A draw's terms as changed by a method; `ignored`, which blends nothing, leaves them.
Blending blending_by(Blending blending, BlendMethod method) {
  switch (method) {
    case BlendMethod::as_set:
    case BlendMethod::ignored:
    case BlendMethod::factors_in_min_and_max:
    case BlendMethod::differences_wrapped:
      break;
    case BlendMethod::source_alpha_in_min_and_max:
      weigh_by_source_alpha(blending.color, BlendFactor::src_alpha);
      weigh_by_source_alpha(blending.alpha, BlendFactor::one);
      break;
    case BlendMethod::color_for_alpha:
      blending.alpha = blending.color;
      break;
    case BlendMethod::swapped:
      std::swap(blending.color.source, blending.color.destination);
      std::swap(blending.alpha.source, blending.alpha.destination);
      break;
    case BlendMethod::over_as_premultiplied:
      exchange_form(blending.color, BlendFactor::src_alpha, BlendFactor::one);
      break;
    case BlendMethod::over_as_straight:
      exchange_form(blending.color, BlendFactor::one, BlendFactor::src_alpha);
      break;
  }
  return blending;
}

BlendTerm term_of(const Blending& blending, std::size_t component, BlendMethod method) {
  const Blending meant = blending_by(blending, method);
  return component == kAlpha ? meant.alpha : meant.color;
}

// All operands are first rounded to the nearest code.
template <class Number>
BlendOperands<Number> rounded_operands(const std::array<double, 4>& source,
                                       const Rgba8& destination,
                                       const std::array<float, 4>& constant) {
  BlendOperands<Number> result{{}, {}, {}, Number{kLargest}};
  for (std::size_t i = 0; i < 4; ++i) {
    result.source[i] = Number{nearest_operand(source[i])};
    result.destination[i] = Number{destination[i]};
    result.constant[i] = Number{nearest_operand(static_cast<double>(constant[i]))};
  }
  return result;
}

template <class Number>
std::uint8_t clamped_code(Number result) {
  return static_cast<std::uint8_t>(std::clamp(result.value, 0, kLargest));
}

Rgba8 blended_codes(const Blending& blending, const std::array<double, 4>& source,
                    const Rgba8& destination, const BlendChoice& choice) {
  // Operands are made once for all components.
  const auto each = [&](const auto& code) {
    Rgba8 codes{};
    for (std::size_t i = 0; i < codes.size(); ++i)
      codes[i] = code(term_of(blending, i, choice.method), i);
    return codes;
  };
  const auto by_codes = [&]<class Number>(Number) {
    const auto operands = rounded_operands<Number>(source, destination, blending.constant);
    return each([&](const BlendTerm& term, std::size_t i) {
      if constexpr (std::is_same_v<Number, int>)
        return static_cast<std::uint8_t>(code_of_square(blended(term, operands, i, choice.method)));
      else
        return clamped_code(blended(term, operands, i, choice.method));
    });
  };
  switch (choice.rounding) {
    case BlendRounding::once: {
      const ExactlyBlended exactly(source, destination, blending.constant);
      return each([&](const BlendTerm& term, std::size_t i) {
        return exactly.code(term, i, choice.method);
      });
    }
    case BlendRounding::source_first:
      return by_codes(int{});
    case BlendRounding::every_product:
      return by_codes(RoundedCode{});
    case BlendRounding::shifted:
      return by_codes(ShiftedCode{});
  }
  return destination;
}

}  // namespace

Rgba8 written_color(const FragmentOperations& operations, const std::array<double, 4>& source,
                    const Rgba8& destination, const BlendChoice& choice) {
  std::array<double, 4> numbers;
  for (std::size_t i = 0; i < 4; ++i) numbers[i] = std::isnan(source[i]) ? 0 : source[i];
  const bool blends = operations.blending && choice.method != BlendMethod::ignored;
  Rgba8 result{};
  if (blends)
    result = blended_codes(*operations.blending, numbers, destination, choice);
  else
    std::ranges::transform(numbers, result.begin(), to_unorm8);
  if (choice.mask == ColorMaskMethod::as_set)
    for (std::size_t i = 0; i < 4; ++i)
      if (!operations.color_mask[i]) result[i] = destination[i];
  return result;
}

Rgba8Range permitted_color(const FragmentOperations& operations,
                           const std::array<Interval, 4>& source, const Rgba8Range& destination,
                           ColorMaskMethod mask) {
  BlendOperands<CodeRange> operands{{}, {}, {}, {kLargest, kLargest}};
  for (std::size_t i = 0; i < 4; ++i) {
    operands.source[i] = codes_around(source[i]);
    operands.destination[i] = {destination[i].low, destination[i].high};
    if (operations.blending)
      operands.constant[i] = codes_around(static_cast<double>(operations.blending->constant[i]));
  }
  Rgba8Range result = destination;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!operations.color_mask[i] && mask == ColorMaskMethod::as_set) continue;
    if (!operations.blending) {
      result[i] = unorm8_permitted(source[i]);
      continue;
    }
    const BlendTerm term = term_of(*operations.blending, i, BlendMethod::as_set);
    const CodeRange range = blended(term, operands, i);
    result[i] = {std::clamp(range.low, 0, kLargest), std::clamp(range.high, 0, kLargest)};
  }
  return result;
}

Rule blend_equation_rule() {
  return {RuleId::blend_equation,
          "A fragment's colour is blended with the stored one by the draw's equation and factors",
          "17.3.6 (blending), tables 17.1 and 17.2",
          "none but rounding (blend.rounding)",
          "as-set",
          alternatives_of<BlendMethod>(),
          {}};
}

Rule blend_rounding_rule() {
  return {RuleId::blend_rounding,
          "A blended colour is stored as the value nearest to the equation's result",
          "17.3.6.1 (blend equation), with 2.3.5.2 (conversion to normalized fixed-point)",
          "the precision of 8 bits for each intermediate number (ruling 37)",
          "once",
          alternatives_of<BlendRounding>(),
          {{37,
            "Blending on an 8-bit target: the operands are the fragment's colour as the renderer "
            "reports it and the colour that it has stored before, clamped to 0 to 1. It is "
            "computed with a precision no lower than that of the destination's components "
            "(17.3.6.1), which we read so: source, constant, both factors, both products and "
            "their sum may each, or may not, be rounded to either neighbouring multiple of "
            "1/255, and the result, clamped to 0 to 1, is stored as either neighbour. The "
            "products by 0 and by 1 and the stored colour's own value have no error. Components "
            "that are masked keep what is stored, to the bit."},
           {kRulingOnBlendedCodes,
            "Contested: a blended component of an 8-bit target is one to five codes beyond what "
            "roundings to 8 bits yield: source, constant, both factors, both products and their "
            "sum each rounded to either neighbouring multiple of 1/255, or not, and the result "
            "stored as either neighbour (ruling 37). 17.3.6.1 asks for a precision no lower than "
            "that of the destination's components. But it states no bound for what a whole "
            "equation makes of it, and neither does OpenGL ES 3.2 (15.1.5.1). The Khronos tests "
            "(dEQP-GLES3.functional.fragment_ops.blend.*) accept 5 codes of 8 bits. What a named "
            "fault yields is a violation, however small."}}};
}

Rule color_mask_rule() {
  return {RuleId::color_mask,
          "Masked components are not written",
          "17.4.2 (fine control of buffer updates)",
          "none",
          "as-set",
          alternatives_of<ColorMaskMethod>(),
          {}};
}

}  // namespace edgecase
