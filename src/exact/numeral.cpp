// SPDX-License-Identifier: MIT
//
// Decimals are handled as strings of digits, so that no digit is rounded before it is judged. The
// fraction of a decimal, 0.d1d2d3..., times 2^16 is a long multiplication digit by digit: the carry
// out of the first digit is the whole part, and the remaining digits are the remainder. If the
// remainder is zero, the number is a multiple of 2^-16; comparing its first digit with 5 finds the
// nearest multiple, including ties. If the remainder is within half a step of doubles of a
// multiple, the digits stand for that multiple as a double.
//
// The grammar is JSON's, without spaces: no leading plus sign, no leading zeros, digits on both
// sides of the point (".5" and "1." are rejected, as in JSON). Denominators are powers of two up to
// 65536, written out, so that a pattern can check them too.
#include "exact/numeral.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace edgecase {
namespace {

constexpr std::size_t kMaxDigits = 40;
constexpr int kMaxExponent = 999;
constexpr std::int64_t kMaxRaw = std::int64_t{1} << (40 + Fixed::kFractionBits);
constexpr std::int64_t kMaxDenominator = Fixed::kOne;
constexpr std::size_t kMaxWholeDigits = 13;  // 2^40 has 13 decimal digits
// A whole number of 13 digits and its raw value fit easily in int64.
static_assert(10'000'000'000'000 < (std::int64_t{1} << 44));

using Parsed = std::variant<Fixed, NumeralError>;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kShown = 48;
  std::size_t end = std::min(text.size(), kShown);
  // Cuts between UTF-8 characters, never inside one.
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
    --end;
  std::string result(1, '"');
  result += text.substr(0, end);
  result += end < text.size() ? "...\"" : "\"";
  return result;
}

NumeralError malformed(std::string_view text) {
  return {quoted(text) +
          " is no numeral; write a decimal like 10.5, a fraction like 21/2, a whole number with a "
          "fraction like 10+3/256, or ~ and a decimal for the nearest multiple of 1/65536"};
}

NumeralError too_long(std::string_view text) {
  return {quoted(text) + " has more than 40 digits; shorten it"};
}

NumeralError too_large(std::string_view text) {
  return {quoted(text) + " is too large; write a number of magnitude 2^40 at most"};
}

// Reads characters from the left; `rest` is the unread part.
struct Cursor {
  std::string_view rest;

  bool take(char c) {
    if (rest.empty() || rest.front() != c) return false;
    rest.remove_prefix(1);
    return true;
  }
  // The digits at the front; may be empty.
  std::string_view take_digits() {
    std::size_t count = 0;
    while (count < rest.size() && is_digit(rest[count])) ++count;
    const std::string_view digits = rest.substr(0, count);
    rest.remove_prefix(count);
    return digits;
  }
};

bool is_whole(std::string_view digits) {
  return !digits.empty() && (digits.size() == 1 || digits.front() != '0');
}

// The decimal's magnitude is whole.fraction, both strings of digits.
struct Decimal {
  bool negative = false;
  std::string whole;
  std::string fraction;
};

// The exponent after 'e'; nothing if it is malformed or beyond 999 in magnitude.
std::optional<int> take_exponent(Cursor& cursor) {
  const bool negative = cursor.take('-');
  if (!negative) cursor.take('+');
  const std::string_view digits = cursor.take_digits();
  if (digits.empty()) return std::nullopt;
  int value = 0;
  for (const char digit : digits) value = std::min(kMaxExponent + 1, 10 * value + (digit - '0'));
  return negative ? -value : value;
}

// Moves the decimal point `exponent` places to the right, or to the left if negative.
void shift_point(Decimal& decimal, int exponent) {
  std::string& from = exponent > 0 ? decimal.fraction : decimal.whole;
  std::string& to = exponent > 0 ? decimal.whole : decimal.fraction;
  const auto places = static_cast<std::size_t>(exponent > 0 ? exponent : -exponent);
  if (exponent > 0) {
    if (from.size() < places) from.append(places - from.size(), '0');
    to += from.substr(0, places);
    from.erase(0, places);
  } else {
    if (from.size() < places) from.insert(0, places - from.size(), '0');
    to.insert(0, from.substr(from.size() - places));
    from.erase(from.size() - places);
  }
}

std::variant<Decimal, NumeralError> parse_decimal(std::string_view text, std::string_view shown) {
  Cursor cursor{text};
  Decimal decimal;
  decimal.negative = cursor.take('-');
  decimal.whole = cursor.take_digits();
  if (!is_whole(decimal.whole)) return malformed(shown);
  if (cursor.take('.')) {
    decimal.fraction = cursor.take_digits();
    if (decimal.fraction.empty()) return malformed(shown);
  }
  if (decimal.whole.size() + decimal.fraction.size() > kMaxDigits) return too_long(shown);
  if (cursor.take('e') || cursor.take('E')) {
    const std::optional<int> exponent = take_exponent(cursor);
    if (!exponent) return malformed(shown);
    if (*exponent > kMaxExponent || *exponent < -kMaxExponent)
      return NumeralError{quoted(shown) + " has an exponent beyond 999; write the number out"};
    shift_point(decimal, *exponent);
  }
  if (!cursor.rest.empty()) return malformed(shown);
  decimal.whole.erase(0, decimal.whole.find_first_not_of('0'));
  return decimal;
}

