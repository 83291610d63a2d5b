// SPDX-License-Identifier: MIT
//
// The exact rasterizer's coverage stage: the pixels and samples of one primitive.
#include <algorithm>

#include "model/side_clipping.h"
#include "raster/coverage_stages.h"
#include "raster/rasterizer.h"
#include "rules/coverage/homogeneous_line.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/line_areas.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/samples/multisampled_line.h"
#include "rules/samples/rounded_rectangle.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

// A part of the target, and how coverage is decided there.
struct View {
  PixelBounds bounds;
  Point within = centre_of_pixel();  // the point of each pixel that decides
  // Whether samples decide; lines are then areas.
  bool is_multisampled = false;
};

// How a primitive's vertices are represented: as multiples of 2^-16, or as quotients.
struct Dyadic {
  using Vertex = Point;
  using Sized = SizedPoint;
  using Line = Segment;
};
struct Quotient {
  using Vertex = HomogeneousPoint;
  using Sized = HomogeneousSizedPoint;
  using Line = HomogeneousSegment;
};

Point nearest(Point vertex) {
  return vertex;
}
Point nearest(const HomogeneousPoint& vertex) {
  return nearest_point(vertex);
}

// The same for a line.
Segment centred(const Segment& line, Point within) {
  return {centred(line.a, within), centred(line.b, within)};
}

// All pixels that may have a point inside a point primitive's square, and some around them.
PixelBounds bounds_near(Point vertex, Fixed size, const PixelBounds& all) {
  const std::int64_t margin = size.ceil() / 2 + 1;
  const auto low = [&](int bound, Fixed at) {
    return static_cast<int>(std::max<std::int64_t>(bound, at.floor() - margin));
  };
  const auto high = [&](int bound, Fixed at) {
    return static_cast<int>(std::min<std::int64_t>(bound, at.floor() + margin));
  };
  return {low(all.x_min, vertex.x), low(all.y_min, vertex.y), high(all.x_max, vertex.x),
          high(all.y_max, vertex.y)};
}

template <class Sized>
Pixels point_pixels(const Sized& point, const View& view, const TieRule& ties) {
  const PixelBounds near = bounds_near(nearest(point.vertex), point.size, view.bounds);
  Pixels pixels;
  for (int y = near.y_min; y <= near.y_max; ++y)
    for (int x = near.x_min; x <= near.x_max; ++x)
      if (point_covers(point, place_in({x, y}, view.within), ties)) pixels.push_back({x, y});
  return pixels;
}

Pixels area_pixels(const Segment& line, Fixed width, LineArea area, const View& view,
                   const TieRule& ties) {
  return line_area_pixels(centred(line, view.within), width, area, view.bounds, ties);
}

// The pixels of a multisampled line, which is an area.
Pixels multisampled_pixels(const Segment& line, Fixed width, const View& view,
                           const CoverageChoice& choice) {
  const auto rounded = [&](RectangleRounding rounding) {
    return rounded_rectangle_pixels(line, width, rounding, view.bounds, view.within, choice.ties);
  };
  switch (choice.multisampled_line) {
    case MultisampledLine::rectangle:
      return area_pixels(line, width, LineArea::rectangle, view, choice.ties);
    case MultisampledLine::snapped_offset_across_borders:
      if (line.a == line.b ||
          !crosses_borders(rounded_corners(line, width, RectangleRounding::offset), view.bounds))
        return {};
      [[fallthrough]];
    case MultisampledLine::snapped_offset:
      return rounded(RectangleRounding::offset);
    case MultisampledLine::snapped_corners:
      return rounded(RectangleRounding::corners);
    case MultisampledLine::parallelogram:
    case MultisampledLine::single_sampled:
      break;
  }
  return area_pixels(line, width, LineArea::parallelogram, view, choice.ties);
}
// Algorithms other than the rectangle take the segment rounded to the grid.
Pixels multisampled_pixels(const HomogeneousSegment& line, Fixed width, const View& view,
                           const CoverageChoice& choice) {
  if (choice.multisampled_line == MultisampledLine::rectangle)
    return multisampled_line_pixels(line, width, view.bounds, view.within, choice.ties);
  return multisampled_pixels(nearest_segment(line), width, view, choice);
}

Pixels triangle_pixels_of(const Triangle& p, const View& view, const CoverageChoice& choice) {
  return found_triangle_pixels(
      {centred(p[0], view.within), centred(p[1], view.within), centred(p[2], view.within)},
      view.bounds, choice);
}
Pixels triangle_pixels_of(const HomogeneousTriangle& p, const View& view,
                          const CoverageChoice& choice) {
  return triangle_pixels(p, view.bounds, choice.triangle_algorithm, choice.ties, view.within);
}

Pixels line_pixels_of(const Segment& line, Fixed width, const PixelBounds& bounds,
                      const CoverageChoice& choice) {
  return found_line_pixels(line, width, bounds, choice);
}
Pixels line_pixels_of(const HomogeneousSegment& line, Fixed width, const PixelBounds& bounds,
                      const CoverageChoice& choice) {
  return line_pixels(line, width, bounds, choice.line, choice.ties);
}

