// SPDX-License-Identifier: MIT
#include "diff/coverage/clipped_seams.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "diff/coverage/facing_latitude.h"
#include "diff/coverage/seam_hits.h"
#include "diff/coverage/vertex_latitude.h"
#include "raster/rasterizer.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"

namespace edgecase {
namespace {

struct Edge {
  Point a, b;  // the inside is to the left
};

// Where a triangle may be seen.
LoosePolygon visible_polygon(const ScenePrimitive& triangle, int bits) {
  if (triangle.is_clipped) return loose_polygon(triangle, bits);
  const Triangle given = nearest_triangle(triangle.positions);
  return {{given.begin(), given.end()}, reach_of(triangle, bits), triangle.viewport};
}

Int128 doubled_area(std::span<const Point> polygon) {
  Int128 area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    area += Int128{a.x.raw()} * b.y.raw() - Int128{a.y.raw()} * b.x.raw();
  }
  return area;
}

// The line through two vertices, in the plane of the window: p is on it where
// x p.x + y p.y + w = 0. Vertices behind the eye have such a line, too.
struct SeamLine {
  Int128 x = 0, y = 0, w = 0;
};

SeamLine line_through(const HomogeneousPoint& a, const HomogeneousPoint& b) {
  const auto minor = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
    return Int128{p} * s - Int128{q} * r;
  };
  return {minor(a.y, a.w, b.y, b.w), minor(a.w, a.x, b.w, b.x), minor(a.x, a.y, b.x, b.y)};
}

// Whether a vertex, rounded to 2^-16 pixel, may lie on the line.
bool is_on(const SeamLine& line, Point p) {
  const Int128 side = line.x * p.x.raw() + line.y * p.y.raw() + line.w * Fixed::kOne;
  const auto size = [](Int128 value) { return value < 0 ? -value : value; };
  return size(side) <= 2 * (size(line.x) + size(line.y));
}

// A triangle beside a seam: its visible polygon's edge on the seam, and the others that may move.
struct SeamSide {
  Edge seam;
  std::vector<Edge> others;
  Fixed reach;
};

// Nothing if not just one edge lies on the seam.
std::optional<SeamSide> side_of(const ScenePrimitive& triangle, const SeamLine& line, int bits) {
  LoosePolygon polygon = visible_polygon(triangle, bits);
  std::vector<Point>& v = polygon.vertices;
  if (v.size() < 3) return std::nullopt;
  if (doubled_area(v) < 0) std::ranges::reverse(v);
  SeamSide side{{}, {}, polygon.reach};
  int on_seam = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Edge edge{v[i], v[(i + 1) % v.size()]};
    if (edge.a == edge.b) continue;
    if (is_on(line, edge.a) && is_on(line, edge.b)) {
      side.seam = edge;
      ++on_seam;
    } else if (!triangle.is_clipped || !is_on_viewport(edge.a, edge.b, triangle.viewport)) {
      side.others.push_back(edge);
    }
  }
  return on_seam == 1 ? std::optional(side) : std::nullopt;
}

// Two triangles and their seam.
struct Seam {
  std::array<SeamSide, 2> sides;
  Fixed reach;
  PixelBounds near;
  bool is_multisampled = false;

  bool is_clear(Point sample, Fixed more) const {
    return std::ranges::all_of(sides, [&](const SeamSide& side) {
      return std::ranges::all_of(side.others, [&](const Edge& edge) {
        return left_and_apart(edge.a, edge.b, sample, reach + more);
      });
    });
  }
  // Away from the seam, the rule for single triangles decides.
  bool must_hit_once(Point sample) const {
    return is_clear(sample, {}) && std::ranges::none_of(sides, [&](const SeamSide& side) {
             return robustly_left(side.seam.a, side.seam.b, sample, reach);
           });
  }
};

// The numbers of a vertex, as is_bit_identical compares them.
using VertexKey = std::array<double, 5>;

VertexKey key_of(const Vertex& vertex) {
  if (vertex.clip) {
    const ClipPosition& clip = *vertex.clip;
    return {1, clip.x, clip.y, clip.z, clip.w};
  }
  return {0, static_cast<double>(vertex.position.x.raw()),
          static_cast<double>(vertex.position.y.raw()), vertex.w, 0};
}

using SeamKey = std::pair<VertexKey, VertexKey>;

// A triangle's edge from vertex k to the next one.
struct TriangleEdge {
  std::size_t triangle = 0;
  std::size_t k = 0;
};

SeamKey key_of(const ScenePrimitive& triangle, std::size_t k) {
  const VertexKey a = key_of(*triangle.vertices[k]);
  const VertexKey b = key_of(*triangle.vertices[(k + 1) % 3]);
  return a < b ? SeamKey{a, b} : SeamKey{b, a};
}

