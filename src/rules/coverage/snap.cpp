// SPDX-License-Identifier: MIT
#include "rules/coverage/snap.h"

#include <fmt/format.h>

#include <vector>

namespace edgecase {
namespace {

using Rounding = Snap::Rounding;

constexpr int kFinest = 12;
constexpr int kCoarsest = 4;
constexpr Rounding kRoundings[] = {Rounding::half_even, Rounding::half_up, Rounding::truncate};

const char* name_of(Rounding rounding) {
  switch (rounding) {
    case Rounding::half_even:
      return "half-even";
    case Rounding::half_up:
      return "half-up";
    case Rounding::truncate:
      return "truncate";
  }
  return "?";
}

std::vector<Snap> make_all_snaps() {
  std::vector<Snap> snaps = {Snap{}};
  for (int bits = kFinest; bits >= kCoarsest; --bits)
    for (Rounding rounding : kRoundings) snaps.push_back({bits, rounding});
  return snaps;
}

std::string meaning_of(Snap snap) {
  if (snap.is_none()) return "vertices are used as given";
  const char* how = snap.rounding == Rounding::half_even ? "nearest, a tie to the even multiple"
                    : snap.rounding == Rounding::half_up ? "nearest, a tie to the right or up"
                                                         : "largest that is not above";
  return fmt::format("vertices are moved to a multiple of 1/{} pixel: the {}", 1 << snap.bits, how);
}

}  // namespace

Fixed Snap::operator()(Fixed value) const {
  if (is_none()) return value;
  const int dropped = Fixed::kFractionBits - bits;
  const std::int64_t step = std::int64_t{1} << dropped;
  const std::int64_t below = value.raw() >> dropped;
  const std::int64_t rest = value.raw() - below * step;
  const bool up = rounding == Rounding::half_up ? 2 * rest >= step
                  : rounding == Rounding::half_even
                      ? 2 * rest > step || (2 * rest == step && (below & 1) != 0)
                      : false;
  return Fixed::from_raw((below + (up ? 1 : 0)) * step);
}

std::string name_of(Snap snap) {
  if (snap.is_none()) return "none";
  return fmt::format("{}-{}", snap.bits, name_of(snap.rounding));
}

std::span<const Snap> all_snaps() {
  static const std::vector<Snap> snaps = make_all_snaps();
  return snaps;
}

const Snap* find_snap(std::string_view name) {
  for (const Snap& snap : all_snaps())
    if (name_of(snap) == name) return &snap;
  return nullptr;
}

Rule snap_rule(const std::string& id) {
  Rule rule;
  rule.id = id;
  rule.title = id == "subpixel.snap"
                   ? "Vertices may be rounded to a sub-pixel grid"
                   : fmt::format("Vertices of {}s may be rounded to a sub-pixel grid",
                                 id.substr(0, id.find('.')));
  rule.spec = "14 (rasterization) and the implementation-dependent value SUBPIXEL_BITS";
  rule.latitude = "any grid of at least 4 bits, as many as SUBPIXEL_BITS reports";
  rule.standard = "none";
  for (Snap snap : all_snaps())
    rule.alternatives.push_back({name_of(snap), Openness::open, meaning_of(snap)});
  return rule;
}

}  // namespace edgecase