// The magnitude times 2^16, rounded down, and the remainder.
struct Scaled {
  std::int64_t floor = 0;
  std::string remainder;  // digits after the point

  bool exact() const { return remainder.find_first_not_of('0') == std::string::npos; }
  bool nearest_is_above() const {
    if (remainder.empty() || remainder.front() < '5') return false;
    const bool tie =
        remainder.front() == '5' && remainder.find_first_not_of('0', 1) == std::string::npos;
    return !tie || floor % 2 != 0;
  }
};

// Multiplies the digits behind a point by `factor`, at most 2^18, and returns the carry.
std::int64_t multiply(std::string& fraction, std::int64_t factor) {
  std::int64_t carry = 0;
  for (auto digit = fraction.rbegin(); digit != fraction.rend(); ++digit) {
    const std::int64_t product = (*digit - '0') * factor + carry;
    *digit = static_cast<char>('0' + product % 10);
    carry = product / 10;
  }
  return carry;
}

// `decimal.whole` has at most kMaxWholeDigits digits.
Scaled scale(const Decimal& decimal) {
  std::int64_t whole = 0;
  for (const char digit : decimal.whole) whole = 10 * whole + (digit - '0');
  Scaled scaled{0, decimal.fraction};
  scaled.floor = whole * Fixed::kOne + multiply(scaled.remainder, Fixed::kOne);
  return scaled;
}

// The remainder times 2^bits, rounded down, and whether that was exact; `bits` from 0 to 54.
std::pair<std::int64_t, bool> shifted(std::string remainder, int bits) {
  constexpr int kBitsAtOnce = 18;
  std::int64_t whole = 0;
  for (int left = bits; left > 0; left -= kBitsAtOnce) {
    const int now = std::min(left, kBitsAtOnce);
    whole = (whole << now) + multiply(remainder, std::int64_t{1} << now);
  }
  return {whole, remainder.find_first_not_of('0') == std::string::npos};
}

// The double nearest to a number between two integers, if it is an integer other than 0; otherwise
// nothing. The number must be below 2^52. Doubles around an integer n of 2^k to 2^(k + 1) - 1 are
// 2^(k - 52) apart, and half as far just below a power of two. n has an even significand, so both
// ties go to it.
std::optional<std::int64_t> nearest_double(const Scaled& scaled) {
  constexpr int kSignificandBits = 53;
  const auto log2 = [](std::int64_t n) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(n))) - 1;
  };
  const std::int64_t above = scaled.floor + 1;
  if (log2(above) >= kSignificandBits - 1) return std::nullopt;
  if (scaled.floor > 0) {
    const auto [whole, exact] = shifted(scaled.remainder, kSignificandBits - log2(scaled.floor));
    if (whole == 0 || (whole == 1 && exact)) return scaled.floor;
  }
  const bool is_power = (above & scaled.floor) == 0;
  const int bits = kSignificandBits - log2(above) + (is_power ? 1 : 0);
  if (shifted(scaled.remainder, bits).first == (std::int64_t{1} << bits) - 1) return above;
  return std::nullopt;
}

Fixed with_sign(bool negative, std::int64_t raw) {
  return Fixed::from_raw(negative ? -raw : raw);
}

NumeralError between_multiples(bool negative, std::int64_t floor, std::string_view shown) {
  Fixed lower = with_sign(negative, floor);
  Fixed upper = with_sign(negative, floor + 1);
  if (negative) std::swap(lower, upper);
  return {std::string(shown) + " is no multiple of 1/65536; write one of its neighbours " +
          to_decimal(lower) + " and " + to_decimal(upper) + ", or \"~" + std::string(shown) +
          "\" for the nearest"};
}

Parsed decimal_to_fixed(std::string_view text, std::string_view shown, bool nearest) {
  const auto parsed = parse_decimal(text, shown);
  if (const auto* error = std::get_if<NumeralError>(&parsed)) return *error;
  const Decimal& decimal = std::get<Decimal>(parsed);
  if (decimal.whole.size() > kMaxWholeDigits) return too_large(shown);
  const Scaled scaled = scale(decimal);
  if (scaled.floor > kMaxRaw || (scaled.floor == kMaxRaw && !scaled.exact()))
    return too_large(shown);
  if (scaled.exact()) return with_sign(decimal.negative, scaled.floor);
  if (const auto multiple = nearest_double(scaled)) return with_sign(decimal.negative, *multiple);
  if (!nearest) return between_multiples(decimal.negative, scaled.floor, shown);
  return with_sign(decimal.negative, scaled.floor + (scaled.nearest_is_above() ? 1 : 0));
}

