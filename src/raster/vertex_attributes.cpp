// SPDX-License-Identifier: MIT
#include "raster/vertex_attributes.h"

#include <cmath>
#include <cstddef>

#include "exact/rational.h"
#include "rules/coverage/row_order.h"

namespace edgecase {
namespace {

// The quotient, and nothing around it where it is a double itself.
Interval quotient(float numerator, float denominator) {
  const auto above = static_cast<double>(numerator);
  const auto below = static_cast<double>(denominator);
  const double nearest = above / below;
  if (std::fma(nearest, below, -above) == 0) return nearest;
  return Interval(above) / below;
}

// z/w, -1 to 1.
Rational divided_z(const Vertex& vertex) {
  if (!vertex.clip) return rational_of(vertex.z.to_double());
  return rational_of(vertex.clip->z) / rational_of(vertex.clip->w);
}

// A vertex's depth in the window, 0 to 1: where the range is that, without a rational number.
Interval depth_of(const Vertex& vertex, const DepthRange& range) {
  if (range != DepthRange()) {
    const Rational near = rational_of(range.near);
    return interval_of(
        Rational(near + (rational_of(range.far) - near) * (divided_z(vertex) + 1) / 2));
  }
  if (!vertex.clip) return (vertex.z.to_double() + 1) / 2;
  const Interval z = quotient(vertex.clip->z, vertex.clip->w);
  if (z.low == z.high && (z.low + 1) - 1 == z.low) return (z.low + 1) / 2;
  return (z + 1) * 0.5;
}

// The same of z/w, known to an interval.
Interval depth_in(const DepthRange& range, Interval z) {
  const Interval part = (z + 1) * 0.5;
  if (range == DepthRange()) return part;
  const auto near = static_cast<double>(range.near);
  return part * (Interval(static_cast<double>(range.far)) - near) + near;
}

std::size_t count_of(const ScenePrimitive& primitive) {
  return static_cast<std::size_t>(vertices_of(primitive.kind));
}

// Where the vertices are, and their w.
void place_vertices(const ScenePrimitive& primitive, const RuleChoices& choices,
                    const Target& target, Interpolant& geometry) {
  const bool snapped = choices.values.positions == AttributePositions::snapped;
  for (std::size_t i = 0; i < count_of(primitive); ++i) {
    geometry.positions[i] = snapped
                                ? snapped_position(primitive, i, choices.of(primitive.kind), target)
                                : primitive.positions[i];
    geometry.w[i] = static_cast<double>(primitive.vertices[i]->w);
  }
}

// The ends of what is seen of a line are snapped as vertices are.
void place_ends(const CutLine& line, Interpolant& geometry) {
  for (std::size_t i = 0; i < 2; ++i) geometry.w[i] = line.w()[i];
}

// Without extent: all in one point.
void place_nowhere(Interpolant& geometry) {
  geometry.positions.fill(HomogeneousPoint{});
  geometry.w.fill(1);
}

}  // namespace

HomogeneousPoint snapped_position(const ScenePrimitive& primitive, std::size_t vertex,
                                  const CoverageChoice& choice, const Target& target) {
  const HomogeneousPoint& given = primitive.positions[vertex];
  if (choice.snap.is_none() || primitive.is_clipped) return given;
  const bool turned = choice.rows == RowOrder::top_down;
  const Point snapped = choice.snap(turned ? turned_over(given, target.height) : given);
  return homogeneous(turned ? turned_over(snapped, target.height) : snapped);
}

VertexAttributes::VertexAttributes(const ScenePrimitive& primitive, const RuleChoices& choices,
                                   const Target& target)
    : primitive_(&primitive) {
  geometry_.kind = primitive.kind;
  geometry_.line_parameter = choices.values.line_parameter;
  geometry_.perspective = false;
  if (!primitive.is_clipped || primitive.kind != PrimitiveKind::triangle) {
    place_vertices(primitive, choices, target, geometry_);
    if (primitive.is_cut) cut_ = CutLine::of(primitive);
    if (cut_) place_ends(*cut_, geometry_);
    return;
  }
  plane_ = ClippedPlane::of(primitive);
  if (!plane_) {
    place_nowhere(geometry_);
    return;
  }
  geometry_.positions = plane_->positions();
  geometry_.w = plane_->w();
}

Interpolant VertexAttributes::with_values(const std::array<double, 3>& values,
                                          bool perspective) const {
  Interpolant f = geometry_;
  f.perspective = perspective;
  if (plane_)
    f.values = perspective ? plane_->smooth(values) : plane_->noperspective(values);
  else if (cut_)
    f.values = perspective ? cut_->smooth(values) : cut_->noperspective(values);
  else
    for (std::size_t i = 0; i < count_of(*primitive_); ++i) f.values[i] = values[i];
  return f;
}

Interpolant VertexAttributes::depth() const {
  Interpolant f = geometry_;
  for (std::size_t i = 0; i < count_of(*primitive_); ++i)
    f.values[i] = plane_ ? depth_in(primitive_->depth_range, plane_->depths()[i])
                  : cut_ ? depth_in(primitive_->depth_range, cut_->depths()[i])
                         : depth_of(*primitive_->vertices[i], primitive_->depth_range);
  return f;
}

Interpolant VertexAttributes::inverse_w() const {
  Interpolant f = geometry_;
  for (std::size_t i = 0; i < count_of(*primitive_); ++i)
    f.values[i] =
        plane_ || cut_ ? Interval(1) / geometry_.w[i] : quotient(1, primitive_->vertices[i]->w);
  return f;
}

}  // namespace edgecase
