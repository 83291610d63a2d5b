// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "casefile/numbers.h"
#include "casefile/text.h"
#include "casefile/transform.h"

namespace edgecase {
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
