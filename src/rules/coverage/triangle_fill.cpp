// SPDX-License-Identifier: MIT
#include "rules/coverage/triangle_fill.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "rules/coverage/window.h"

namespace edgecase {

// The interior is on the left of the edge, so an edge that goes down has it to the right in the
// window, and is a left edge.
const char* edge_kind(Point a, Point b) {
  if (b.y < a.y) return "left";
  if (b.y > a.y) return "right";
  return b.x > a.x ? "bottom" : "top";
}

namespace {

bool edge_owned(Point a, Point b, const TieRule& ties) {
  return ties.positive(0, a.y.raw() - b.y.raw(), b.x.raw() - a.x.raw());
}

// Distance of the sample from the line through a and b, pixels, positive inside; for people only.
double distance_inside(Point a, Point b, Point sample) {
  const double length = std::hypot(static_cast<double>(b.x.raw() - a.x.raw()),
                                   static_cast<double>(b.y.raw() - a.y.raw()));
  return static_cast<double>(cross(a, b, sample)) / length / static_cast<double>(Fixed::kOne);
}

// The edge that decides: one that the sample is outside of, else one that it lies on, else the
// nearest.
std::size_t deciding_edge(const Triangle& t, Point sample) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (distance_inside(t[i], t[(i + 1) % 3], sample) <
        distance_inside(t[best], t[(best + 1) % 3], sample))
      best = i;
  return best;
}

std::string describe_edge(Point a, Point b, Point sample, const TieRule& ties) {
  const std::int64_t side = cross(a, b, sample);
  const std::string edge =
      fmt::format("the {} edge {} to {}", edge_kind(a, b), format_point(a), format_point(b));
  if (side != 0)
    return fmt::format("lies {:.6g} pixels {} {}", std::abs(distance_inside(a, b, sample)),
                       side > 0 ? "inside" : "outside", edge);
  return fmt::format("lies exactly on {}, which {} {}", edge, ties.name,
                     edge_owned(a, b, ties) ? "counts as inside" : "counts as outside");
}

}  // namespace

std::int64_t doubled_area(const Triangle& t) {
  return cross(t[0], t[1], t[2]);
}

Triangle counter_clockwise(const Triangle& t) {
  return doubled_area(t) >= 0 ? t : Triangle{t[0], t[2], t[1]};
}

bool triangle_covers(const Triangle& triangle, int x, int y, const TieRule& ties) {
  if (doubled_area(triangle) == 0) return false;
  const Triangle t = counter_clockwise(triangle);
  const Point sample = pixel_centre(x, y);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = t[i];
    const Point b = t[(i + 1) % 3];
    // The edge function's gradient is the edge turned left: (-dy, dx).
    if (!ties.positive(cross(a, b, sample), a.y.raw() - b.y.raw(), b.x.raw() - a.x.raw()))
      return false;
  }
  return true;
}

Explanation explain_triangle(const Triangle& triangle, Point sample, const TieRule& ties) {
  Explanation result;
  result.figure.marks = {sample_mark(sample)};
  if (doubled_area(triangle) == 0) {
    result.text = fmt::format("the triangle {} {} {} has no area and draws nothing",
                              format_point(triangle[0]), format_point(triangle[1]),
                              format_point(triangle[2]));
    return result;
  }
  const Triangle t = counter_clockwise(triangle);
  const std::size_t i = deciding_edge(t, sample);
  result.text = fmt::format("the sample {} {}", format_point(sample),
                            describe_edge(t[i], t[(i + 1) % 3], sample, ties));
  result.figure.marks.push_back(
      segment_mark(MarkRole::edge, t[i], t[(i + 1) % 3], edge_kind(t[i], t[(i + 1) % 3])));
  for (std::size_t e = 0; e < 3; ++e)
    if (edge_owned(t[e], t[(e + 1) % 3], ties))
      result.figure.marks.push_back(segment_mark(MarkRole::owned, t[e], t[(e + 1) % 3]));
  return result;
}

