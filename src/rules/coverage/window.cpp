// SPDX-License-Identifier: MIT
#include "rules/coverage/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "exact/fixed.h"

namespace edgecase {

Rule window_origin_rule() {
  Rule rule;
  rule.id = kWindowOrigin;
  rule.title = "The window's origin is its lower left corner: y points up";
  rule.spec = "13.8.1 (controlling the viewport), 14 (rasterization), 18.2.2 (reading pixels)";
  rule.latitude = "none";
  rule.rulings = {
      {kRulingOnOrigin,
       "An answer is upside down where it disagrees as it stands and nothing of it does with its "
       "rows in the opposite order. Its cause is then window.origin, if more cases of the run are "
       "upside down and break another ruling as they stand than are not. All that disagrees in an "
       "upside-down answer breaks this rule, and no other."}};
  return rule;
}

Rule row_order_rule(RuleId id) {
  Rule rule;
  rule.id = id;
  const std::string name = name_of(id);
  const std::string kind = name.substr(0, name.find('.'));
  rule.title =
      fmt::format("Ties and rounding of {}s are decided with y up, as in window coordinates",
                  static_cast<char>(kind[0] - 'a' + 'A') + kind.substr(1));
  rule.spec = "14 (rasterization), which does not speak of memory";
  rule.latitude = "any, as long as the rulings on what is drawn hold";
  rule.standard = "bottom-up";
  rule.alternatives = alternatives_of<RowOrder>();
  return rule;
}

Point turned_over(Point point, int height) {
  return {point.x, Fixed::from_integer(height) - point.y};
}

HomogeneousPoint turned_over(const HomogeneousPoint& point, int height) {
  return {point.x, height * point.w - point.y, point.w};
}

PixelBounds turned_over(const PixelBounds& bounds, int height) {
  return {bounds.x_min, height - 1 - bounds.y_max, bounds.x_max, height - 1 - bounds.y_min};
}

Rule fragment_once_rule() {
  return {RuleId::fragment_once,
          "A primitive produces at most one fragment per pixel",
          "14.4 to 14.6",
          "none",
          "",
          {},
          {{7,
            "A primitive that produces two fragments of the same pixel violates the rule that "
            "produced it: point, line and triangle rules describe sets of fragments."}}};
}

Rule fragment_invariant_rule() {
  return {
      RuleId::fragment_invariant,
      "A scene and its image are drawn alike",
      "14.2 (invariance); A.3 (invariance rules)",
      "none; under multisampling a primitive that is moved may have other samples (14.3.1)",
      "",
      {},
      {{kRulingOnImages,
        "Two drawings of a renderer are held against each other, and against no other. A "
        "primitive of a target of one sample, moved by whole pixels and cut by nothing, has the "
        "same fragments, each moved as far (14.2). Colour masks, clear colours, the box of the "
        "scissor test and what lies in the buffers decide neither which fragments there are nor "
        "their depths and colours, nor what is stored of them inside the box (A.3, rule 2). The "
        "same scene, drawn again, is the same to the last bit (A.3, rule 1). Values of a moved "
        "primitive are not compared: ruling 9 judges each."},
       {kRulingOnSuggestedImages,
        "Contested: a fragment is another one, or is missing, with other parameters of blending or "
        "with a depth buffer that nothing reads. A.3 (rule 2) suggests strongly, and does not "
        "require, that blending's parameters have no side effects, and its corollary 1 counts "
        "them with the rest; it does not name the formats of buffers. Where the fragment is wrong "
        "by itself, the rule that makes it convicts."}}};
}

namespace {

using Rounding = Snap::Rounding;

constexpr int kFinest = 12;
constexpr int kCoarsest = 4;
std::vector<Snap> make_all_snaps() {
  std::vector<Snap> snaps = {Snap{}};
  for (int bits = kFinest; bits >= kCoarsest; --bits)
    for (Rounding rounding : values_of<Rounding>()) snaps.push_back({bits, rounding});
  return snaps;
}

std::string meaning_of(Snap snap) {
  if (snap.is_none()) return "vertices are used as given";
  const char* how = snap.rounding == Rounding::half_even ? "nearest, a tie to the even multiple"
                    : snap.rounding == Rounding::half_up ? "nearest, a tie to the right or up"
                                                         : "largest that is not above";
  return fmt::format("vertices are moved to a multiple of 1/{} pixel: the {}", 1 << snap.bits, how);
}

// Largest integer not above numerator/denominator; the denominator is positive.
Int128 floor_quotient(Int128 numerator, Int128 denominator) {
  const Int128 quotient = numerator / denominator;
  return numerator % denominator < 0 ? quotient - 1 : quotient;
}

// True if a value that is rest/whole of a step above grid line `below` is rounded up.
bool rounds_up(Rounding rounding, Int128 below, Int128 rest, Int128 whole) {
  switch (rounding) {
    case Rounding::half_even:
      return 2 * rest > whole || (2 * rest == whole && (below & 1) != 0);
    case Rounding::half_up:
      return 2 * rest >= whole;
    case Rounding::truncate:
      return false;
  }
  return false;
}

Ruling ruling_on_division() {
  return {
      15,
      "A vertex with w other than 1, or given as clip coordinates: the division by w, the scaling "
      "to the viewport and the addition of its centre may each err by 1 part in 10^5 (2.3.4.1), so "
      "that the vertex may be off, in x and in y, by (2 |x - c| + |x|)/10^5, where c is the "
      "viewport's centre, and 2^-16 pixel. It is bit-identical to a vertex with the same clip "
      "coordinates, or the same position and w. Points, triangles and multisampled lines: this "
      "adds to the step of rulings 4, 5, 6 and 28. A vertex given in the window with w = 1 is "
      "scaled and added to as well: it may be off by (|x - c| + |x|)/10^5, which takes the place "
      "of the step where it is larger. Other lines: the ends may lie wherever the snap of ruling 1 "
      "puts vertices that are off by so much. Rulings 1, 2 and 12 then hold against the fragments "
      "that the diamond-exit rule has for some such ends, and count as missing only those that it "
      "has for all of them; a line whose major axis depends on them is read either way. Ruling 14 "
      "holds where major axis and direction do not depend on them."};
}

}  // namespace

Fixed Snap::operator()(Fixed value) const {
  if (is_none()) return value;
  const int dropped = Fixed::kFractionBits - bits;
  const std::int64_t step = std::int64_t{1} << dropped;
  const std::int64_t below = value.raw() >> dropped;
  const std::int64_t rest = value.raw() - below * step;
  return Fixed::from_raw((below + (rounds_up(rounding, below, rest, step) ? 1 : 0)) * step);
}

Point Snap::operator()(const HomogeneousPoint& point) const {
  if (is_none()) return nearest_point(point);
  if (point.w == Fixed::kOne) return (*this)(nearest_point(point));
  const auto snapped = [&](std::int64_t coordinate) {
    // In steps of the grid, at most 2^58 over 2^32.
    const Int128 steps = Int128{coordinate} << bits;
    const Int128 below = floor_quotient(steps, point.w);
    const Int128 rest = steps - below * point.w;
    const bool up = rounds_up(rounding, below, rest, point.w);
    return Fixed::from_raw(static_cast<std::int64_t>(below + (up ? 1 : 0)) * grid_step(bits).raw());
  };
  return {snapped(point.x), snapped(point.y)};
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
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Snap snap : all_snaps()) list.push_back(name_of(snap));
    return list;
  }();
  const auto found = std::ranges::find(names, name);
  return found != names.end() ? &all_snaps()[static_cast<std::size_t>(found - names.begin())]
                              : nullptr;
}

Rule snap_rule(RuleId id) {
  Rule rule;
  rule.id = id;
  const std::string name = name_of(id);
  rule.title = id == RuleId::subpixel_snap
                   ? "Vertices may be rounded to a sub-pixel grid"
                   : fmt::format("Vertices of {}s may be rounded to a sub-pixel grid",
                                 name.substr(0, name.find('.')));
  rule.spec = "14 (rasterization) and the implementation-dependent value SUBPIXEL_BITS";
  rule.latitude = "any grid of at least 4 bits, as many as SUBPIXEL_BITS reports";
  rule.standard = "none";
  for (Snap snap : all_snaps())
    rule.alternatives.push_back({name_of(snap), Openness::open, meaning_of(snap)});
  if (id == RuleId::subpixel_snap) rule.rulings = {ruling_on_division()};
  return rule;
}

}  // namespace edgecase
