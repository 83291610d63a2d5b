// SPDX-License-Identifier: MIT
//
// Refutation: which catalogued alternatives a renderer cannot follow.
#include "diff/coverage/refutation.h"
#include "diff/coverage/cause.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "diff/findings/patience.h"
#include "raster/coverage_stages.h"
#include "raster/rasterizer.h"
#include "rules/change_search.h"
#include "rules/choices.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

// Tests whether single changes of the choice draw what exact draws. Most answers agree, and are
// tested against all alternatives, so changes that cannot make a difference are not drawn, and
// those that differ at a line's ends are not drawn whole.
class SingleChanges {
 public:
  // `drawn` must be the drawing of the choice.
  SingleChanges(const CauseQuestion& question, const SampleCoverage& drawn)
      : question_(question), drawn_(drawn) {}

  bool draw_so(const CoverageChoice& changed) {
    if (moves_only_corners(changed)) return true;
    if (changed.snap != chosen().snap && decides_by_vertices()) return snapped_so(changed);
    if (only_ties_differ(changed)) return decides_ties_so(changed);
    if (only_edges_differ(changed) && meets_no_edge()) return true;
    return !differs_at_ends(changed) && covers_so(changed);
  }

 private:
  using Positions = std::array<Point, 3>;

  const CoverageChoice& chosen() const { return question_.chosen.of(question_.primitive.kind); }
  const ScenePrimitive& primitive() const { return question_.primitive; }

  bool covers_so(const CoverageChoice& choice) const {
    if (is_plain_triangle() && !has_clip_positions(primitive()) &&
        choice.rows == RowOrder::bottom_up) {
      if (is_culled(primitive(), question_.target, choice)) return drawn_[0].empty();
      return covers_just(drawn_[0], snapped(choice.snap),
                         drawable_bounds(*primitive().state, question_.target), choice);
    }
    return covered_samples(primitive(), question_.target, choice, question_.reported) == drawn_;
  }

  // True for pixels with one sample each and vertices at multiples of 2^-16 after snapping.
  bool is_plain() const {
    return question_.target.samples == 1 && !primitive().is_clipped &&
           !(chosen().snap.is_none() && has_clip_positions(primitive()));
  }

  // True if only corners are moved of a triangle whose samples are decided by its corners as given.
  bool moves_only_corners(const CoverageChoice& changed) const {
    return primitive().is_clipped && primitive().kind == PrimitiveKind::triangle &&
           chosen().clip == ClipMethod::homogeneous &&
           (changed.snap != chosen().snap ||
            changed.triangle_algorithm != chosen().triangle_algorithm);
  }

  // True if snapping decides nothing but the positions of vertices.
  bool decides_by_vertices() const {
    return question_.target.samples == 1 && !primitive().is_clipped &&
           !has_clip_positions(primitive()) && chosen().rows == RowOrder::bottom_up;
  }

  Positions snapped(Snap snap) const {
    const auto& p = primitive().positions;
    return {snap(p[0]), snap(p[1]), snap(p[2])};
  }

  // Grids that snap the vertices to the same points draw the same.
  bool snapped_so(const CoverageChoice& changed) {
    if (known_.empty()) known_.emplace_back(snapped(chosen().snap), true);
    const Positions positions = snapped(changed.snap);
    const auto found = std::find_if(known_.begin(), known_.end(),
                                    [&](const auto& known) { return known.first == positions; });
    if (found != known_.end()) return found->second;
    const bool draws_so = !differs_at_ends(changed) && covers_so(changed);
    return known_.emplace_back(positions, draws_so).second;
  }

  bool is_plain_triangle() const {
    return is_plain() && primitive().kind == PrimitiveKind::triangle &&
           chosen().triangle_algorithm == TriangleAlgorithm::edge_functions;
  }
  bool is_thin_line() const {
    return is_plain() && primitive().kind == PrimitiveKind::line &&
           primitive().state->line_width == Fixed::from_integer(1);
  }
  bool is_diamond_line() const {
    return is_thin_line() && chosen().line.algorithm == LineAlgorithm::diamond_exit;
  }

  // True if only samples on an edge, or diamonds that a line only touches, can differ. From the
  // other side a target looks the same except for these, if nothing is snapped or culled.
  bool only_ties_differ(const CoverageChoice& changed) const {
    const bool turns = changed.rows != chosen().rows;
    const bool seen_alike = chosen().snap.is_none() && primitive().state->cull == CullMode::none;
    if (is_plain_triangle())
      return changed.ties.name != chosen().ties.name || (turns && seen_alike);
    if (!is_diamond_line()) return false;
    return changed.line.boundary != chosen().line.boundary ||
           (turns && seen_alike && chosen().line.boundary->ties != nullptr);
  }

