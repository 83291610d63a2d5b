// SPDX-License-Identifier: MIT
#include "rules/coverage/clip_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>

#include "exact/rational.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

bool all_in_front(const UnclippedTriangle& triangle) {
  return std::ranges::all_of(triangle.positions, [](const HomogeneousPoint& p) { return p.w > 0; });
}

// True if a vertex is nearer than near, farther than far, or behind the eye.
bool leaves_depth(const UnclippedTriangle& triangle) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t w = triangle.positions[i].w;
    if (w <= 0 || triangle.z[i] < -w || triangle.z[i] > w) return true;
  }
  return false;
}

// With e_i the determinant of the two other vertices and the sample, and e that of all three: b_i =
// e_i / e, and the sample's own w is the unit of -1 and 1. An e_i is below 2^111 and a z at most
// 2^33; e is below 2^127 and a sample's w at most 2^16.
bool lies_between_near_and_far(const UnclippedTriangle& triangle, const HomogeneousPoint& sample) {
  assert(0 < sample.w && sample.w <= Fixed::kOne);
  assert(std::ranges::all_of(triangle.z,
                             [](std::int64_t z) { return std::abs(z) <= std::int64_t{1} << 33; }));
  const auto& v = triangle.positions;
  Int256 area = cross(v[0], v[1], v[2]);
  Int256 depth = 0;
  for (std::size_t i = 0; i < 3; ++i)
    depth += Int256(cross(v[(i + 1) % 3], v[(i + 2) % 3], sample)) * triangle.z[i];
  const Int256 limit = abs(area) * sample.w;
  return abs(depth) <= limit;
}

HomogeneousPoint sample_of(PixelPosition pixel, Point within) {
  if (within == centre_of_pixel()) return homogeneous_centre(pixel.x, pixel.y);
  return homogeneous(place_in(pixel, within));
}

}  // namespace

bool clipped_triangle_covers(const UnclippedTriangle& triangle, const HomogeneousPoint& sample,
                             const TieRule& ties, bool depth) {
  if (!triangle_covers(triangle.positions, sample, ties)) return false;
  return !depth || !leaves_depth(triangle) || lies_between_near_and_far(triangle, sample);
}

bool is_in_viewport(const HomogeneousPoint& sample, const Viewport& viewport) {
  const auto between = [&](std::int64_t at, int low, int size) {
    return at >= low * sample.w && at <= (std::int64_t{low} + size) * sample.w;
  };
  return between(sample.x, viewport.x, viewport.width) &&
         between(sample.y, viewport.y, viewport.height);
}

std::vector<PixelPosition> clipped_triangle_pixels(const UnclippedTriangle& triangle,
                                                   const Viewport& viewport,
                                                   const PixelBounds& bounds, const TieRule& ties,
                                                   Point within, bool depth) {
  PixelBounds some = common_part(bounds, pixels_in(viewport));
  // Only vertices in front of the eye lie where their quotients say.
  if (all_in_front(triangle)) some = sample_bounds(nearest_triangle(triangle.positions), some);
  std::vector<PixelPosition> pixels;
  for (int y = some.y_min; y <= some.y_max; ++y)
    for (int x = some.x_min; x <= some.x_max; ++x)
      if (clipped_triangle_covers(triangle, sample_of({x, y}, within), ties, depth))
        pixels.push_back({x, y});
  return pixels;
}

Rule line_clip_rule() {
  Rule rule;
  rule.id = RuleId::line_clip;
  rule.title = "A line is clipped at the planes that the API says";
  rule.spec = "13.7 (primitive clipping)";
  rule.latitude = "none; rulings 42 and 68 say which planes clip";
  rule.standard = "as-set";
  rule.alternatives = alternatives_of<LineClip>();
  return rule;
}