// The pixels, in no particular order, of a primitive whose vertices are already snapped.
template <class Kind>
Pixels pixels_of(const ScenePrimitive& primitive, const std::array<typename Kind::Vertex, 3>& p,
                 const View& view, const CoverageChoice& choice) {
  const Draw& state = *primitive.state;
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return point_pixels(typename Kind::Sized{moved(p[0], choice.point_offset), state.point_size},
                          view, choice.ties);
    case PrimitiveKind::line: {
      const typename Kind::Line line{p[0], p[1]};
      if (view.is_multisampled) return multisampled_pixels(line, state.line_width, view, choice);
      return line_pixels_of(line, state.line_width, view.bounds, choice);
    }
    case PrimitiveKind::triangle:
      return triangle_pixels_of(p, view, choice);
  }
  return {};
}

// How vertices are snapped. Rounded rectangles of lines have a grid of their own.
Snap snap_of(const ScenePrimitive& primitive, const View& view, const CoverageChoice& choice) {
  const MultisampledLine line = choice.multisampled_line;
  const bool rounded = line == MultisampledLine::snapped_offset ||
                       line == MultisampledLine::snapped_offset_across_borders ||
                       line == MultisampledLine::snapped_corners;
  if (primitive.kind == PrimitiveKind::line && view.is_multisampled && rounded) return {};
  return choice.snap;
}

// The pixels of a primitive whose vertices the choice has yet to snap. Quotients that are not
// snapped stay quotients.
Pixels snapped_pixels(const ScenePrimitive& primitive, const std::array<HomogeneousPoint, 3>& given,
                      const View& view, const CoverageChoice& choice) {
  const Snap snap = snap_of(primitive, view, choice);
  if (snap.is_none() && has_clip_positions(primitive))
    return pixels_of<Quotient>(primitive, given, view, choice);
  return pixels_of<Dyadic>(primitive, {snap(given[0]), snap(given[1]), snap(given[2])}, view,
                           choice);
}

// The pixels of a primitive with vertices outside the clip volume. A point has just one vertex.
Pixels clipped_pixels_of(const ScenePrimitive& primitive,
                         const std::array<HomogeneousPoint, 3>& positions, const Viewport& viewport,
                         const View& view, const CoverageChoice& choice) {
  if (primitive.kind != PrimitiveKind::triangle) return {};
  return clipped_pixels({{positions, primitive.z}, viewport}, view.bounds, view.within, choice);
}

// Whether the choice has a point or a line clipped as its API does not.
bool is_clipped_otherwise(const ScenePrimitive& primitive, const CoverageChoice& choice) {
  const bool is_chosen =
      primitive.kind == PrimitiveKind::point
          ? choice.point_clip == PointClip::of_other_api
          : primitive.kind == PrimitiveKind::line && choice.line_clip == LineClip::of_other_api;
  return is_chosen && leaves_sides(primitive);
}

// The primitive, clipped as the choice has it; as its API does where the other is not exact.
ScenePrimitive clipped_by(const ScenePrimitive& primitive, const CoverageChoice& choice) {
  if (!is_clipped_otherwise(primitive, choice)) return primitive;
  return of_other_api(primitive).value_or(primitive);
}

// The same, sorted, with the target turned as the choice's row order says.
Pixels viewed_pixels(const ScenePrimitive& given, const Target& target, CoverageChoice choice,
                     View view) {
  const ScenePrimitive primitive = clipped_by(given, choice);
  const bool turned = choice.rows == RowOrder::top_down;
  if (primitive.kind == PrimitiveKind::line && choice.rows != choice.polygon_rows)
    choice.ties = turned_over(choice.ties);
  auto p = primitive.positions;
  Viewport viewport = primitive.viewport;
  if (turned) {
    viewport.y = target.height - viewport.y - viewport.height;
    view.bounds = turned_over(view.bounds, target.height);
    view.within.y = Fixed::from_integer(1) - view.within.y;
    for (HomogeneousPoint& point : p) point = turned_over(point, target.height);
  }
  if (primitive.kind == PrimitiveKind::point) {
    if (choice.point_clip == PointClip::border_dropped && is_on_border(primitive)) return {};
    if (choice.point_clip == PointClip::cut_at_viewport)
      view.bounds = common_part(view.bounds, pixels_in(viewport));
  }
  Pixels pixels = primitive.is_clipped ? clipped_pixels_of(primitive, p, viewport, view, choice)
                                       : snapped_pixels(primitive, p, view, choice);
  if (turned)
    for (PixelPosition& pixel : pixels) pixel.y = target.height - 1 - pixel.y;
  sort_by_rows(pixels);
  return pixels;
}

// Whether the choice builds a wide line from copies of its fragments.
bool has_columns(const ScenePrimitive& given, const Target& target, const CoverageChoice& choice) {
  const ScenePrimitive primitive = clipped_by(given, choice);
  const Draw& draw = *primitive.state;
  return primitive.kind == PrimitiveKind::line && !primitive.is_clipped &&
         !is_multisampled(draw, target) && rounded_width(draw.line_width) > 1 &&
         choice.line.wide == WideLine::replicate;
}

