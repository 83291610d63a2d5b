// SPDX-License-Identifier: MIT
#include "diff/coverage/neighbour_faults.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "diff/coverage/clipped_seams.h"
#include "diff/coverage/seam_hits.h"
#include "diff/coverage/vertex_latitude.h"
#include "raster/rasterizer.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_joints.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"

namespace edgecase {
namespace {

// The line as given; quotients are rounded to the nearest point.
Segment segment_of(const ScenePrimitive& line) {
  return {nearest_point(line.positions[0]), nearest_point(line.positions[1])};
}

// Connected lines in one direction: the first and last have drawn fragments, those between none.
using Chain = std::vector<std::size_t>;

class Chains {
 public:
  Chains(std::span<const ScenePrimitive> primitives, std::span<const PrimitiveCoverage> coverage,
         const Target& target)
      : primitives_(primitives), coverage_(coverage), target_(target) {
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      if (!is_thin_line(primitives[i])) continue;
      const Point start = segment_of(primitives[i]).a;
      starting_at_[{start.x, start.y}].push_back(i);
    }
  }

  std::vector<Chain> all() {
    for (std::size_t i = 0; i < primitives_.size(); ++i)
      if (is_thin_line(primitives_[i]) && has_drawn(i)) extend({i});
    return std::move(found_);
  }

 private:
  // Multisampled lines are rectangles, and overlap at their joints.
  bool is_thin_line(const ScenePrimitive& primitive) const {
    return primitive.kind == PrimitiveKind::line && !primitive.is_clipped &&
           !is_multisampled(*primitive.state, target_) &&
           rounded_width(primitive.state->line_width) == 1;
  }
  bool has_drawn(std::size_t i) const { return !coverage_[i].drawn.front().empty(); }

  // The major coordinate grows along a chain, so no chain returns to an earlier point.
  void extend(const Chain& chain) {
    const Segment last = segment_of(primitives_[chain.back()]);
    const Vertex& end = *primitives_[chain.back()].vertices[1];
    const auto next = starting_at_.find({last.b.x, last.b.y});
    if (next == starting_at_.end()) return;
    for (std::size_t j : next->second) {
      if (!is_bit_identical(end, *primitives_[j].vertices[0])) continue;
      if (!goes_on(last, segment_of(primitives_[j]))) continue;
      Chain longer = chain;
      longer.push_back(j);
      if (!has_drawn(j))
        extend(longer);
      else
        found_.push_back(std::move(longer));
    }
  }

  std::span<const ScenePrimitive> primitives_;
  std::span<const PrimitiveCoverage> coverage_;
  const Target& target_;
  std::map<std::pair<Fixed, Fixed>, std::vector<std::size_t>> starting_at_;
  std::vector<Chain> found_;
};

// True if each segment continues the one before. Segments without length, which a snap can make,
// are skipped.
bool is_one_line(std::span<const Segment> segments, Fixed reach) {
  for (std::size_t i = 1; i < segments.size(); ++i)
    if (!goes_on(segments[i - 1], segments[i], reach)) return false;
  return segments.size() >= 2;
}

std::string broken_clause(const Chain& chain, std::span<const ScenePrimitive> primitives,
                          std::span<const PrimitiveCoverage> coverage, const Scene& scene,
                          Snap snap) {
  std::vector<Segment> segments;
  Fixed reach;
  bool some_without_length = false;
  for (std::size_t i : chain) {
    const LooseSegment loose = snapped_segment(primitives[i], snap, end_errors(primitives[i]));
    const Segment& segment = loose.segment;
    const bool is_end = i == chain.front() || i == chain.back();
    if (is_end && segment.a == segment.b) return "";
    reach = std::max(reach, loose.reach);
    some_without_length = some_without_length || segment.a == segment.b;
    if (segment.a != segment.b) segments.push_back(segment);
  }
  // A segment without length may have any direction, if its ends erred.
  if (some_without_length && reach != Fixed()) return "";
  if (!is_one_line(segments, reach)) return "";
  const auto drawn = [&](std::size_t i, const Segment& segment) {
    return DrawnSegment{segment, coverage[i].drawn.front(),
                        drawable_bounds(*primitives[i].state, scene.target)};
  };
  return broken_joint_clause(drawn(chain.front(), segments.front()),
                             std::span(segments).subspan(1, segments.size() - 2),
                             drawn(chain.back(), segments.back()), reach);
}

}  // namespace

