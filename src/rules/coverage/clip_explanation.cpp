// SPDX-License-Identifier: MIT
#include "rules/coverage/clip_explanation.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/clip_volume.h"

namespace edgecase {
namespace {

constexpr const char* kCorners[] = {"first", "second", "third"};

std::string clip_of(const Vertex& vertex) {
  const ClipPosition clip = vertex.clip.value_or(ClipPosition{});
  return fmt::format("({}, {}, {}, {})", clip.x, clip.y, clip.z, clip.w);
}

// "second vertex at (0, 0, 3, 2)" of each vertex outside.
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

// Where the sample lies to the three edges, and of which one it decides: 1 inside all, 0 on one, -1
// outside of one.
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

std::string words_on_edges(const std::array<HomogeneousPoint, 3>& v,
                           const HomogeneousPoint& sample) {
  std::size_t opposite = 0;
  const int place = place_to_edges(v, sample, opposite);
  if (place > 0) return "lies inside all three edges";
  return fmt::format("lies {} the edge of the {} and the {} vertex", place < 0 ? "outside" : "on",
                     kCorners[(opposite + 1) % 3], kCorners[(opposite + 2) % 3]);
}

std::string words_on_sample(const ScenePrimitive& triangle, const HomogeneousPoint& sample,
                            const TieRule& ties) {
  if (!is_in_viewport(sample, triangle.viewport)) return "lies beyond the viewport";
  if (cross(triangle.positions[0], triangle.positions[1], triangle.positions[2]) == 0)
    return "meets no area: the triangle has none";
  const UnclippedTriangle given{triangle.positions, triangle.z};
  const std::string edges = words_on_edges(triangle.positions, sample);
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
      format_point(sample), words_on_sample(triangle, homogeneous(sample), ties));
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