  // True if only samples on a triangle's edges can differ, whatever decides on them. Turned over, a
  // target that is not snapped looks the same but for these.
  bool only_edges_differ(const CoverageChoice& changed) const {
    if (primitive().kind != PrimitiveKind::triangle) return false;
    CoverageChoice same = changed;
    same.ties = chosen().ties;
    if (chosen().snap.is_none() && primitive().state->cull == CullMode::none &&
        !primitive().is_clipped && has_tie_rule(chosen().triangle_algorithm)) {
      same.rows = chosen().rows;
      same.polygon_rows = chosen().polygon_rows;
    }
    return same == chosen();
  }

  // True if no sample lies on an edge: the same is drawn without the edges and with all of them.
  // Any other rule of ties draws something between.
  bool meets_no_edge() {
    if (!meets_no_edge_) {
      CoverageChoice bare = chosen();
      bare.ties = open_ties();
      CoverageChoice full = chosen();
      full.ties = closed_ties();
      meets_no_edge_ = covers_so(bare) && covers_so(full);
    }
    return *meets_no_edge_;
  }

  bool decides_ties_so(const CoverageChoice& changed) {
    if (!tied_) tied_ = tied_pixels();
    if (tied_->empty()) return true;
    return primitive().kind == PrimitiveKind::line ? decides_diamonds_so(changed)
                                                   : decides_edges_so(changed);
  }

  // The vertices and the pixels as the choice sees them.
  Positions seen_vertices() const {
    const auto seen = [&](HomogeneousPoint p) {
      return chosen().snap(sees_turned() ? turned_over(p, question_.target.height) : p);
    };
    const auto& p = primitive().positions;
    return {seen(p[0]), seen(p[1]), seen(p[2])};
  }
  Segment seen_segment() const {
    const Positions p = seen_vertices();
    return {p[0], p[1]};
  }
  PixelBounds seen_bounds() const {
    const PixelBounds bounds = drawable_bounds(*primitive().state, question_.target);
    return sees_turned() ? turned_over(bounds, question_.target.height) : bounds;
  }
  bool sees_turned() const { return chosen().rows == RowOrder::top_down; }

  // The pixels at which ties are decided.
  Pixels tied_pixels() const {
    if (primitive().kind == PrimitiveKind::line)
      return tied_line_pixels(seen_segment(), seen_bounds());
    if (is_culled(primitive(), question_.target, chosen())) return {};
    return found_tied_pixels(seen_vertices(), seen_bounds());
  }

  bool decides_edges_so(const CoverageChoice& changed) const {
    const Triangle triangle = seen_vertices();
    const TieRule ties = changed.rows != chosen().rows ? turned_over(changed.ties) : changed.ties;
    return std::all_of(tied_->begin(), tied_->end(), [&](PixelPosition p) {
      return triangle_covers(triangle, p.x, p.y, ties) ==
             triangle_covers(triangle, p.x, p.y, chosen().ties);
    });
  }

  bool decides_diamonds_so(const CoverageChoice& changed) const {
    const Segment segment = seen_segment();
    DiamondBoundary boundary = *changed.line.boundary;
    TieRule turned;
    if (changed.rows != chosen().rows) {
      turned = turned_over(*boundary.ties);
      boundary.ties = &turned;
    }
    return std::all_of(tied_->begin(), tied_->end(), [&](PixelPosition p) {
      return diamond_exit_covers(segment, p.x, p.y, boundary) ==
             diamond_exit_covers(segment, p.x, p.y, *chosen().line.boundary);
    });
  }

  // True if a line that is an area is drawn differently near one of its ends, where most differ
  // first. False means unknown: other differences are found sooner in the whole line.
  bool differs_at_ends(const CoverageChoice& changed) const {
    constexpr std::size_t kLong = 8;
    if (!is_thin_line() || drawn_[0].size() < kLong) return false;
    if (!fills_area(changed.line, primitive().state->line_width)) return false;
    const PixelBounds all = drawable_bounds(*primitive().state, question_.target);
    return std::any_of(
        primitive().positions.begin(), primitive().positions.begin() + 2,
        [&](const HomogeneousPoint& end) {
          const Point near = nearest_point(end);
          const auto x = static_cast<int>(near.x.floor()), y = static_cast<int>(near.y.floor());
          const PixelBounds box = common_part({x - 1, y - 1, x + 1, y + 1}, all);
          Pixels drawn;
          std::copy_if(drawn_[0].begin(), drawn_[0].end(), std::back_inserter(drawn),
                       [&](PixelPosition p) { return box.contains(p); });
          return covered_pixels_within(box, primitive(), question_.target, changed) != drawn;
        });
  }

