// SPDX-License-Identifier: MIT
#include "casefile/mesh/transform.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "casefile/json/numbers.h"
#include "casefile/json/text.h"
#include "exact/elementary.h"
#include "exact/fixed.h"

namespace edgecase {

namespace {

constexpr int kFineBits = 48;  // fraction bits of steps and points
constexpr int kSpareBits = kFineBits - Fixed::kFractionBits;
constexpr std::int64_t kMostFine = std::int64_t{1} << (14 + kFineBits);  // 2^14 pixels
// Factors have at most 2^58 units, coordinates 2^62: a sum of two products fits in 122 bits.
static_assert(kMaxAffineFactor == 1 << 10 && kMaxAffineShift == 1 << 14);

std::int64_t fine(Fixed value) {
  return value.raw() * (std::int64_t{1} << kSpareBits);
}

// numerator / 2^bits rounded to nearest, ties up; clears `exact` if that is not exact.
Int128 shifted(Int128 numerator, int bits, bool& exact) {
  const Int128 unit = Int128{1} << bits;
  const Int128 quotient = (numerator + unit / 2) >> bits;
  exact = exact && quotient * unit == numerator;
  return quotient;
}

bool in_range(Int128 value) {
  return value >= -kMostFine && value <= kMostFine;
}

}  // namespace

AffineStep affine_step(const std::array<Fixed, 6>& a_to_f) {
  AffineStep step;
  for (std::size_t i = 0; i < 4; ++i) step.linear[i] = fine(a_to_f[i]);
  for (std::size_t i = 0; i < 2; ++i) step.shift[i] = fine(a_to_f[4 + i]);
  return step;
}

AffineStep turn_step(Fixed degrees) {
  constexpr std::int64_t kQuarter = 90 * Fixed::kOne;
  const std::int64_t turn = ((degrees.raw() % (4 * kQuarter)) + 4 * kQuarter) % (4 * kQuarter);
  constexpr std::int64_t kUnit = std::int64_t{1} << kFineBits;
  if (turn % kQuarter == 0) {
    constexpr std::int64_t kCosines[] = {kUnit, 0, -kUnit, 0};
    const auto quarters = static_cast<std::size_t>(turn / kQuarter);
    const std::int64_t c = kCosines[quarters];
    const std::int64_t s = kCosines[(quarters + 3) % 4];
    return {{c, s, -s, c}, {}, true};
  }
  const double angle = Fixed::from_raw(turn).to_double() * std::numbers::pi / 180;
  const std::int64_t c = std::llround(std::ldexp(cosine(angle), kFineBits));
  const std::int64_t s = std::llround(std::ldexp(sine(angle), kFineBits));
  return {{c, s, -s, c}, {}, false};
}

std::optional<MovedPoint> move_point(Point point, std::span<const AffineStep> steps) {
  Int128 x = fine(point.x);
  Int128 y = fine(point.y);
  bool exact = true;
  for (const AffineStep& step : steps) {
    exact = exact && step.exact;
    const auto& [a, b, c, d] = step.linear;
    const Int128 next_x = shifted(a * x + c * y, kFineBits, exact) + step.shift[0];
    const Int128 next_y = shifted(b * x + d * y, kFineBits, exact) + step.shift[1];
    if (!in_range(next_x) || !in_range(next_y)) return std::nullopt;
    x = next_x;
    y = next_y;
  }
  const Int128 raw_x = shifted(x, kSpareBits, exact);
  const Int128 raw_y = shifted(y, kSpareBits, exact);
  return MovedPoint{{Fixed::from_raw(static_cast<std::int64_t>(raw_x)),
                     Fixed::from_raw(static_cast<std::int64_t>(raw_y))},
                    exact};
}

namespace {

const Keys kStepKeys{{}, {"translate", "rotate", "scale", "shear", "matrix"}, {}};
const Keys kTurnKeys{{"degrees"}, {}, {}};

constexpr FixedRange within(int largest) {
  return {Fixed::from_integer(-largest), Fixed::from_integer(largest)};
}
constexpr FixedRange kFactorRange = within(kMaxAffineFactor);
constexpr FixedRange kShiftRange = within(kMaxAffineShift);
constexpr FixedRange kDegreesRange = within(16384);

constexpr Fixed kZero;
constexpr Fixed kOne = Fixed::from_integer(1);

Fixed read_one(const Place& place, std::size_t index, FixedRange range, Findings& findings) {
  return read_coordinate(place.child(index), "a number of a map", range, findings).value_or(kZero);
}

AffineStep read_turn(const Place& place, Findings& findings) {
  const ObjectReader object(place, "a rotation", kTurnKeys, findings);
  const auto degrees = object.find("degrees");
  if (!degrees) return turn_step(kZero);
  return turn_step(read_coordinate(*degrees, "degrees", kDegreesRange, findings).value_or(kZero));
}

// [x, y] of a translation, a scaling or a shear; [a, b, c, d, e, f] of a matrix.
AffineStep read_numbers(const Place& place, const std::string& name, Findings& findings) {
  std::array<Fixed, 6> a_to_f{kOne, kZero, kZero, kOne, kZero, kZero};
  if (!expect_count(place, name, name == "matrix" ? 6 : 2, findings)) return affine_step(a_to_f);
  const auto factor = [&](std::size_t i) { return read_one(place, i, kFactorRange, findings); };
  const auto shift = [&](std::size_t i) { return read_one(place, i, kShiftRange, findings); };
  if (name == "translate") {
    a_to_f[4] = shift(0);
    a_to_f[5] = shift(1);
  } else if (name == "scale") {
    a_to_f[0] = factor(0);
    a_to_f[3] = factor(1);
  } else if (name == "shear") {
    a_to_f[2] = factor(0);
    a_to_f[1] = factor(1);
  } else {
    for (std::size_t i = 0; i < 4; ++i) a_to_f[i] = factor(i);
    for (std::size_t i = 4; i < 6; ++i) a_to_f[i] = shift(i);
  }
  return affine_step(a_to_f);
}

AffineStep read_step(const Place& place, Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, "a map", kStepKeys, findings);
  if (findings.size() != before) return {};
  if (place.node->children.size() != 1) {
    findings.add(place, fmt::format("a map has {} keys", place.node->children.size()),
                 "write exactly one of " + join_names(kStepKeys.optional));
    return {};
  }
  const Place member = place.child(0);
  if (member.node->name == "rotate") return read_turn(member, findings);
  return read_numbers(member, member.node->name, findings);
}

}  // namespace

std::vector<AffineStep> read_affine(const Place& place, Findings& findings) {
  std::vector<AffineStep> steps;
  if (!expect_kind(place, JsonKind::array, "a list of affine maps", findings)) return steps;
  const std::size_t count = place.node->children.size();
  if (count == 0 || count > kMaxOperations) {
    findings.add(place, fmt::format("a list has {} affine maps", count),
                 fmt::format("write 1 to {}", kMaxOperations));
    return steps;
  }
  for (std::size_t i = 0; i < count; ++i) steps.push_back(read_step(place.child(i), findings));
  return steps;
}

}  // namespace edgecase