// The union of the triangles after all permitted moves is the sum of the triangle and an open
// square of half-width `reach`: both are convex, and conv(A u B u C) of the three moved squares is
// that sum. A sample lies in it unless an axis or an edge's normal separates them.
bool triangle_possibly_covered(const Triangle& triangle, Point sample, Fixed reach) {
  const std::int64_t step = reach.raw();
  const auto [x_low, x_high] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
  const auto [y_low, y_high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
  if (sample.x.raw() <= x_low.raw() - step || sample.x.raw() >= x_high.raw() + step) return false;
  if (sample.y.raw() <= y_low.raw() - step || sample.y.raw() >= y_high.raw() + step) return false;
  const Triangle t = counter_clockwise(triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = t[i];
    const Point b = t[(i + 1) % 3];
    const Int128 aside =
        static_cast<Int128>(std::abs(b.x.raw() - a.x.raw()) + std::abs(b.y.raw() - a.y.raw())) *
        step;
    const Int128 side = cross(a, b, sample);
    // Without area the edges run both ways, so both sides of the segment are outside.
    if (a != b && side <= -aside) return false;
  }
  return true;
}

// (a + s - p) x (b + t - p) is linear in each of the four components of the moves s and t, so it
// stays positive over the open box of moves exactly if no corner of the box makes it negative.
bool robustly_left(Point a, Point b, Point p, Fixed reach) {
  const std::int64_t step = reach.raw();
  for (int corner = 0; corner < 16; ++corner) {
    const auto move = [&](int bit) { return (corner >> bit & 1) != 0 ? step : -step; };
    const Int128 ax = a.x.raw() + move(0) - p.x.raw();
    const Int128 ay = a.y.raw() + move(1) - p.y.raw();
    const Int128 bx = b.x.raw() + move(2) - p.x.raw();
    const Int128 by = b.y.raw() + move(3) - p.y.raw();
    if (ax * by - ay * bx < 0) return false;
  }
  return true;
}

bool left_and_apart(Point a, Point b, Point p, Fixed reach) {
  const std::int64_t dx = b.x.raw() - a.x.raw();
  const std::int64_t dy = b.y.raw() - a.y.raw();
  const Int128 side = Int128{dx} * (p.y.raw() - a.y.raw()) - Int128{dy} * (p.x.raw() - a.x.raw());
  if (side <= 0) return false;
  // What separates the segment from the square round p: the segment's line, or an axis.
  const auto is_beyond = [&](Fixed from, Fixed to, Fixed at) {
    return std::min(from, to) >= at + reach || std::max(from, to) <= at - reach;
  };
  return side >= (Int128{std::abs(dx)} + std::abs(dy)) * reach.raw() || is_beyond(a.x, b.x, p.x) ||
         is_beyond(a.y, b.y, p.y);
}

bool triangle_possibly_uncovered(const Triangle& triangle, Point sample, Fixed reach) {
  const Triangle t = counter_clockwise(triangle);
  for (std::size_t i = 0; i < 3; ++i)
    if (!robustly_left(t[i], t[(i + 1) % 3], sample, reach)) return true;
  return false;
}

Rule triangle_fill_rule() {
  return {
      RuleId::triangle_fill_rule,
      "A triangle covers the samples inside it; samples on an edge follow one tie rule",
      "14.6.1 (basic polygon rasterization)",
      "which triangle gets a sample exactly on an edge; vertices may be moved to the sub-pixel "
      "grid",
      "left-top",
      tie_alternatives(all_tie_rules(), Openness::open, Openness::illegal),
      {{4,
        "Triangles: each vertex may be moved by less than one step of 2^-b in x and in y, where "
        "b is the larger of 4 and the SUBPIXEL_BITS that the renderer reports, and a sample on "
        "an edge may go either way. A sample may be drawn if some such move puts it inside or "
        "on an edge, and left out if some such move puts it outside or on an edge. OpenGL "
        "mandates no particular fill rule. But all samples of a triangle have one move, and a "
        "triangle is convex wherever it is moved: of an unclipped one in a target of one sample, "
        "no pixel is left out whose centre lies in the hull of those that are covered, but for "
        "the border of that hull where it lies on an edge of the triangle as given. A triangle "
        "two of whose vertices are bit-identical has no area after any move, and covers nothing "
        "(appendix B, corollary 6)."}}};
}

std::optional<SharedEdge> shared_edge(const Triangle& first, const Triangle& second) {
  if (doubled_area(first) == 0 || doubled_area(second) == 0) return std::nullopt;
  const Triangle p = counter_clockwise(first);
  const Triangle q = counter_clockwise(second);
  // Triangles on opposite sides run along the common edge in opposite directions.
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (p[i] == q[(j + 1) % 3] && p[(i + 1) % 3] == q[j])
        return SharedEdge{p[i], p[(i + 1) % 3], p[(i + 2) % 3], q[(j + 2) % 3]};
  return std::nullopt;
}

bool must_hit_once(const SharedEdge& edge, Point sample, Fixed reach) {
  // Away from the edge, the rule for single triangles decides.
  if (robustly_left(edge.a, edge.b, sample, reach)) return false;
  if (robustly_left(edge.b, edge.a, sample, reach)) return false;
  return lies_between(edge, sample, reach);
}

bool lies_between(const SharedEdge& edge, Point sample, Fixed reach) {
  return robustly_left(edge.b, edge.left, sample, reach) &&
         robustly_left(edge.left, edge.a, sample, reach) &&
         robustly_left(edge.a, edge.right, sample, reach) &&
         robustly_left(edge.right, edge.b, sample, reach);
}

Rule shared_edge_rule() {
  return {
      RuleId::triangle_shared_edge,
      "A sample on an edge that two triangles share is hit exactly once",
      "14.6.1 (basic polygon rasterization)",
      "none: exactly one triangle gets the sample; which of the two is open",
      "",
      {},
      {{5,
        "Shared edges: two triangles on opposite sides of an edge with bit-identical ends hit a "
        "sample exactly once, if for every move that ruling 4 allows (the same for "
        "bit-identical vertices) the sample lies strictly inside the four other edges. Clipping "
        "makes no exception: of triangles that reach out of the clip volume the shared edge is "
        "that between the same two vertices, cut or not, and the other edges are those of their "
        "visible parts, which ruling 42 lets move. Holes and double hits there are violations."}}};
}

namespace {

int sign_of_area(const std::array<HomogeneousPoint, 3>& positions) {
  return sign(cross(positions[0], positions[1], positions[2]));
}

// The sign of the area, of vertices on the grid of whole pixels where the method has them so.
int facing_sign(std::array<HomogeneousPoint, 3> positions, FacingMethod method) {
  const bool is_cut = method == FacingMethod::of_cut_vertices;
  const bool sees_all =
      std::ranges::all_of(positions, [](const HomogeneousPoint& p) { return p.w > 0; });
  if (sees_all && (is_cut || method == FacingMethod::of_rounded_vertices)) {
    const Snap whole{0, is_cut ? Snap::Rounding::truncate : Snap::Rounding::half_up};
    for (HomogeneousPoint& p : positions) p = homogeneous(whole(p));
  }
  return sign_of_area(positions) * (method == FacingMethod::reversed ? -1 : 1);
}

}  // namespace

// A primitive without area faces the back in either winding.
bool is_front_facing(const ScenePrimitive& primitive,
                     const std::array<HomogeneousPoint, 3>& positions, FacingMethod method) {
  if (primitive.kind != PrimitiveKind::triangle) return true;
  const bool is_clockwise_front =
      primitive.state->front_face == FrontFace::cw && method != FacingMethod::always_ccw;
  const int area = facing_sign(positions, method);
  return is_clockwise_front ? area < 0 : area > 0;
}

bool is_culled(const ScenePrimitive& primitive, const std::array<HomogeneousPoint, 3>& positions,
               FacingMethod method) {
  if (primitive.kind != PrimitiveKind::triangle || method == FacingMethod::not_culled) return false;
  switch (primitive.state->cull) {
    case CullMode::none:
      return false;
    case CullMode::front:
      return is_front_facing(primitive, positions, method);
    case CullMode::back:
      return !is_front_facing(primitive, positions, method);
    case CullMode::front_and_back:
      return true;
  }
  return false;
}

Rule polygon_facing_rule() {
  return {RuleId::polygon_facing,
          "A polygon faces the front if its winding in the window is the one that the draw sets",
          "14.6.1 (basic polygon rasterization)",
          "that of the vertices' positions (ruling 40)",
          "as-set",
          alternatives_of<FacingMethod>(),
          {{40,
            "Facing: by the sign of the area that the vertices have in the window, y up, in the "
            "order of assembly (14.6.1); a polygon of no area faces the back. Where some moves of "
            "the vertices that ruling 4 allows make the area positive and others make it negative "
            "or 0, the polygon may face either way: it may be culled or not, and the stencil state "
            "of either face may hold for it, the same for all of its fragments. Of a clipped "
            "polygon the area may be that before or after clipping: where the vertices that lie "
            "behind the eye give the former another sign, it may face either way."}}};
}

}  // namespace edgecase
