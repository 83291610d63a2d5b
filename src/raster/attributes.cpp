// SPDX-License-Identifier: MIT
#include "raster/attributes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "raster/texture_stage.h"
#include "rules/values/attributes.h"
#include "rules/values/framebuffer.h"
#include "rules/values/interpolation.h"
#include "rules/values/rational_interpolation.h"

namespace edgecase {
namespace {

// Component c of a vertex's attribute: its colour, or texture coordinates as (s, t, 0, 1).
double component_of(const Vertex& vertex, std::size_t c, bool textured) {
  if (!textured) return static_cast<double>(vertex.color[c]);
  return c < 2 ? static_cast<double>(vertex.texture_coordinates[c]) : c == 2 ? 0 : 1;
}

// Component c at all three vertices; a flat colour has the provoking vertex's value at each.
std::array<double, 3> component_values(const ScenePrimitive& primitive, const ValueChoice& choice,
                                       std::size_t c) {
  const Draw& draw = *primitive.state;
  const Vertex* provoking = draw.interpolation == Interpolation::flat
                                ? primitive.vertices[provoking_index(primitive, choice.provoking)]
                                : nullptr;
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(primitive.kind)); ++i)
    values[i] =
        component_of(provoking ? *provoking : *primitive.vertices[i], c, draw.texture.has_value());
  return values;
}

bool has_polygon_offset(const ScenePrimitive& primitive) {
  return primitive.kind == PrimitiveKind::triangle && primitive.state->polygon_offset.has_value();
}

// The weights of a mean add up to 1, so an offset of every value is an offset of every mean.
Interpolant plus(Interpolant depth, Interval offset) {
  for (Interval& value : depth.values) value = value + offset;
  return depth;
}

PrimitiveAttributes attributes_at(const VertexAttributes& vertices, const ScenePrimitive& primitive,
                                  const RuleChoices& choices, const Target& target) {
  const Draw& draw = *primitive.state;
  const bool perspective = divides_by_w(draw.interpolation, choices.values.perspective);
  PrimitiveAttributes result;
  for (std::size_t c = 0; c < 4; ++c)
    result.color[c] =
        vertices.with_values(component_values(primitive, choices.values, c), perspective);
  result.w_of_centre = choices.values.perspective == PerspectiveChoice::w_of_centre;
  result.depth = vertices.depth();
  result.clamps_depth = has_polygon_offset(primitive);
  if (result.clamps_depth)
    result.depth = plus(result.depth, offset_exact(*draw.polygon_offset, result.depth, target.depth,
                                                   choices.values.offset));
  result.inverse_w = vertices.inverse_w();
  return result;
}

}  // namespace

QuadPixel quad_of(PixelPosition pixel, const ValueChoice& choice, const Target& target) {
  return in_quad(pixel, choice.quad_rows, target.height);
}

PrimitiveAttributes attributes_of(const ScenePrimitive& primitive, const RuleChoices& choices,
                                  const Target& target) {
  return attributes_at({primitive, choices, target}, primitive, choices, target);
}

bool are_constant(const PrimitiveAttributes& attributes) {
  return is_constant(attributes.depth) && std::ranges::all_of(attributes.color, is_constant);
}

Interpolant depth_without_offset(const ScenePrimitive& primitive, const RuleChoices& choices,
                                 const Target& target) {
  return VertexAttributes(primitive, choices, target).depth();
}

PermittedAttributes permitted_attributes_of(const ScenePrimitive& primitive,
                                            const RuleChoices& choices, const Target& target,
                                            double reach, Interval fixed_unit) {
  const VertexAttributes vertices(primitive, choices, target);
  PermittedAttributes result{attributes_at(vertices, primitive, choices, target),
                             vertices.permitted_depth(), vertices.permitted_inverse_w()};
  if (has_polygon_offset(primitive))
    result.depth =
        plus(result.depth, offset_permitted(*primitive.state->polygon_offset, vertices.depth(),
                                            target.depth, reach, fixed_unit));
  return result;
}

Interval clamped_depth(const PrimitiveAttributes& attributes, Interval interpolated) {
  if (!attributes.clamps_depth) return interpolated;
  return {std::clamp(interpolated.low, 0.0, 1.0), std::clamp(interpolated.high, 0.0, 1.0)};
}

Interval depth_exact(const PrimitiveAttributes& attributes, Point place) {
  return clamped_depth(attributes, interpolate_exact(attributes.depth, place));
}

Interval color_exact(const PrimitiveAttributes& attributes, std::size_t component, Point place,
                     PixelPosition pixel) {
  const Point w_place = attributes.w_of_centre ? pixel_centre(pixel.x, pixel.y) : place;
  return interpolate_exact(attributes.color[component], place, w_place);
}

Interval color_inexact(const PrimitiveAttributes& attributes, std::size_t component, Point place,
                       PixelPosition pixel) {
  const Point w_place = attributes.w_of_centre ? pixel_centre(pixel.x, pixel.y) : place;
  return interpolate_inexact(attributes.color[component], place, w_place);
}