Rule clip_volume_rule() {
  return {
      RuleId::clip_volume,
      "Only the part of a primitive in the clip volume is drawn",
      "13.7 (primitive clipping)",
      "new vertices are rounded and may be moved as others are; points outside the sides of the "
      "view volume may be drawn or not (ruling 42), but OpenGL ES must draw them (ruling 68)",
      "homogeneous",
      alternatives_of<ClipMethod>(),
      {{42,
        "A clipped triangle is a polygon: that part of the triangle for which -w <= z <= w, seen "
        "through the viewport. Each of its vertices may be moved by less than the step of ruling 4 "
        "and by what its computation may be off (ruling 15); of a vertex that clipping made, 1 "
        "part "
        "in 10^5 of the coordinates of the two vertices between which it lies, divided by its w. A "
        "sample may be drawn if some such move puts it inside or on an edge, and left out if some "
        "such move puts it outside or on an edge. Beyond the viewport's sides no sample is drawn. "
        "What a fragment of it carries may be the value at any place within reach of such moves. "
        "Of a line the segment is drawn that lies in the volume; an end that clipping made may be "
        "off likewise, and the rulings on lines speak of that segment. A point is drawn where its "
        "vertex lies in the volume, its border included. Where the vertex lies between near and "
        "far, but outside the volume's other sides, the point is drawn under ruling 6 or "
        "discarded, "
        "as the implementation likes; exact discards it. Elsewhere nothing is drawn of it, however "
        "large it is."},
       {kRulingOnSides,
        "OpenGL ES clips points and lines at the near and the far plane alone, where OpenGL clips "
        "lines at the viewport's sides, too, and may discard points beyond them. So of a renderer "
        "that says it is OpenGL ES a point is drawn wherever its vertex lies between near and far, "
        "and a line from end to end of what lies between them: in all pixels of the framebuffer "
        "that rulings 1, 2, 6, 12 and 28 give it. If fragments within the viewport are left out "
        "since the point was discarded or the line was cut at a side, it is a violation. Those "
        "beyond the sides may be left out under ruling 54. Triangles are clipped as in OpenGL."},
       {kRulingOnPolygonValues,
        "Contested: a value that a fragment of a clipped polygon carries, other than depth, lies "
        "between the least and the greatest of the values at the polygon's vertices, but is not "
        "that of the triangle's plane. The plane's value may be that of any place within reach: "
        "vertices may be moved by less than a sub-pixel step, and each operation may err by 1 part "
        "in 10^5 (ruling 42). Equation 14.9 interpolates values between the triangle's vertices. "
        "But of a polygon with more than three edges 14.6.1 requires only a convex combination of "
        "the values at its vertices, and so does OpenGL ES 3.2 (13.7.1). The Khronos tests "
        "(dEQP-GLES3.functional.clipping.polygon.*) want the plane's colours, within a pixel. A "
        "value below the least or above the greatest is a violation (ruling 9)."},
       {kRulingOnPolygonDepth,
        "Contested: a depth of a clipped polygon's fragment lies between the least and the "
        "greatest depth of the polygon's vertices, but not on the triangle's plane. Equation 14.10 "
        "interpolates depths between the triangle's vertices. But of a polygon with more than "
        "three edges 14.6.1 requires only a convex combination of the values at its vertices, and "
        "so does OpenGL ES 3.2 (13.7.1). The Khronos tests of clipped polygons "
        "(dEQP-GLES3.functional.clipping.polygon.*) compare coverage and colours, no depths."},
       {kRulingOnViewport,
        "Contested: a point or a line lacks fragments beyond the viewport's sides, where its "
        "square or its width reaches into the framebuffer. 14.4.1 produces a fragment for each "
        "framebuffer pixel whose centre lies in the point's square, 14.5.2.2 produces whole "
        "columns and rows, and neither cuts them at the viewport. But issue 57 of OpenGL-API asks "
        "whether they are to be cut, and is open. Implementations cut them, and so does the "
        "reference of the Khronos tests (dEQP-GLES3.functional.clipping.point.* and line.*). "
        "OpenGL ES 3.2 has the same words (13.5.1, 13.6.2.1); WebGL 1.0 makes points beyond the "
        "sides optional."}}};
}

namespace {

constexpr const char* kCorners[] = {"first", "second", "third"};

std::string clip_of(const Vertex& vertex) {
  const ClipPosition clip = vertex.clip.value_or(ClipPosition{});
  return fmt::format("({}, {}, {}, {})", clip.x, clip.y, clip.z, clip.w);
}

// "second vertex at (0, 0, 3, 2)" for each vertex outside.
std::string vertices_outside(const ScenePrimitive& triangle) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& clip = triangle.vertices[i]->clip;
    if (!clip || is_in_clip_volume(*clip)) continue;
    text += fmt::format("{}the {} vertex at {}", text.empty() ? "" : ", ", kCorners[i],
                        clip_of(*triangle.vertices[i]));
  }
  return text;
}