// Compares the drawings of two triangles along their seams.
class SeamComparison {
 public:
  SeamComparison(std::span<const ScenePrimitive> primitives,
                 std::span<const PrimitiveCoverage> coverage, const Scene& scene, int bits,
                 const SamplePositions& positions)
      : primitives_(primitives),
        coverage_(coverage),
        scene_(scene),
        bits_(bits),
        positions_(positions) {}

  void compare(const TriangleEdge& first, std::size_t second) {
    const ScenePrimitive& one = primitives_[first.triangle];
    const ScenePrimitive& other = primitives_[second];
    if (one.viewport != other.viewport || may_be_culled(one) || may_be_culled(other) ||
        is_multisampled(one) != is_multisampled(other))
      return;
    const auto seam = seam_of(one, other, first.k);
    if (!seam) return;
    for (const auto& [sample, within] : shared_samples(one, other, scene_.target, positions_))
      add_seam_faults(*seam, one.index, other.index, sample, within, coverage_, faults_);
  }

  std::vector<SharedEdgeFault> take() { return std::move(faults_); }

 private:
  bool may_be_culled(const ScenePrimitive& triangle) const {
    return permitted_culling(triangle, bits_).may_be_culled;
  }
  bool is_multisampled(const ScenePrimitive& triangle) const {
    return edgecase::is_multisampled(*triangle.state, scene_.target);
  }

  std::optional<Seam> seam_of(const ScenePrimitive& one, const ScenePrimitive& other,
                              std::size_t k) const {
    const SeamLine line = line_through(one.positions[k], one.positions[(k + 1) % 3]);
    if (line.x == 0 && line.y == 0) return std::nullopt;
    const auto left = side_of(one, line, bits_);
    const auto right = side_of(other, line, bits_);
    if (!left || !right || !runs_against(left->seam, right->seam)) return std::nullopt;
    Seam seam{{*left, *right}, std::max(left->reach, right->reach), {}, is_multisampled(one)};
    seam.near = pixels_near(seam, one, other);
    return seam;
  }

  // On opposite sides of a seam, triangles of one winding run along it in opposite directions.
  static bool runs_against(const Edge& one, const Edge& other) {
    const Int128 along =
        Int128{one.b.x.raw() - one.a.x.raw()} * (other.b.x.raw() - other.a.x.raw()) +
        Int128{one.b.y.raw() - one.a.y.raw()} * (other.b.y.raw() - other.a.y.raw());
    return along < 0;
  }

  PixelBounds pixels_near(const Seam& seam, const ScenePrimitive& one,
                          const ScenePrimitive& other) const {
    PixelBounds bounds = common_part(drawable_bounds(*one.state, scene_.target),
                                     drawable_bounds(*other.state, scene_.target));
    const Viewport& v = one.viewport;
    bounds = common_part(bounds, pixels_in(v));
    const auto [a, b] = seam.sides[0].seam;
    const auto [c, d] = seam.sides[1].seam;
    const auto [x_low, x_high] = std::minmax({a.x, b.x, c.x, d.x});
    const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y, d.y});
    return bounds_near({x_low, y_low}, {x_high, y_high}, bounds);
  }

  std::span<const ScenePrimitive> primitives_;
  std::span<const PrimitiveCoverage> coverage_;
  const Scene& scene_;
  const int bits_;
  const SamplePositions& positions_;
  std::vector<SharedEdgeFault> faults_;
};

}  // namespace

std::vector<SharedEdgeFault> clipped_seam_faults(std::span<const ScenePrimitive> primitives,
                                                 std::span<const PrimitiveCoverage> coverage,
                                                 const Scene& scene, int bits,
                                                 const SamplePositions& positions,
                                                 bool exact_has_none) {
  SeamComparison comparison(primitives, coverage, scene, bits, positions);
  const auto is_as_exact = [&](std::size_t i) {
    const PrimitiveCoverage& own = coverage[static_cast<std::size_t>(primitives[i].index)];
    return own.drawn == own.exact;
  };
  const auto is_clipped = [](const ScenePrimitive& primitive) {
    return primitive.kind == PrimitiveKind::triangle && primitive.is_clipped;
  };
  if (std::ranges::none_of(primitives, is_clipped)) return {};
  std::map<SeamKey, std::vector<TriangleEdge>> before;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (primitives[i].kind != PrimitiveKind::triangle) continue;
    for (std::size_t k = 0; k < 3; ++k)
      for (const TriangleEdge& other : before[key_of(primitives[i], k)])
        if ((is_clipped(primitives[i]) || is_clipped(primitives[other.triangle])) &&
            !(exact_has_none && is_as_exact(i) && is_as_exact(other.triangle)))
          comparison.compare(other, i);
    for (std::size_t k = 0; k < 3; ++k) before[key_of(primitives[i], k)].push_back({i, k});
  }
  return comparison.take();
}

}  // namespace edgecase