double middle(Interval value) {
  const bool about_zero =
      value.contains(0) && std::isfinite(value.low) && std::isfinite(value.high);
  if (about_zero) return 0;
  // Of two neighbours, take the odd one: a double halfway between two float32 numbers is even, and
  // the odd double beside it rounds to the same float32 number as the value itself.
  if (next_above(value.low) == value.high)
    return (std::bit_cast<std::uint64_t>(value.low) & 1) != 0 ? value.low : value.high;
  return value.low / 2 + value.high / 2;
}

Fragment fragment_at(const ScenePrimitive& primitive, PixelPosition pixel, Interval depth) {
  Fragment fragment;
  fragment.x = pixel.x;
  fragment.y = pixel.y;
  fragment.primitive = primitive.index;
  fragment.depth = middle(depth);
  return fragment;
}

Fragment shade(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
               PixelPosition pixel, const ShadingPlaces& places) {
  Fragment fragment = fragment_at(primitive, pixel, depth_exact(attributes, places.depth));
  for (std::size_t c = 0; c < 4; ++c)
    fragment.color[c] = middle(color_exact(attributes, c, places.color, pixel));
  return fragment;
}

Fragment shade(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
               PixelPosition pixel, const ExactLookup* lookup) {
  const ExactPlace centre(pixel_centre(pixel.x, pixel.y));
  Fragment fragment =
      fragment_at(primitive, pixel, clamped_depth(attributes, centre.value(attributes.depth)));
  for (std::size_t c = 0; c < 4; ++c)
    fragment.color[c] = middle(lookup ? lookup->color[c] : centre.value(attributes.color[c]));
  return fragment;
}

std::array<double, 4> coordinates_at(const PrimitiveAttributes& attributes,
                                     const ShadingPlaces& places) {
  return {places.coordinates.x.to_double(), places.coordinates.y.to_double(),
          middle(depth_exact(attributes, places.depth)),
          middle(interpolate_exact(attributes.inverse_w, places.coordinates))};
}

FragmentDetail shade_details(const PrimitiveAttributes& attributes, CentreColors& colors,
                             const QuadPixel& at, const ValueChoice& choice, const Details& asked,
                             const ExactLookup* lookup) {
  const Point sample = pixel_centre(at.pixel.x, at.pixel.y);
  FragmentDetail detail;
  if (asked.coordinates) detail.coordinates = coordinates_at(attributes, {sample, sample, sample});
  if (asked.texture && lookup) {
    detail.texture_coordinates = {middle(lookup->coordinates[0]), middle(lookup->coordinates[1])};
    detail.level_of_detail = {middle(lookup->queried[0]), middle(lookup->queried[1])};
  }
  if (!asked.derivatives) return detail;
  for (std::size_t d = 0; d < kDerivatives; ++d) {
    const auto derivative = static_cast<Derivative>(d);
    const DerivativeMethod method = choice.derivatives[form_of(derivative)];
    // The order is: along x, then along y, for each method in turn.
    if (d >= 2 && method == choice.derivatives[0]) {
      detail.derivatives[d] = detail.derivatives[d % 2];
      continue;
    }
    detail.derivatives[d] = colors.derivatives(at, axis_of(derivative), method).middles;
  }
  return detail;
}

bool are_details_constant(const PrimitiveAttributes& attributes, const Details& asked,
                          bool has_lookup) {
  if (asked.coordinates || (asked.texture && has_lookup)) return false;
  return !asked.derivatives || std::ranges::all_of(attributes.color, is_linear);
}

namespace {

constexpr std::size_t kRows = 4;  // the two rows of a quad and those beside it
constexpr std::size_t kMostColumns = 4096;

void take_middles(CentreColors::Derivatives& derivatives) {
  std::ranges::transform(derivatives.exact, derivatives.middles.begin(), middle);
}

}  // namespace

CentreColors::CentreColors(int width)
    : columns_(std::min(std::bit_ceil(static_cast<std::size_t>(width)), kMostColumns)) {}

void CentreColors::take(const std::array<Interpolant, 4>& components) {
  components_ = &components;
  std::ranges::transform(components, are_linear_.begin(), is_linear);
  for (const Axis axis : {Axis::x, Axis::y}) {
    Derivatives& slopes = slopes_[static_cast<std::size_t>(axis)];
    for (std::size_t c = 0; c < components.size(); ++c)
      if (are_linear_[c]) slopes.exact[c] = differentiate_exact(components[c], Point{}, axis);
    take_middles(slopes);
  }
  ++primitive_;
}

// The neighbours of pixels at the target's edges lie outside it.
std::size_t CentreColors::place_of(PixelPosition pixel) const {
  const std::size_t column = static_cast<std::size_t>(pixel.x) % columns_;
  const std::size_t row = static_cast<std::size_t>(pixel.y) % kRows;
  return row * columns_ + column;
}