// Whether the line is x-major once the choice has turned the target.
bool is_x_major(const ScenePrimitive& given, const Target& target, const CoverageChoice& choice) {
  const ScenePrimitive line = clipped_by(given, choice);
  HomogeneousSegment ends{line.positions[0], line.positions[1]};
  if (choice.rows == RowOrder::top_down)
    ends = {turned_over(ends.a, target.height), turned_over(ends.b, target.height)};
  if (choice.snap.is_none() && has_clip_positions(line)) return ends.x_major();
  return Segment{choice.snap(ends.a), choice.snap(ends.b)}.x_major();
}

}  // namespace

PixelBounds drawable_bounds(const Draw& draw, const Target& target) {
  const PixelBounds bounds{0, 0, target.width - 1, target.height - 1};
  if (!draw.scissor) return bounds;
  return common_part(bounds, pixels_in(*draw.scissor));
}

std::vector<PixelPosition> covered_pixels(const ScenePrimitive& primitive, const Target& target,
                                          const CoverageChoice& choice) {
  return covered_pixels_within(drawable_bounds(*primitive.state, target), primitive, target,
                               choice);
}

std::vector<PixelPosition> covered_pixels_within(const PixelBounds& part,
                                                 const ScenePrimitive& primitive,
                                                 const Target& target,
                                                 const CoverageChoice& choice) {
  if (is_culled(primitive, target, choice)) return {};
  return viewed_pixels(primitive, target, choice,
                       {common_part(part, drawable_bounds(*primitive.state, target))});
}

Point attribute_place(const ScenePrimitive& primitive, const Target& target,
                      const CoverageChoice& choice, PixelPosition pixel) {
  const Point centre = pixel_centre(pixel.x, pixel.y);
  if (!has_columns(primitive, target, choice)) return centre;
  const bool x_major = is_x_major(primitive, target, choice);
  const auto above = [&](int pixels) {
    return x_major ? PixelPosition{pixel.x, pixel.y + pixels}
                   : PixelPosition{pixel.x + pixels, pixel.y};
  };
  // The column continues beyond the border of the target or of the scissor rectangle.
  const int others = rounded_width(primitive.state->line_width) - 1;
  const PixelPosition low = above(-others), high = above(others);
  const Pixels near = viewed_pixels(primitive, target, choice, {{low.x, low.y, high.x, high.y}});
  const auto is_drawn = [&](int pixels) {
    return std::find(near.begin(), near.end(), above(pixels)) != near.end();
  };
  if (!is_drawn(0)) return centre;
  int below = 0;
  while (below < others && is_drawn(-below - 1)) ++below;
  const Fixed to_middle = Fixed::from_raw((others - 2 * below) * Fixed::kOne / 2);
  return x_major ? Point{centre.x, centre.y + to_middle} : Point{centre.x + to_middle, centre.y};
}

SamplePositions positions_of(const Target& target, const CoverageChoice& choice,
                             const SamplePositions& reported) {
  if (target.samples == 1) return {centre_of_pixel()};
  const auto is_whole = [&](const SamplePositions& positions) {
    return positions.size() == static_cast<std::size_t>(target.samples);
  };
  if (is_whole(reported)) return placed(choice.placement, reported);
  if (is_whole(target.sample_positions)) return placed(choice.placement, target.sample_positions);
  return placed(choice.placement, standard_pattern(target.samples));
}

Unsampled sampling_of(const ScenePrimitive& primitive, const Target& target,
                      const CoverageChoice& choice) {
  if (target.samples == 1) return Unsampled::by_centre;
  if (primitive.state->multisampling.enabled) return Unsampled::by_each_sample;
  return unsampled(primitive.kind, choice.multisample_switch);
}

SampleCoverage covered_samples(const ScenePrimitive& primitive, const Target& target,
                               const CoverageChoice& choice, const SamplePositions& reported) {
  const Draw& draw = *primitive.state;
  SampleCoverage coverage(static_cast<std::size_t>(target.samples));
  if (is_culled(primitive, target, choice)) return coverage;
  const Unsampled sampling = sampling_of(primitive, target, choice);
  if (sampling == Unsampled::by_centre) {
    coverage[0] = covered_pixels(primitive, target, choice);
    return coverage;
  }
  const bool whole_pixels = sampling == Unsampled::whole_pixels ||
                            (primitive.kind == PrimitiveKind::line &&
                             choice.multisampled_line == MultisampledLine::single_sampled);
  const std::uint32_t writable =
      writable_samples(draw.multisampling, target.samples, choice.sample_mask);
  const SamplePositions positions = positions_of(target, choice, reported);
  for (std::size_t s = 0; s < coverage.size(); ++s) {
    if ((writable >> s & 1) == 0) continue;
    coverage[s] = whole_pixels ? covered_pixels(primitive, target, choice)
                               : viewed_pixels(primitive, target, choice,
                                               {drawable_bounds(draw, target), positions[s], true});
  }
  return coverage;
}

}  // namespace edgecase
