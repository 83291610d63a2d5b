// SPDX-License-Identifier: MIT
//
// A decimal equals a float32 number if both have the same significant digits and order of
// magnitude. Every float32 number is a finite decimal with at most 149 fraction digits, which
// std::to_chars writes in full.
#include "casefile/json/numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <variant>

#include "exact/numeral.h"

namespace edgecase {

namespace {

constexpr int kMostFractionDigits = 149;
constexpr std::int64_t kLargestExponent = 1'000'000;  // far beyond float32 in either direction

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::size_t skip_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

// -? (0 | [1-9][0-9]*) (\.[0-9]+)? ([eE][+-]?[0-9]+)?
bool is_json_number(std::string_view text) {
  std::size_t at = text.starts_with('-') ? 1 : 0;
  const std::size_t whole = at;
  at = skip_digits(text, at);
  if (at == whole || (text[whole] == '0' && at - whole > 1)) return false;
  if (at < text.size() && text[at] == '.') {
    const std::size_t fraction = at + 1;
    at = skip_digits(text, fraction);
    if (at == fraction) return false;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    const std::size_t exponent = at;
    at = skip_digits(text, exponent);
    if (at == exponent) return false;
  }
  return at == text.size();
}

// 0.DIGITS times a power of ten, without zeros at either end; zero has no digits.
struct Magnitude {
  std::string digits;
  std::int64_t order = 0;
  friend bool operator==(const Magnitude&, const Magnitude&) = default;
};

std::int64_t exponent_of(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  std::int64_t value = 0;
  for (const char digit : text) value = std::min(kLargestExponent, 10 * value + (digit - '0'));
  return negative ? -value : value;
}

// The magnitude of a decimal in JSON's grammar.
Magnitude magnitude_of(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  const std::size_t point = std::min(text.find('.'), end);
  Magnitude result;
  result.digits = text.substr(0, point);
  result.order = static_cast<std::int64_t>(point);
  if (point < end) result.digits += text.substr(point + 1, end - point - 1);
  if (end < text.size()) result.order += exponent_of(text.substr(end + 1));
  const std::size_t zeros = std::min(result.digits.find_first_not_of('0'), result.digits.size());
  result.digits.erase(0, zeros);
  result.order -= static_cast<std::int64_t>(zeros);
  result.digits.erase(result.digits.find_last_not_of('0') + 1);
  if (result.digits.empty()) result.order = 0;
  return result;
}

std::string written(float value, std::chars_format format, int precision) {
  std::array<char, 256> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, format, precision).ptr;
  return {text.data(), end};
}

// Whether exact/numeral.h reads the decimal as a multiple of 2^-16 equal to this number.
bool is_multiple(std::string_view text, double value) {
  const auto numeral = parse_numeral(text);
  const Fixed* fixed = std::get_if<Fixed>(&numeral);
  return fixed != nullptr && fixed->to_double() == value;
}

std::optional<Float32Numeral> parse_decimal(std::string_view text) {
  float value = 0;
  const char* end = text.data() + text.size();
  if (std::from_chars(text.data(), end, value).ec != std::errc()) {
    // Either too large, or so small that zero is nearest.
    const Magnitude magnitude = magnitude_of(text);
    if (magnitude.order > 0) return std::nullopt;
    value = 0;
  }
  double wide = 0;
  if (std::from_chars(text.data(), end, wide).ec != std::errc()) wide = 0;
  const Magnitude nearest =
      magnitude_of(written(value, std::chars_format::fixed, kMostFractionDigits));
  const bool exact = magnitude_of(text) == nearest || is_multiple(text, value);
  return Float32Numeral{value + 0.0F, exact, wide};
}

}  // namespace

std::optional<Float32Numeral> parse_float32(std::string_view text) {
  if (is_json_number(text)) return parse_decimal(text);
  if (text.find('/') == std::string_view::npos) return std::nullopt;
  const auto fraction = parse_numeral(text);
  const Fixed* fixed = std::get_if<Fixed>(&fraction);
  if (fixed == nullptr) return std::nullopt;
  // The magnitude is at most 2^40, with 16 fraction bits.
  const auto value = static_cast<float>(fixed->raw());
  const bool exact = static_cast<std::int64_t>(value) == fixed->raw();
  return Float32Numeral{std::ldexp(value, -Fixed::kFractionBits), exact, fixed->to_double()};
}

std::string exact_decimal(float value) {
  constexpr float kLarge = 1e15F;
  constexpr float kSmall = 1e-5F;
  const float magnitude = std::fabs(value);
  const bool plain = magnitude == 0 || (magnitude >= kSmall && magnitude < kLarge);
  std::string text = written(
      value, plain ? std::chars_format::fixed : std::chars_format::scientific, kMostFractionDigits);
  const std::size_t end = std::min(text.find('e'), text.size());
  std::size_t last = text.find_last_not_of('0', end - 1);
  if (text[last] != '.') ++last;
  text.erase(last, end - last);
  return text;
}

std::string short_decimal(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

// The exact sum is a list of doubles that do not overlap (J. R. Shewchuk, Adaptive Precision
// Floating-Point Arithmetic, 1997): the error of adding two doubles is itself a double, and so is
// the remainder of a division. An inexact quotient is rounded towards zero and its last bit set
// ("round to odd"), so that the second rounding, to float32, gives the same result as one rounding
// of the true quotient: a double has more than two spare bits.

namespace {

// Doubles that do not overlap, in increasing magnitude, without zeros.
struct Expansion {
  std::array<double, 10> parts{};  // one for each of 8 terms, and the two of a product
  std::size_t size = 0;
};

void add(double term, Expansion& sum) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sum.size; ++i) {
    double larger = term;
    double smaller = sum.parts[i];
    if (std::fabs(larger) < std::fabs(smaller)) std::swap(larger, smaller);
    term = larger + smaller;
    const double error = smaller - (term - larger);
    if (error != 0) sum.parts[kept++] = error;
  }
  if (term != 0) sum.parts[kept++] = term;
  sum.size = kept;
}

double nearest(const Expansion& sum) {
  double value = 0;
  for (std::size_t i = 0; i < sum.size; ++i) value += sum.parts[i];
  return value;
}

// sum - quotient * divisor, exactly.
Expansion left_over(Expansion sum, double quotient, double divisor) {
  const double product = quotient * divisor;
  add(-product, sum);
  add(-std::fma(quotient, divisor, -product), sum);
  return sum;
}

// Rounds a double next to the true quotient; `lacks` has the sign of true minus given quotient.
double round_to_odd(double quotient, double lacks) {
  if (lacks == 0) return quotient;
  if ((lacks < 0) != (quotient < 0)) quotient = std::nextafter(quotient, 0.0);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(quotient) | 1U);
}

}  // namespace

float nearest_quotient(std::span<const double> terms, double divisor) {
  Expansion sum;
  for (const double term : terms) add(term, sum);
  // The first quotient may be two doubles off; the corrected one is next to the true one.
  double quotient = nearest(sum) / divisor;
  quotient += nearest(left_over(sum, quotient, divisor)) / divisor;
  const double lacks = nearest(left_over(sum, quotient, divisor));
  return static_cast<float>(round_to_odd(quotient, lacks)) + 0.0F;
}

}  // namespace edgecase
