// SPDX-License-Identifier: MIT
#include "rules/values/derivative.h"

#include <array>
#include <cstddef>

namespace edgecase {
namespace {

Neighbours from(PixelPosition first, Axis axis) {
  return {first, axis == Axis::x ? PixelPosition{first.x + 1, first.y}
                                 : PixelPosition{first.x, first.y + 1}};
}

// In the quad at `quad`: along x in its row `row`, along y in its column `column`.
Neighbours within(PixelPosition quad, Axis axis, int column, int row) {
  return from(axis == Axis::x ? PixelPosition{quad.x, quad.y + row}
                              : PixelPosition{quad.x + column, quad.y},
              axis);
}

Point centre_of(PixelPosition pixel) {
  return pixel_centre(pixel.x, pixel.y);
}

Rule rule_about(RuleId id, const char* title, const char* latitude, const char* standard) {
  Rule rule;
  rule.id = id;
  rule.title = title;
  rule.spec = "GLSL 4.60, 8.14.1 (derivative functions)";
  rule.latitude = latitude;
  rule.standard = standard;
  rule.alternatives = alternatives_of<DerivativeMethod>();
  return rule;
}

}  // namespace

RuleId derivative_rule_of(Derivative derivative) {
  constexpr std::array kRules{RuleId::derivative_plain, RuleId::derivative_fine,
                              RuleId::derivative_coarse};
  return kRules[form_of(derivative)];
}

QuadPixel in_quad(PixelPosition pixel, RowOrder rows, int height) {
  // Counted from the top, the lower row of a quad is odd if the height is.
  const int first = rows == RowOrder::top_down ? height % 2 : 0;
  return {pixel, {pixel.x - pixel.x % 2, pixel.y - (pixel.y + first) % 2}};
}

Neighbours neighbours_of(const QuadPixel& at, Axis axis, DerivativeMethod method) {
  const int column = at.pixel.x - at.quad.x;
  const int row = at.pixel.y - at.quad.y;
  switch (method) {
    case DerivativeMethod::analytic:
    case DerivativeMethod::forward:
      return from(at.pixel, axis);
    case DerivativeMethod::fine:
      return within(at.quad, axis, column, row);
    case DerivativeMethod::fine_odd:
      // The odd quad begins one pixel left and down, unless the pixel is the first one there.
      return within({at.pixel.x - (1 - column), at.pixel.y - (1 - row)}, axis, 1 - column, 1 - row);
    case DerivativeMethod::other_row:
      return within(at.quad, axis, 1 - column, 1 - row);
    case DerivativeMethod::coarse_bottom_left:
      return within(at.quad, axis, 0, 0);
    case DerivativeMethod::coarse_bottom_right:
      return within(at.quad, axis, 1, 0);
    case DerivativeMethod::coarse_top_left:
      return within(at.quad, axis, 0, 1);
    case DerivativeMethod::coarse_top_right:
      return within(at.quad, axis, 1, 1);
  }
  return from(at.pixel, axis);
}

Interval derivative_exact(const Interpolant& f, const QuadPixel& at, Axis axis,
                          DerivativeMethod method) {
  if (method == DerivativeMethod::analytic || is_linear(f))
    return differentiate_exact(f, centre_of(at.pixel), axis);
  const Neighbours of = neighbours_of(at, axis, method);
  return interpolate_exact(f, centre_of(of.second)) - interpolate_exact(f, centre_of(of.first));
}

Interval derivative_inexact(const Interpolant& f, const QuadPixel& at, Axis axis,
                            DerivativeMethod method) {
  if (method == DerivativeMethod::analytic)
    return differentiate_inexact(f, centre_of(at.pixel), axis);
  const Neighbours of = neighbours_of(at, axis, method);
  return kInexact.subtract(interpolate_inexact(f, centre_of(of.second)),
                           interpolate_inexact(f, centre_of(of.first)));
}

PermittedDerivatives::PermittedDerivatives(std::span<const Interpolant> components, double reach)
    : components_(components.begin(), components.end()), vertices_(components_.front(), reach) {}

const std::vector<PermittedDerivatives::AtPixel>& PermittedDerivatives::at_pixel(
    PixelPosition pixel) {
  std::vector<AtPixel>& known = pixels_[pixel];
  if (known.empty()) {
    const PermittedPlace place(vertices_, centre_of(pixel));
    known.reserve(components_.size());
    for (const Interpolant& f : components_) {
      const Interval value = place.value(f);
      known.push_back({value, place.slopes(f, value)});
    }
  }
  return known;
}

const PermittedDerivatives::AtPixel& PermittedDerivatives::beside(PixelPosition pixel, int dx,
                                                                  int dy, std::size_t component) {
  if (pixel != centre_) {
    centre_ = pixel;
    around_.fill(nullptr);
  }
  const std::vector<AtPixel>*& known = around_[static_cast<std::size_t>(3 * (dy + 1) + dx + 1)];
  if (known == nullptr) known = &at_pixel({pixel.x + dx, pixel.y + dy});
  return (*known)[component];
}

// The exact derivative, and the fine form: the pixel and its neighbour on either side. Other forms:
// any two neighbours along the axis among the nine pixels around it. The derivative lies between
// the differences on either side unless 1/w changes its sign between the three pixels.
Interval PermittedDerivatives::at(PixelPosition pixel, Derivative derivative,
                                  std::size_t component) {
  const Axis axis = axis_of(derivative);
  const bool fine = derivative == Derivative::x_fine || derivative == Derivative::y_fine;
  const int spread = fine ? 0 : 1;
  Interval result = beside(pixel, 0, 0, component).slopes[axis == Axis::x ? 0 : 1];
  for (int across = -spread; across <= spread; ++across) {
    std::array<Interval, 3> values;
    for (int along = -1; along <= 1; ++along) {
      const AtPixel& at = axis == Axis::x ? beside(pixel, along, across, component)
                                          : beside(pixel, across, along, component);
      values[static_cast<std::size_t>(along + 1)] = at.value;
    }
    result = hull(result, kInexact.subtract(values[1], values[0]));
    result = hull(result, kInexact.subtract(values[2], values[1]));
  }
  return result;
}

// The nine pixels around pixels two apart include all 4x4 areas that contain the pixel.
Interval PermittedDerivatives::in_area(PixelPosition pixel, Derivative derivative,
                                       std::size_t component) {
  Interval result = at(pixel, derivative, component);
  for (int dy = -2; dy <= 2; dy += 2)
    for (int dx = -2; dx <= 2; dx += 2)
      result = hull(result, at({pixel.x + dx, pixel.y + dy}, derivative, component));
  return result;
}

Rule derivative_rule() {
  Rule rule = rule_about(RuleId::derivative_plain,
                         "dFdx and dFdy are differences of neighbouring fragments' values",
                         "which neighbours: the fine or the coarse form, or the derivative itself "
                         "(ruling 16)",
                         "quad-fine");
  rule.rulings = {
      {16,
       "Derivatives: the fine forms may be the difference between the fragment and its neighbour "
       "on either side along the axis; the coarse forms, dFdx and dFdy may be the difference of "
       "any two neighbours along the axis among the nine pixels around the fragment; all may be "
       "the derivative itself. Each value is as ruling 9 permits it, and the subtraction is as "
       "inexact as any operation. Where quads begin is open."},
      {kRulingOnLargerAreas,
       "Contested: dFdx, dFdy or a coarse form is the difference of two neighbours along the axis "
       "that lie farther away than the nine pixels around the fragment, but in an area of 4x4 "
       "pixels that contains it. GLSL 4.60, 8.14.1, takes the current fragment's neighbours, and "
       "names a square of 2x2 as typical. But it speaks of \"a given area\" of no stated size, and "
       "only the fine forms name immediate neighbours; the language of OpenGL ES states no area "
       "either. The Khronos tests (dEQP-GLES3.functional.shaders.derivate.*) take neighbours "
       "within 1 pixel for functions that are not linear, and none asks for an area's size."}};
  return rule;
}

Rule quad_rows_rule() {
  Rule rule;
  rule.id = RuleId::derivative_quad_rows;
  rule.title = "Quads begin at even rows, counted from the bottom of the target";
  rule.spec = "GLSL 4.60, 8.14.1 (derivative functions)";
  rule.latitude = "where quads begin (ruling 16)";
  rule.standard = "bottom-up";
  rule.alternatives = {
      {"bottom-up", Openness::open, "rows are counted from the bottom"},
      {"top-down", Openness::open,
       "rows are counted from the top, which differs where the target's height is odd"}};
  return rule;
}

Rule fine_derivative_rule() {
  Rule rule = rule_about(RuleId::derivative_fine,
                         "dFdxFine and dFdyFine take the fragment's own row or column",
                         "the neighbour on either side (ruling 16)", "quad-fine");
  for (Alternative& alternative : rule.alternatives)
    if (alternative.name != "quad-fine" && alternative.name != "quad-fine-odd" &&
        alternative.name != "forward" && alternative.name != "analytic")
      alternative.openness = Openness::illegal;
  return rule;
}

Rule coarse_derivative_rule() {
  return rule_about(RuleId::derivative_coarse,
                    "dFdxCoarse and dFdyCoarse may be the same for a whole neighbourhood",
                    "any neighbours around the fragment (ruling 16)", "quad-coarse-bottom-left");
}

}  // namespace edgecase
