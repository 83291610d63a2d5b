// SPDX-License-Identifier: MIT
#include "rules/coverage/diamond_exit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "rules/coverage/segment.h"

namespace edgecase {
namespace {

constexpr std::int64_t kHalf = Fixed::kOne / 2;

// A point in rotated coordinates, raw. |u| and |v| of a window coordinate are at most 2^30.
struct Rotated {
  std::int64_t u;
  std::int64_t v;
};

constexpr Rotated rotate(Point p) {
  return {p.x.raw() + p.y.raw(), p.x.raw() - p.y.raw()};
}

// A diamond in rotated coordinates, |u| and |v| < radius from its centre, raw.
struct Diamond {
  Rotated centre;
  std::int64_t radius = kHalf;
};

// The four sides of the diamond, as functions of the sample that are positive while the point is
// inside: u and v grow by (1, 1) and (1, -1) as the sample moves right and up.
bool inside_sides(Rotated low, Rotated high, const Diamond& d, const TieRule& ties) {
  return ties.positive(high.u - d.centre.u + d.radius, -1, -1) &&
         ties.positive(d.centre.u + d.radius - low.u, 1, 1) &&
         ties.positive(high.v - d.centre.v + d.radius, -1, 1) &&
         ties.positive(d.centre.v + d.radius - low.v, 1, -1);
}

// True if the segment from a to b meets the diamond, with ties decided by a tie rule.
bool meets_by_ties(Rotated a, Rotated b, const Diamond& d, const TieRule& ties) {
  const Rotated low{std::min(a.u, b.u), std::min(a.v, b.v)};
  const Rotated high{std::max(a.u, b.u), std::max(a.v, b.v)};
  if (!inside_sides(low, high, d, ties)) return false;
  const Int128 du = b.u - a.u;
  const Int128 dv = b.v - a.v;
  if (du == 0 && dv == 0) return true;

  // The segment's normal (-dv, du): the centre may be at most half the diamond's width away.
  const Int128 offset = du * (d.centre.v - a.v) - dv * (d.centre.u - a.u);
  const Int128 reach = ((du < 0 ? -du : du) + (dv < 0 ? -dv : dv)) * d.radius;
  const Int128 gradient_x = du - dv;
  const Int128 gradient_y = -du - dv;
  return ties.positive(reach + offset, gradient_x, gradient_y) &&
         ties.positive(reach - offset, -gradient_x, -gradient_y);
}

struct RotatedSegment {
  Rotated a;
  Rotated b;
};

// True if the segment contains the point.
bool contains(const RotatedSegment& s, Rotated p) {
  const Int128 turn = static_cast<Int128>(s.b.u - s.a.u) * (p.v - s.a.v) -
                      static_cast<Int128>(s.b.v - s.a.v) * (p.u - s.a.u);
  return turn == 0 && p.u >= std::min(s.a.u, s.b.u) && p.u <= std::max(s.a.u, s.b.u) &&
         p.v >= std::min(s.a.v, s.b.v) && p.v <= std::max(s.a.v, s.b.v);
}

// True if the segment meets the open edge {along == at, across strictly between low and high},
// where (along, across) are (u, v) or (v, u).
bool meets_edge(std::array<std::int64_t, 2> a, std::array<std::int64_t, 2> b, std::int64_t at,
                std::array<std::int64_t, 2> low_high) {
  const auto [low, high] = low_high;
  if (a[0] == at && b[0] == at) return std::max(a[1], b[1]) > low && std::min(a[1], b[1]) < high;
  if (std::min(a[0], b[0]) > at || std::max(a[0], b[0]) < at) return false;
  // It crosses at across = a1 + (at - a0) (b1 - a1) / (b0 - a0): compare after multiplying by |b0 -
  // a0|.
  const Int128 run = b[0] - a[0];
  const Int128 step = static_cast<Int128>(at - a[0]) * (b[1] - a[1]);
  const Int128 across = (run > 0 ? step : -step) + a[1] * (run > 0 ? run : -run);
  const Int128 scale = run > 0 ? run : -run;
  return across > low * scale && across < high * scale;
}

// True if the segment meets one of these parts of the boundary of the diamond with centre c.
bool touches_part(const RotatedSegment& s, Rotated c, unsigned parts) {
  const Rotated low{c.u - kHalf, c.v - kHalf};
  const Rotated high{c.u + kHalf, c.v + kHalf};
  const auto has = [&](DiamondPart part) { return (parts & part) != 0; };
  // u = x + y and v = x - y: right is high u and v, top is high u and low v.
  if (has(kRightCorner) && contains(s, high)) return true;
  if (has(kLeftCorner) && contains(s, low)) return true;
  if (has(kTopCorner) && contains(s, {high.u, low.v})) return true;
  if (has(kBottomCorner) && contains(s, {low.u, high.v})) return true;
  const auto u_edge = [&](std::int64_t u) {
    return meets_edge({s.a.u, s.a.v}, {s.b.u, s.b.v}, u, {low.v, high.v});
  };
  const auto v_edge = [&](std::int64_t v) {
    return meets_edge({s.a.v, s.a.u}, {s.b.v, s.b.u}, v, {low.u, high.u});
  };
  return (has(kUpperRightEdge) && u_edge(high.u)) || (has(kLowerLeftEdge) && u_edge(low.u)) ||
         (has(kLowerRightEdge) && v_edge(high.v)) || (has(kUpperLeftEdge) && v_edge(low.v));
}

unsigned owned_parts(const Segment& segment, const DiamondBoundary& boundary) {
  return segment.x_major() ? boundary.x_major_parts : boundary.y_major_parts;
}

// Smallest |dx| + |dy| between the centre and the segment, pixels; for people only.
double manhattan_distance(const Segment& s, Point centre) {
  const double ax = s.a.x.to_double() - centre.x.to_double();
  const double ay = s.a.y.to_double() - centre.y.to_double();
  const double dx = s.b.x.to_double() - s.a.x.to_double();
  const double dy = s.b.y.to_double() - s.a.y.to_double();
  const auto at = [&](double t) { return std::abs(ax + t * dx) + std::abs(ay + t * dy); };
  double least = std::min(at(0), at(1));
  if (dx != 0 && -ax / dx > 0 && -ax / dx < 1) least = std::min(least, at(-ax / dx));
  if (dy != 0 && -ay / dy > 0 && -ay / dy < 1) least = std::min(least, at(-ay / dy));
  return least;
}

const DiamondBoundary& boundary_named(const char* name) {
  return *find_diamond_boundary(name);
}

// Exactly the ties: the decision depends on the boundary if `open` and `closed` differ.
bool touches_only(const Segment& s, int x, int y) {
  return meets_diamond(s, x, y, boundary_named("closed")) &&
         !meets_diamond(s, x, y, boundary_named("open"));
}

bool ends_on_boundary(const Segment& s, int x, int y) {
  return ends_in_diamond(s, x, y, boundary_named("closed")) &&
         !ends_in_diamond(s, x, y, boundary_named("open"));
}

std::string describe_meeting(const Segment& s, int x, int y, const DiamondBoundary& boundary) {
  const bool meets = meets_diamond(s, x, y, boundary);
  if (touches_only(s, x, y))
    return fmt::format("only touches the boundary of the diamond round {}, and as {} has it {} it",
                       format_point(pixel_centre(x, y)), boundary.name,
                       meets ? "enters" : "misses");
  return fmt::format("comes within {:.6g} of the centre {} ({} than 0.5, so it {} the diamond)",
                     manhattan_distance(s, pixel_centre(x, y)), format_point(pixel_centre(x, y)),
                     meets ? "less" : "not less", meets ? "meets" : "misses");
}

std::string describe_end(const Segment& s, int x, int y, const DiamondBoundary& boundary) {
  const bool inside = ends_in_diamond(s, x, y, boundary);
  if (ends_on_boundary(s, x, y))
    return fmt::format("its end {} lies exactly on the diamond's boundary and counts as {}",
                       format_point(s.b), inside ? "inside, so it does not exit" : "outside");
  return fmt::format("its end {} lies {} the diamond{}", format_point(s.b),
                     inside ? "inside" : "outside", inside ? ", so it does not exit" : "");
}

}  // namespace

bool ends_in_diamond(const Segment& segment, int x, int y, const DiamondBoundary& boundary) {
  const Rotated end = rotate(segment.b);
  const Rotated centre = rotate(pixel_centre(x, y));
  if (boundary.ties != nullptr) return inside_sides(end, end, {centre}, *boundary.ties);
  return inside_sides(end, end, {centre}, open_ties()) ||
         touches_part({end, end}, centre, owned_parts(segment, boundary));
}

bool meets_diamond(const Segment& segment, int x, int y, const DiamondBoundary& boundary) {
  const Rotated a = rotate(segment.a);
  const Rotated b = rotate(segment.b);
  const Rotated c = rotate(pixel_centre(x, y));
  if (boundary.ties != nullptr) return meets_by_ties(a, b, {c}, *boundary.ties);
  return meets_by_ties(a, b, {c}, open_ties()) ||
         touches_part({a, b}, c, owned_parts(segment, boundary));
}

bool meets(const Segment& segment, const SizedDiamond& diamond) {
  const Rotated centre = rotate(pixel_centre(diamond.pixel.x, diamond.pixel.y));
  return diamond.radius > Fixed() && meets_by_ties(rotate(segment.a), rotate(segment.b),
                                                   {centre, diamond.radius.raw()}, diamond.ties);
}

bool ends_in(const Segment& segment, const SizedDiamond& diamond) {
  return meets({segment.b, segment.b}, diamond);
}

bool diamond_exit_covers(const Segment& segment, int x, int y, const DiamondBoundary& boundary) {
  return meets_diamond(segment, x, y, boundary) && !ends_in_diamond(segment, x, y, boundary);
}

std::vector<PixelPosition> diamond_exit_pixels(const Segment& segment, const PixelBounds& bounds,
                                               const DiamondBoundary& boundary) {
  std::vector<PixelPosition> result;
  visit_pixels_near(segment, bounds, [&](PixelPosition p) {
    if (diamond_exit_covers(segment, p.x, p.y, boundary)) result.push_back(p);
  });
  return result;
}

// Away from its ends, a segment can touch a diamond only by having the centre at just half the
// diamond's width from it (see meets_by_ties): a diamond's sides cannot bound the segment there,
// since it leaves the diamond's square by both sides. That is asked first.
std::vector<PixelPosition> tied_line_pixels(const Segment& segment, const PixelBounds& bounds) {
  static const DiamondBoundary& closed = boundary_named("closed");
  static const DiamondBoundary& open = boundary_named("open");
  const Rotated a = rotate(segment.a), b = rotate(segment.b);
  const Int128 du = b.u - a.u, dv = b.v - a.v;
  const Int128 reach = ((du < 0 ? -du : du) + (dv < 0 ? -dv : dv)) * kHalf;
  const auto is_near = [](Point end, PixelPosition p) {
    return std::abs(end.x.floor() - p.x) <= 2 && std::abs(end.y.floor() - p.y) <= 2;
  };
  std::vector<PixelPosition> result;
  visit_pixels_near(segment, bounds, [&](PixelPosition p) {
    const Rotated c = rotate(pixel_centre(p.x, p.y));
    const Int128 offset = du * (c.v - a.v) - dv * (c.u - a.u);
    if (offset != reach && offset != -reach && !is_near(segment.a, p) && !is_near(segment.b, p))
      return;
    // A segment that ends on a boundary meets it.
    if (!meets_diamond(segment, p.x, p.y, closed)) return;
    if (!meets_diamond(segment, p.x, p.y, open) || ends_on_boundary(segment, p.x, p.y))
      result.push_back(p);
  });
  return result;
}

Explanation explain_line(const Segment& segment, int x, int y, const DiamondBoundary& boundary) {
  Explanation result;
  if (segment.a == segment.b) {
    result.text = fmt::format(
        "the segment has no length: wherever {} lies in a diamond, the end "
        "lies there too, so it exits none",
        format_point(segment.a));
  } else {
    result.text = fmt::format("the segment {} to {} {}; {}", format_point(segment.a),
                              format_point(segment.b), describe_meeting(segment, x, y, boundary),
                              describe_end(segment, x, y, boundary));
  }
  const double cx = x + .5;
  const double cy = y + .5;
  result.figure.marks = {
      {MarkRole::region, true, {{cx - .5, cy}, {cx, cy - .5}, {cx + .5, cy}, {cx, cy + .5}}, ""},
      sample_mark(pixel_centre(x, y)),
      segment_mark(MarkRole::edge, segment.a, segment.b)};
  return result;
}

Rule diamond_exit_rule() {
  Rule rule;
  rule.id = RuleId::line_diamond_exit;
  rule.title =
      "A line produces the fragments whose diamonds it exits; a tie rule decides on their "
      "boundaries";
  rule.spec = "14.5.1 (basic line segment rasterization)";
  rule.latitude =
      "other algorithms, under three conditions: each fragment lies within one unit of one of the "
      "diamond-exit rule; the number of fragments differs by at most one; no column (row, if "
      "y-major) holds two";
  rule.standard = "left-bottom";
  rule.alternatives = tie_alternatives(all_tie_rules(), Openness::open, Openness::open);
  rule.alternatives.push_back({"direct3d", Openness::open,
                               "the diamond owns its two lower edges and its bottom corner, for "
                               "y-major lines its right corner too"});
  rule.alternatives.push_back({"scotty3d", Openness::open,
                               "the diamond owns its four edges and its left and bottom corners"});
  rule.rulings = {
      {1,
       "Lines: every produced fragment has a diamond-exit fragment of the same segment within "
       "one unit in x and y; the number of fragments differs by at most one; at most one "
       "fragment lies in a column (row, if y-major). The segment is taken as given, or as moved "
       "by one catalogued snap, the same for the whole run and surface. A line that the "
       "diamond-exit rule draws, except that ends on a diamond's boundary are moved in another "
       "direction than -(e, e^2), does not break this ruling: no arithmetic need be finer "
       "(2.3.4.1). Fragments outside the target are not seen: those of the diamond-exit rule "
       "that lie within one unit of the target's border count as seen or unseen, whichever "
       "favours the renderer."},
      {kRulingOnUnseenLine,
       "Lines of width 1 whose set of diamond-exit fragments is empty: at most one fragment is "
       "drawn, and it lies within one unit in x and y of a pixel whose closed diamond the segment "
       "meets. Ruling 58 contests one that does not lie at such a pixel."},
      {kRulingOnEmptyLine,
       "Contested: the one fragment of a line of width 1 that has no diamond-exit fragments lies "
       "within one unit in x and y of a pixel whose closed diamond the segment meets, but not at "
       "such a pixel. Rule 1 of 14.5.1 allows a fragment only near a corresponding one of the "
       "diamond-exit rule, and here there is none. But rule 2 lets one more be produced, and no "
       "rule speaks of the closed diamond. No Khronos test asks this, since all of their lines are "
       "long. OpenGL ES 3.2 has the same rules (13.6.1)."}};
  return rule;
}

Rule interior_gap_rule() {
  Rule rule;
  rule.id = RuleId::line_interior_gap;
  rule.title = "A line has no gap between its fragments";
  rule.spec = "14.5.1 (basic line segment rasterization)";
  rule.latitude = "one missing fragment passes the letter of the relaxed rules";
  rule.rulings = {
      {3,
       "Lines: a gap inside a segment, one fragment missing with others on both sides, passes the "
       "letter of the relaxed rules. It is permitted, and its cause is line.interior-gap."}};
  return rule;
}

}  // namespace edgecase