std::vector<JointFault> joint_faults(std::span<const ScenePrimitive> primitives,
                                     std::span<const PrimitiveCoverage> coverage,
                                     const Scene& scene) {
  std::vector<JointFault> faults;
  for (const Chain& chain : Chains(primitives, coverage, scene.target).all()) {
    JointFault fault{primitives[chain.front()].index, primitives[chain.back()].index, "", {}};
    for (Snap snap : all_snaps()) {
      const std::string clause = broken_clause(chain, primitives, coverage, scene, snap);
      if (clause.empty()) continue;
      fault.illegal_snaps.push_back(name_of(snap));
      if (snap.is_none()) fault.clause = clause;
    }
    if (!fault.illegal_snaps.empty()) faults.push_back(std::move(fault));
  }
  return faults;
}

// ------------------------------------------------------------------------------------ shared edges

long hits_at(std::span<const PixelPosition> pixels, PixelPosition p) {
  const auto [first, last] = std::equal_range(
      pixels.begin(), pixels.end(), p,
      [](PixelPosition a, PixelPosition b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
  return last - first;
}

PixelBounds bounds_near(Point a, Point b, const PixelBounds& target) {
  const auto [x_low, x_high] = std::minmax(a.x, b.x);
  const auto [y_low, y_high] = std::minmax(a.y, b.y);
  const auto clip = [](std::int64_t value) {
    return static_cast<int>(
        std::clamp<std::int64_t>(value, -2 * Fixed::kMaxCoordinate, 2 * Fixed::kMaxCoordinate));
  };
  return common_part(target, {clip(x_low.floor() - 1), clip(y_low.floor() - 1),
                              clip(x_high.floor() + 1), clip(y_high.floor() + 1)});
}

std::map<int, Point> shared_samples(const ScenePrimitive& first, const ScenePrimitive& second,
                                    const Target& target, const SamplePositions& positions) {
  if (!is_multisampled(*first.state, target)) return {{0, centre_of_pixel()}};
  const std::uint32_t mask = first.state->multisampling.mask & second.state->multisampling.mask;
  std::map<int, Point> samples;
  for (std::size_t s = 0; s < positions.size(); ++s)
    if ((mask >> s & 1) != 0) samples.emplace(static_cast<int>(s), positions[s]);
  return samples;
}

namespace {

// Quotients are rounded to the nearest point; reach_of accounts for the error.
Triangle triangle_of(const ScenePrimitive& primitive) {
  return nearest_triangle(primitive.positions);
}

// The common edge of two triangles, whose ends must be bit-identical and not only close.
std::optional<SharedEdge> common_edge(const ScenePrimitive& first, const ScenePrimitive& second) {
  const Triangle one = triangle_of(first);
  const Triangle other = triangle_of(second);
  const auto edge = shared_edge(one, other);
  if (!edge) return std::nullopt;
  const auto vertex_at = [](const ScenePrimitive& primitive, const Triangle& triangle, Point p) {
    return primitive.vertices[static_cast<std::size_t>(
        std::find(triangle.begin(), triangle.end(), p) - triangle.begin())];
  };
  for (const Point end : {edge->a, edge->b})
    if (!is_bit_identical(*vertex_at(first, one, end), *vertex_at(second, other, end)))
      return std::nullopt;
  return edge;
}

// The common edge of two triangles, how far vertices may move, and the pixels near it.
struct SharedSide {
  SharedEdge edge;
  Fixed reach;
  PixelBounds near;
  bool is_multisampled = false;

  bool must_hit_once(Point sample) const { return edgecase::must_hit_once(edge, sample, reach); }
  bool is_clear(Point sample, Fixed more) const { return lies_between(edge, sample, reach + more); }
};

// Triangles by their edges, counter-clockwise.
using TrianglesByEdge = std::map<std::array<std::int64_t, 4>, std::vector<std::size_t>>;

std::array<std::int64_t, 4> key_of(Point from, Point to) {
  return {from.x.raw(), from.y.raw(), to.x.raw(), to.y.raw()};
}

// Facts about one primitive that do not depend on its partner.
struct Facts {
  bool may_be_culled = false;
  bool is_multisampled = false;
  Fixed reach;
  PixelBounds drawable;
};

Facts facts_of(const ScenePrimitive& primitive, const Scene& scene, int bits) {
  return {permitted_culling(primitive, bits).may_be_culled,
          is_multisampled(*primitive.state, scene.target), reach_of(primitive, bits),
          drawable_bounds(*primitive.state, scene.target)};
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> neighbours(
    std::span<const ScenePrimitive> primitives) {
  TrianglesByEdge before;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    // Clipped ones have seams of their own (diff/coverage/clipped_seams.h).
    if (primitives[i].kind != PrimitiveKind::triangle || primitives[i].is_clipped) continue;
    const Triangle given = triangle_of(primitives[i]);
    if (doubled_area(given) == 0) continue;
    const Triangle t = counter_clockwise(given);
    // Triangles on opposite sides of an edge run along it in opposite directions. Each is looked up
    // by one edge only, since both wind alike.
    for (std::size_t k = 0; k < 3; ++k) {
      const auto others = before.find(key_of(t[(k + 1) % 3], t[k]));
      if (others == before.end()) continue;
      for (const std::size_t other : others->second) pairs.emplace_back(other, i);
    }
    for (std::size_t k = 0; k < 3; ++k) before[key_of(t[k], t[(k + 1) % 3])].push_back(i);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<SharedEdgeFault> shared_edge_faults(std::span<const ScenePrimitive> primitives,
                                                std::span<const PrimitiveCoverage> coverage,
                                                const Scene& scene, int bits,
                                                const SamplePositions& positions,
                                                bool exact_has_none) {
  std::vector<SharedEdgeFault> faults;
  std::vector<std::optional<Facts>> known(primitives.size());
  const auto facts = [&](std::size_t i) -> const Facts& {
    if (!known[i]) known[i] = facts_of(primitives[i], scene, bits);
    return *known[i];
  };
  const auto is_as_exact = [&](std::size_t i) {
    const PrimitiveCoverage& own = coverage[static_cast<std::size_t>(primitives[i].index)];
    return own.drawn == own.exact;
  };
  for (const auto& [i, j] : neighbours(primitives)) {
    if (exact_has_none && is_as_exact(i) && is_as_exact(j)) continue;
    const Facts& one = facts(i);
    const Facts& other = facts(j);
    // Ruling 40 permits fragments of triangles that may be culled to be missing.
    if (one.may_be_culled || other.may_be_culled) continue;
    if (one.is_multisampled != other.is_multisampled) continue;
    const auto edge = common_edge(primitives[i], primitives[j]);
    if (!edge) continue;
    const SharedSide side{*edge, std::max(one.reach, other.reach),
                          bounds_near(edge->a, edge->b, common_part(one.drawable, other.drawable)),
                          one.is_multisampled};
    for (const auto& [sample, within] :
         shared_samples(primitives[i], primitives[j], scene.target, positions))
      add_seam_faults(side, primitives[i].index, primitives[j].index, sample, within, coverage,
                      faults);
  }
  const auto clipped =
      clipped_seam_faults(primitives, coverage, scene, bits, positions, exact_has_none);
  faults.insert(faults.end(), clipped.begin(), clipped.end());
  return faults;
}

}  // namespace edgecase