  const CauseQuestion& question_;
  const SampleCoverage& drawn_;
  std::vector<std::pair<Positions, bool>> known_;
  std::optional<Pixels> tied_;
  std::optional<bool> meets_no_edge_;
};

// An alternative, and the choice for a kind of primitive with it.
struct SingleChange {
  AlternativeId id;
  CoverageChoice choice;
};

// What decides, under every choice, which pixels are covered by a primitive in front of the eye
// that is not clipped, on a target of one sample a pixel.
struct PlainShape {
  std::array<HomogeneousPoint, 3> positions;
  Fixed line_width;
  Fixed point_size;
  std::optional<Viewport> scissor;
  std::optional<Viewport> viewport;  // of points
  bool is_on_border;
  FrontFace front_face;
  CullMode cull;
  int width;
  int height;
  Surface surface;
  friend bool operator==(const PlainShape&, const PlainShape&) = default;
};

std::optional<PlainShape> plain_shape(const ScenePrimitive& primitive, const Target& target) {
  if (target.samples > 1 || primitive.is_clipped || has_clip_positions(primitive)) return {};
  const Draw& draw = *primitive.state;
  PlainShape shape{primitive.positions,
                   draw.line_width,
                   draw.point_size,
                   draw.scissor,
                   {},
                   false,
                   draw.front_face,
                   draw.cull,
                   target.width,
                   target.height,
                   target.surface};
  if (primitive.kind == PrimitiveKind::point) {
    shape.viewport = primitive.viewport;
    shape.is_on_border = is_on_border(primitive);
  }
  return shape;
}

// Whether each of a list of changes draws a shape as exact does; unknown until it is asked.
struct KnownShape {
  PlainShape shape;
  std::vector<std::optional<bool>> draw_so;
};

// The alternatives of every rule that affects a primitive's coverage, and what they draw of the
// latest shapes: the cases of a sweep draw a primitive again in other states.
struct SingleChangeList {
  static constexpr std::size_t kMostShapes = 16;

  CoverageTraits traits;
  std::array<CoverageChoice, 3> chosen;  // all that a rule with a say in coverage is kept in
  std::vector<SingleChange> changes;
  std::deque<KnownShape> shapes;

  KnownShape& known(const PlainShape& shape) {
    const auto found = std::ranges::find(shapes, shape, &KnownShape::shape);
    if (found != shapes.end()) return *found;
    if (shapes.size() == kMostShapes) shapes.pop_front();
    shapes.push_back({shape, std::vector<std::optional<bool>>(changes.size())});
    return shapes.back();
  }
};

// They follow from its traits and the policy's choices of coverage, and are found by names: the
// latest are kept.
SingleChangeList& single_changes(const CoverageTraits& traits, const RuleChoices& chosen) {
  constexpr std::size_t kMostKnown = 64;
  thread_local std::vector<SingleChangeList> all_known;
  const std::array<CoverageChoice, 3> choices{chosen.points, chosen.lines, chosen.triangles};
  for (SingleChangeList& known : all_known)
    if (known.traits == traits && known.chosen == choices) return known;
  if (all_known.size() >= kMostKnown) all_known.clear();
  SingleChangeList& known = all_known.emplace_back(SingleChangeList{traits, choices, {}, {}});
  for (const Change& change : joined(coverage_changes(traits, chosen)))
    known.changes.push_back({change.id, change.applied_to(chosen).of(traits.kind)});
  return known;
}

}  // namespace

// Several changes may share a name, as all swapped pairs of samples do: the name is refuted only if
// none of them draws so.
void mark_refuted(const CauseQuestion& question, const PrimitiveCoverage& coverage,
                  AlternativeSet& refuted) {
  AlternativeSet draw_so, draw_otherwise;
  SingleChanges drawings(question, coverage.drawn);
  const CoverageTraits traits = coverage_traits(question.primitive, question.target);
  SingleChangeList& list = single_changes(traits, question.chosen);
  const auto shape = plain_shape(question.primitive, question.target);
  KnownShape* const known = shape ? &list.known(*shape) : nullptr;
  for (std::size_t i = 0; i < list.changes.size(); ++i) {
    Patience::check();
    const auto& [id, choice] = list.changes[i];
    if (refuted.contains(id) || draw_so.contains(id)) continue;
    std::optional<bool> unknown;
    std::optional<bool>& draws_so = known != nullptr ? known->draw_so[i] : unknown;
    if (!draws_so) draws_so = drawings.draw_so(choice);
    (*draws_so ? draw_so : draw_otherwise).add(id);
  }
  draw_otherwise.for_each([&](AlternativeId id) {
    if (!draw_so.contains(id)) refuted.add(id);
  });
}

}  // namespace edgecase
