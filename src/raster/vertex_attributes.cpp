// SPDX-License-Identifier: MIT
#include "raster/attributes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "exact/rational.h"
#include "rules/coverage/window.h"
#include "rules/values/inexact_interpolation.h"

namespace edgecase {
namespace {

// The quotient: a single point if it is a double, otherwise the interval around it.
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

// A vertex's window depth, 0 to 1. The default range needs no rational numbers.
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

// The same for z/w known as an interval.
Interval depth_in(const DepthRange& range, Interval z) {
  const Interval part = (z + 1) * 0.5;
  if (range == DepthRange()) return part;
  const auto near = static_cast<double>(range.near);
  return part * (Interval(static_cast<double>(range.far)) - near) + near;
}

std::size_t count_of(const ScenePrimitive& primitive) {
  return static_cast<std::size_t>(vertices_of(primitive.kind));
}

// Products by 1 and sums with 0 have no error (GL 4.6 core, 2.3.4.1).
bool is_number(Interval value, double number) {
  return value.low == number && value.high == number;
}
Interval inexact_quotient(Interval above, Interval below) {
  return is_number(below, 1) ? above : kInexact.divide(above, below);
}
Interval inexact_product(Interval a, Interval b) {
  return is_number(a, 1) ? b : is_number(b, 1) ? a : kInexact.multiply(a, b);
}
Interval inexact_sum(Interval a, Interval b) {
  return is_number(a, 0) ? b : is_number(b, 0) ? a : kInexact.add(a, b);
}

// Maps z/w onto the range: z/w times (far - near)/2, plus (near + far)/2 (13.8.1).
Interval inexact_depth_in(const DepthRange& range, Interval z) {
  const Interval near = static_cast<double>(range.near);
  const Interval far = static_cast<double>(range.far);
  const Interval scale = inexact_product(kInexact.subtract(far, near), 0.5);
  const Interval centre = inexact_product(inexact_sum(near, far), 0.5);
  return inexact_sum(inexact_product(z, range == DepthRange() ? Interval(0.5) : scale),
                     range == DepthRange() ? Interval(0.5) : centre);
}

// z and w as given to a renderer; for a vertex in window coordinates, z times w.
Interval clip_z(const Vertex& vertex) {
  if (vertex.clip) return static_cast<double>(vertex.clip->z);
  return vertex.z.to_double() * static_cast<double>(vertex.w);
}
Interval clip_w(const Vertex& vertex) {
  return static_cast<double>(vertex.clip ? vertex.clip->w : vertex.w);
}

// A vertex made by clipping has means of two numbers. Each product and the sum may err by a part of
// the larger number.
Interval made_of(Interval mean, double largest) {
  const double error = 3 * kInexact.relative * largest;
  return mean + Interval(-error, error);
}

double largest_of(const ScenePrimitive& primitive, Interval (*number)(const Vertex&)) {
  double largest = 0;
  for (std::size_t i = 0; i < count_of(primitive); ++i)
    largest = std::max(largest, number(*primitive.vertices[i]).magnitude());
  return largest;
}

// Sets the vertices' positions and their w.
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

// The visible ends of a clipped line are snapped as vertices are.
void place_ends(const CutLine& line, Interpolant& geometry) {
  for (std::size_t i = 0; i < 2; ++i) geometry.w[i] = line.w()[i];
}

// An interpolant without extent, all in one point.
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

// Depth and 1/w are not attributes: they are not interpolated with perspective.
Interpolant VertexAttributes::coordinate() const {
  Interpolant f = geometry_;
  if (f.kind == PrimitiveKind::point) f.w.fill(1);
  return f;
}

Interpolant VertexAttributes::depth() const {
  Interpolant f = coordinate();
  for (std::size_t i = 0; i < count_of(*primitive_); ++i)
    f.values[i] = plane_ ? depth_in(primitive_->depth_range, plane_->depths()[i])
                  : cut_ ? depth_in(primitive_->depth_range, cut_->depths()[i])
                         : depth_of(*primitive_->vertices[i], primitive_->depth_range);
  return f;
}

Interpolant VertexAttributes::inverse_w() const {
  Interpolant f = coordinate();
  for (std::size_t i = 0; i < count_of(*primitive_); ++i)
    f.values[i] =
        plane_ || cut_ ? Interval(1) / geometry_.w[i] : quotient(1, primitive_->vertices[i]->w);
  return f;
}

Interval VertexAttributes::permitted_w(std::size_t vertex) const {
  if (!plane_ && !cut_) return clip_w(*primitive_->vertices[vertex]);
  return made_of(geometry_.w[vertex], largest_of(*primitive_, clip_w));
}

// As for positions in the window (ruling 15), a vertex given in the window with w = 1 has no error:
// with the range 0 to 1, half of such a z and 1/2 add exactly in single precision.
Interpolant VertexAttributes::permitted_depth() const {
  Interpolant f = depth();
  for (std::size_t i = 0; i < count_of(*primitive_); ++i) {
    const Interval w = permitted_w(i);
    const bool is_given = !primitive_->vertices[i]->clip && is_number(w, 1);
    if (is_given && primitive_->depth_range == DepthRange()) continue;
    Interval z = clip_z(*primitive_->vertices[i]);
    if (plane_ || cut_)
      z = made_of((plane_ ? plane_->depths()[i] : cut_->depths()[i]) * geometry_.w[i],
                  largest_of(*primitive_, clip_z));
    f.values[i] = inexact_depth_in(primitive_->depth_range, inexact_quotient(z, w));
  }
  return f;
}

Interpolant VertexAttributes::permitted_inverse_w() const {
  Interpolant f = geometry_;
  for (std::size_t i = 0; i < count_of(*primitive_); ++i)
    f.values[i] = inexact_quotient(1, permitted_w(i));
  return f;
}

}  // namespace edgecase
