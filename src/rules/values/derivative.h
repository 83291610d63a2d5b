// SPDX-License-Identifier: MIT
//
// Derivatives of an attribute along the window's axes (GLSL 4.60, 8.14.1, derivative functions).
//
// A shader asks for dFdx or dFdy, or for their fine or coarse forms. The specification describes
// "local differencing": forward or backward differences of neighbours. The fine form uses the
// fragment itself. The coarse form may use any fragments around it. The choice of neighbours is
// open. Hardware shades quads of 2x2 pixels and subtracts within a quad. Software may subtract from
// the next pixel, or know the derivative.
//
//     quad   2 3     fine x of 0 and 1: a1 - a0, of 2 and 3: a3 - a2
//            0 1     coarse x of all four: a1 - a0 (bottom) or a3 - a2 (top)
//
// All of these are equal where the attribute is linear in the window. Under perspective they
// differ, and the more w varies, the more they differ. Values beyond the primitive's edges are
// those of the plane through its vertices. The other pixels of a quad need not be covered.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "exact/fixed.h"
#include "model/rendering.h"
#include "rules/coverage/window.h"
#include "rules/rule.h"
#include "rules/values/interpolation.h"
#include "rules/values/permitted_interpolation.h"

namespace edgecase {

Rule derivative_rule();         // derivative.plain: dFdx and dFdy
Rule fine_derivative_rule();    // derivative.fine
Rule coarse_derivative_rule();  // derivative.coarse
Rule quad_rows_rule();          // derivative.quad-rows: the end from which quads are counted
inline constexpr int kRulingOnLargerAreas = 49;  // of the mean over a larger area

enum class DerivativeMethod {
  analytic,
  forward,             // a(x + 1) - a(x)
  fine,                // within the quad, in the pixel's own row or column
  fine_odd,            // the same, for quads that begin at odd columns and rows
  other_row,           // within the quad, in the other row or column than the pixel's
  coarse_bottom_left,  // within the quad: x in its bottom row, y in its left column; and so on
  coarse_bottom_right,
  coarse_top_left,
  coarse_top_right,
};
template <>
inline constexpr auto kNames<DerivativeMethod> = std::to_array<TabledAlternative<DerivativeMethod>>(
    {{DerivativeMethod::analytic, "analytic", Openness::open,
      "the derivative itself, not a difference"},
     {DerivativeMethod::forward, "forward", Openness::open,
      "the next pixel's value minus the pixel's own"},
     {DerivativeMethod::fine, "quad-fine", Openness::open,
      "the difference within the 2x2 quad, in the pixel's own row or column"},
     {DerivativeMethod::fine_odd, "quad-fine-odd", Openness::open,
      "the same, for quads that begin at odd columns and rows"},
     {DerivativeMethod::coarse_bottom_left, "quad-coarse-bottom-left", Openness::open,
      "one difference for the quad, along x in its bottom row, along y in its left column"},
     {DerivativeMethod::coarse_bottom_right, "quad-coarse-bottom-right", Openness::open,
      "one difference for the quad, along x in its bottom row, along y in its right column"},
     {DerivativeMethod::coarse_top_left, "quad-coarse-top-left", Openness::open,
      "one difference for the quad, along x in its top row, along y in its left column"},
     {DerivativeMethod::coarse_top_right, "quad-coarse-top-right", Openness::open,
      "one difference for the quad, along x in its top row, along y in its right column"},
     {DerivativeMethod::other_row, "quad-other-row", Openness::open,
      "the difference within the quad, in the row or column that does not hold the pixel"}});

// The rule for a derivative: 0 plain, 1 fine, 2 coarse.
constexpr std::size_t form_of(Derivative derivative) {
  return static_cast<std::size_t>(derivative) / 2;
}
constexpr Axis axis_of(Derivative derivative) {
  return static_cast<std::size_t>(derivative) % 2 == 0 ? Axis::x : Axis::y;
}
RuleId derivative_rule_of(Derivative derivative);

// A pixel, and the lower left pixel of the quad in which it is shaded.
struct QuadPixel {
  PixelPosition pixel;
  PixelPosition quad;
};

// The quads of a target with rows counted from the bottom, or from the top: they begin at even
// columns and even rows.
QuadPixel in_quad(PixelPosition pixel, RowOrder rows, int height);

// Two adjacent pixels: the derivative is the second's value minus the first's.
struct Neighbours {
  PixelPosition first;
  PixelPosition second;
  friend bool operator==(const Neighbours&, const Neighbours&) = default;
};

// The pixels whose difference a method takes; for `analytic`, which takes none, those of `forward`.
Neighbours neighbours_of(const QuadPixel& at, Axis axis, DerivativeMethod method);

// The derivative by a method, per pixel: exact, and its possible values if every operation errs
// (see rules/values/interpolation.h).
Interval derivative_exact(const Interpolant& interpolant, const QuadPixel& at, Axis axis,
                          DerivativeMethod method);
Interval derivative_inexact(const Interpolant& interpolant, const QuadPixel& at, Axis axis,
                            DerivativeMethod method);

// The results of any permitted method, with vertices moved by less than `reach` pixels (ruling 16).
// A pixel's differences share values with those of its neighbours and of the other forms, so these
// are cached.
class PermittedDerivatives {
 public:
  // Components of one primitive's attributes, at least one; with perspective all have the same w.
  PermittedDerivatives(std::span<const Interpolant> components, double reach);
  PermittedDerivatives(const Interpolant& component, double reach)
      : PermittedDerivatives(std::span(&component, 1), reach) {}
  PermittedDerivatives(PermittedDerivatives&&) = default;  // a copy would point into the original

  Interval at(PixelPosition pixel, Derivative derivative, std::size_t component = 0);
  // Further values of the plain and coarse forms, if the area that shares a derivative may have up
  // to 4x4 pixels (ruling 49).
  Interval in_area(PixelPosition pixel, Derivative derivative, std::size_t component = 0);

 private:
  struct AtPixel {
    Interval value;
    std::array<Interval, 2> slopes;  // by axis
  };
  // By component.
  const std::vector<AtPixel>& at_pixel(PixelPosition pixel);
  // Of a pixel at most one column and one row away from `pixel`.
  const AtPixel& beside(PixelPosition pixel, int dx, int dy, std::size_t component);

  std::vector<Interpolant> components_;
  MovedVertices vertices_;
  std::map<PixelPosition, std::vector<AtPixel>> pixels_;
  // Those of them around the pixel that was asked for last, by row and column.
  PixelPosition centre_{-1, -1};
  std::array<const std::vector<AtPixel>*, 9> around_{};
};

}  // namespace edgecase