// The value of a whole number up to 2^56; nothing if it is larger.
std::optional<std::int64_t> whole_value(std::string_view digits) {
  std::int64_t value = 0;
  for (const char digit : digits) {
    value = 10 * value + (digit - '0');
    if (value > kMaxRaw) return std::nullopt;
  }
  return value;
}

// The raw magnitude of numerator/denominator.
Parsed ratio(std::string_view numerator, std::string_view denominator, std::string_view shown) {
  const std::optional<std::int64_t> below = whole_value(denominator);
  if (!below || *below == 0 || *below > kMaxDenominator || (*below & (*below - 1)) != 0)
    return NumeralError{quoted(shown) +
                        " has a denominator that is no power of two up to 65536; write the "
                        "fraction with one, or ~ and a decimal for the nearest multiple of "
                        "1/65536"};
  const std::optional<std::int64_t> above = whole_value(numerator);
  const std::int64_t step = kMaxDenominator / *below;
  if (!above || *above > kMaxRaw / step) return too_large(shown);
  return Fixed::from_raw(*above * step);
}

// "N/D", "W+N/D" and "W-N/D", with an optional sign in front.
Parsed parse_fraction(std::string_view text) {
  Cursor cursor{text};
  const bool negative = cursor.take('-');
  std::string_view whole = "0";
  std::string_view numerator = cursor.take_digits();
  bool fraction_negative = negative;
  if (cursor.rest.starts_with('+') || cursor.rest.starts_with('-')) {
    fraction_negative = cursor.take('-');
    if (!fraction_negative) cursor.take('+');
    whole = numerator;
    numerator = cursor.take_digits();
  }
  if (!cursor.take('/')) return malformed(text);
  const std::string_view denominator = cursor.take_digits();
  if (!cursor.rest.empty() || !is_whole(whole) || !is_whole(numerator) || !is_whole(denominator))
    return malformed(text);
  if (whole.size() + numerator.size() + denominator.size() > kMaxDigits) return too_long(text);
  Parsed fraction = ratio(numerator, denominator, text);
  if (std::holds_alternative<NumeralError>(fraction)) return fraction;
  const std::optional<std::int64_t> ones = whole_value(whole);
  if (!ones || *ones > kMaxRaw / Fixed::kOne) return too_large(text);
  const Fixed sum = with_sign(negative, *ones * Fixed::kOne) +
                    with_sign(fraction_negative, std::get<Fixed>(fraction).raw());
  if (sum.raw() > kMaxRaw || sum.raw() < -kMaxRaw) return too_large(text);
  return sum;
}

}  // namespace

std::variant<Fixed, NumeralError> parse_numeral(std::string_view text) {
  if (text.starts_with('~')) return decimal_to_fixed(text.substr(1), text, true);
  if (text.find('/') != std::string_view::npos) return parse_fraction(text);
  return decimal_to_fixed(text, text, false);
}

std::string to_decimal(Fixed value) {
  const bool negative = value.raw() < 0;
  // The magnitude is unsigned because that of the most negative raw value does not fit otherwise.
  const auto raw = static_cast<std::uint64_t>(value.raw());
  const std::uint64_t magnitude = negative ? 0 - raw : raw;
  constexpr auto kOne = static_cast<std::uint64_t>(Fixed::kOne);
  std::string text = negative ? "-" : "";
  text += std::to_string(magnitude / kOne);
  std::uint64_t fraction = magnitude % kOne;
  if (fraction != 0) text += '.';
  while (fraction != 0) {
    fraction *= 10;
    text += static_cast<char>('0' + fraction / kOne);
    fraction %= kOne;
  }
  return text;
}

std::string to_fraction(Fixed value) {
  const bool negative = value.raw() < 0;
  const auto raw = static_cast<std::uint64_t>(value.raw());
  const std::uint64_t magnitude = negative ? 0 - raw : raw;
  // To lowest terms: divide both by the powers of two that they share.
  const int shared = magnitude == 0 ? Fixed::kFractionBits
                                    : std::min(Fixed::kFractionBits, std::countr_zero(magnitude));
  const std::uint64_t numerator = magnitude >> shared;
  const std::uint64_t denominator = static_cast<std::uint64_t>(Fixed::kOne) >> shared;
  const std::string sign = negative ? "-" : "";
  if (denominator == 1) return sign + std::to_string(numerator);
  constexpr std::uint64_t kCoarsest = 4;  // 15/4 is easy to read, 163/16 is not
  const std::uint64_t whole = denominator > kCoarsest ? numerator / denominator : 0;
  std::string text = sign;
  if (whole != 0) text += std::to_string(whole) + (negative ? "-" : "+");
  return text + std::to_string(numerator - whole * denominator) + "/" + std::to_string(denominator);
}

}  // namespace edgecase
