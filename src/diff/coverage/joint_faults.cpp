// SPDX-License-Identifier: MIT
#include "diff/coverage/joint_faults.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "diff/coverage/vertex_latitude.h"
#include "raster/rasterizer.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_joints.h"
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

}  // namespace edgecase