// The position of the sample relative to the three edges: 1 inside all, 0 on one, -1 outside of
// one; and the edge that decides.
int place_to_edges(const std::array<HomogeneousPoint, 3>& v, const HomogeneousPoint& sample,
                   std::size_t& opposite) {
  const bool turned = cross(v[0], v[1], v[2]) < 0;
  int place = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Int128 side = cross(v[(i + 1) % 3], v[(i + 2) % 3], sample);
    const int inside = side == 0 ? 0 : (side > 0) != turned ? 1 : -1;
    if (inside >= place) continue;
    place = inside;
    opposite = i;
  }
  return place;
}

std::string describe_edges(const std::array<HomogeneousPoint, 3>& v,
                           const HomogeneousPoint& sample) {
  std::size_t opposite = 0;
  const int place = place_to_edges(v, sample, opposite);
  if (place > 0) return "lies inside all three edges";
  return fmt::format("lies {} the edge of the {} and the {} vertex", place < 0 ? "outside" : "on",
                     kCorners[(opposite + 1) % 3], kCorners[(opposite + 2) % 3]);
}

std::string describe_sample(const ScenePrimitive& triangle, const HomogeneousPoint& sample,
                            const TieRule& ties) {
  if (!is_in_viewport(sample, triangle.viewport)) return "lies beyond the viewport";
  if (cross(triangle.positions[0], triangle.positions[1], triangle.positions[2]) == 0)
    return "meets no area: the triangle has none";
  const UnclippedTriangle given{triangle.positions, triangle.z};
  const std::string edges = describe_edges(triangle.positions, sample);
  if (!clipped_triangle_covers(given, sample, ties, false)) return edges + " and is not covered";
  if (!clipped_triangle_covers(given, sample, ties))
    return edges + ", but the triangle is there nearer than near or farther than far";
  return edges + ", where the triangle is between near and far, and is covered";
}

}  // namespace

Figure figure_of_seen(const ScenePrimitive& primitive) {
  Figure figure;
  if (primitive.kind != PrimitiveKind::triangle) return figure;
  const std::vector<ClipPolygonVertex> polygon = seen_polygon(primitive);
  if (polygon.empty()) return figure;
  Mark outline{MarkRole::primitive, true, {}, std::to_string(primitive.index)};
  for (const ClipPolygonVertex& vertex : polygon) {
    outline.points.push_back(position_of(vertex.position));
    figure.marks.push_back({MarkRole::vertex,
                            false,
                            {position_of(vertex.position)},
                            fmt::format("{} {}", vertex.made ? "made by clipping, about" : "about",
                                        format_point(vertex.position))});
  }
  figure.marks.push_back(std::move(outline));
  return figure;
}

Explanation explain_clipped_triangle(const ScenePrimitive& triangle, Point sample,
                                     const TieRule& ties) {
  Explanation why;
  std::string seen;
  Mark outline{MarkRole::edge, true, {}, ""};
  for (const ClipPolygonVertex& vertex : seen_polygon(triangle)) {
    outline.points.push_back(position_of(vertex.position));
    seen += fmt::format("{}{}", seen.empty() ? "" : " ", format_point(vertex.position));
  }
  why.figure.marks = {sample_mark(sample)};
  if (!outline.points.empty()) why.figure.marks.push_back(std::move(outline));
  why.text = fmt::format(
      "the triangle reaches out of the clip volume ({}), and {}; the sample {} {}",
      vertices_outside(triangle),
      seen.empty() ? "nothing of it is seen" : "what is seen of it is the polygon " + seen,
      format_point(sample), describe_sample(triangle, homogeneous(sample), ties));
  return why;
}

Explanation explain_clipped_point(const ScenePrimitive& point, Point sample) {
  Explanation why;
  why.text = fmt::format("the point's vertex at {} lies outside the clip volume: nothing is drawn",
                         clip_of(*point.vertices[0]));
  why.figure.marks = {sample_mark(sample)};
  return why;
}

}  // namespace edgecase