bool CentreColors::is_known(PixelPosition pixel) const {
  const AtPixel& known = known_[place_of(pixel)];
  return known.primitive == primitive_ && known.pixel == pixel;
}

// Where the pixel to the left was asked for, those to the right will be.
std::size_t CentreColors::run_from(PixelPosition pixel) const {
  const bool is_inside = pixel.x > 0 && static_cast<std::size_t>(pixel.x) < columns_;
  if (!is_inside || !is_known({pixel.x - 1, pixel.y})) return 1;
  return std::min(ExactRun::kLongest, columns_ - static_cast<std::size_t>(pixel.x));
}

const CentreColors::Components& CentreColors::at(PixelPosition pixel) {
  if (known_.empty()) known_.resize(kRows * columns_);
  AtPixel* const known = &known_[place_of(pixel)];
  if (is_known(pixel)) return known->values;
  const std::size_t count = run_from(pixel);
  for (std::size_t i = 0; i < count; ++i) {
    known[i].primitive = primitive_;
    known[i].pixel = {pixel.x + static_cast<int>(i), pixel.y};
  }
  ExactRun run(pixel, count);
  std::array<Interval, ExactRun::kLongest> values;
  for (std::size_t c = 0; c < components_->size(); ++c) {
    LazyRational rational;
    run.values((*components_)[c], rational, values);
    for (std::size_t i = 0; i < count; ++i) known[i].values[c] = values[i];
  }
  return known->values;
}

CentreColors::Components CentreColors::difference(const Neighbours& of, Axis axis) {
  // This is a copy because in a narrow target both neighbours may be kept in one entry.
  const Components first = at(of.first);
  const Components& second = at(of.second);
  Components result = slopes_[static_cast<std::size_t>(axis)].exact;
  for (std::size_t c = 0; c < result.size(); ++c)
    if (!are_linear_[c]) result[c] = second[c] - first[c];
  return result;
}

const CentreColors::Derivatives& CentreColors::derivatives(const QuadPixel& pixel, Axis axis,
                                                           DerivativeMethod method) {
  if (std::ranges::all_of(are_linear_, std::identity()))
    return slopes_[static_cast<std::size_t>(axis)];
  if (method == DerivativeMethod::analytic) {
    std::ranges::transform(*components_, analytic_.exact.begin(), [&](const Interpolant& f) {
      return derivative_exact(f, pixel, axis, method);
    });
    take_middles(analytic_);
    return analytic_;
  }
  std::vector<AtNeighbours>& differences = differences_[static_cast<std::size_t>(axis)];
  if (differences.empty()) differences.resize(kRows * columns_);
  const Neighbours of = neighbours_of(pixel, axis, method);
  AtNeighbours& known = differences[place_of(of.first)];
  if (known.primitive != primitive_ || known.pixels != of) {
    known.primitive = primitive_;
    known.pixels = of;
    known.derivatives.exact = difference(of, axis);
    take_middles(known.derivatives);
  }
  return known.derivatives;
}

FragmentStage::FragmentStage(Rendering& rendering, const Target& target, const OutputChoice& choice)
    : rendering_(rendering),
      rules_{target, choice},
      operated_(choice.stencil == StencilMethod::once_a_draw ? rendering.stencils.size() : 0) {}

void FragmentStage::draw(const ExactFragment& fragment, const FragmentOperations& operations,
                         std::size_t sample) const {
  ExactSample values;
  const auto exchange = [&] {
    auto& colors = rendering_.samples > 1 ? rendering_.sample_pixels : rendering_.pixels;
    std::swap_ranges(values.color.begin(), values.color.end(), &colors[4 * sample]);
    if (!rendering_.depths.empty()) std::swap(values.depth, rendering_.depths[sample]);
    if (!rendering_.stencils.empty()) std::swap(values.stencil, rendering_.stencils[sample]);
    if (!operated_.empty()) std::swap(values.operated, operated_[sample]);
    std::swap(values.hits, rendering_.hits[sample]);
  };
  exchange();
  apply(fragment, operations, rules_, values);
  exchange();
}

void FragmentStage::draw_at_all(const ExactFragment& fragment, const FragmentOperations& operations,
                                std::span<const PixelPosition> pixels) const {
  const bool all_alike = rules_.target.depth == DepthFormat::none &&
                         rules_.target.stencil == StencilFormat::none && !operations.blending &&
                         writes_all_components(operations, rules_.choice.blend.mask);
  if (!all_alike) {
    for (const PixelPosition p : pixels)
      draw(fragment, operations, rendering_.pixel_index(p.x, p.y));
    return;
  }
  const Rgba8 stored = written_color(operations, fragment.color, {}, rules_.choice.blend);
  for (const PixelPosition p : pixels) {
    const std::size_t pixel = rendering_.pixel_index(p.x, p.y);
    std::copy_n(stored.begin(), stored.size(), &rendering_.pixels[4 * pixel]);
    ++rendering_.hits[pixel];
  }
}

}  // namespace edgecase
