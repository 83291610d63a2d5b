// SPDX-License-Identifier: MIT
//
// Interpolation: the value of an attribute at a sample of a primitive (GL 4.6
// core, 14.5.1, 14.6.1).
//
// Every attribute is a mean of its vertices' values. Its weights in the window are
//
//   triangles  w_i = the area that the sample forms with the edge opposite to vertex i
//   lines      w_1 = t, w_0 = 1 - t, with t = (p - a).(b - a) / |b - a|^2
//
// each up to a common factor, so nothing is divided until the end. An attribute that is
// interpolated with perspective has weights w_i / (clip w of vertex i): attribute/w and 1/w are
// linear in the window, and the attribute is their quotient. If all clip w are equal the two are
// the same. Depth and noperspective attributes use the weights as they are.
//
// Three questions are answered, each by an interval:
//   exact       what is the number? A few units of double precision wide.
//   inexact     what may come out if every operation errs by 1 part in 10^5 (2.3, floating-point
//               computation), the vertices being where they are?
//   permitted   and if every vertex may have moved as well?
// All follow the condition of the computation: a sliver's intervals are wide, a large triangle's
// are not.
#pragma once

#include <array>
#include <cstddef>

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "exact/interval.h"
#include "model/scene.h"

namespace edgecase {

// The position of a sample along a line: by its projection onto the line, as OpenGL says, or by its
// coordinate on the major axis alone, as a walk along that axis yields. If a line is as long in x
// as in y, or nearly so, an implementation may take the other axis for the major one.
enum class LineParameter { projection, major_axis, minor_axis };

// One component of an attribute over one primitive; entries beyond its vertices are ignored.
struct Interpolant {
  PrimitiveKind kind = PrimitiveKind::triangle;
  std::array<HomogeneousPoint, 3> positions{};  // in the window, exact
  std::array<Interval, 3> values{};             // narrow: a number, or a quotient rounded outwards
  std::array<Interval, 3> w{1, 1, 1};           // clip w, more than 0; as narrow as the values
  bool perspective = true;                      // weights are divided by w
  LineParameter line_parameter = LineParameter::projection;
};

// 1 to 3: the number of vertices.
inline std::size_t count_of(const Interpolant& interpolant) {
  return static_cast<std::size_t>(vertices_of(interpolant.kind));
}

// True if the attribute is equal at all vertices. Then it stays so to the bit, for every sample.
bool is_constant(const Interpolant& interpolant);

// True if the weights are divided by w and that makes a difference; it makes none if all w are
// equal.
bool has_perspective(const Interpolant& interpolant);

// True if the attribute changes by the same number from each pixel to the next. Then derivatives by
// all methods are that number.
bool is_linear(const Interpolant& interpolant);

// The attribute over w, and 1/w, without perspective: they are linear in the window.
Interpolant over_w(Interpolant interpolant);
Interpolant inverse_w(Interpolant interpolant);

// True if the line is at least as long in x as in y, by its vertices as they are.
bool is_x_major(const Interpolant& line);

// For a parameter along one coordinate: true if that is x.
bool goes_by_x(const Interpolant& line);

// True if the longer axis may become the shorter one, or as long, if each vertex moves by up to
// `reach` pixels in x and in y.
bool may_swap_axes(const Interpolant& line, double reach);

// A narrow interval (about 2^-48 of the largest value, before division by a tiny area) that
// contains the exact value at the sample, which may lie outside the primitive. If the interval does
// not determine the nearest float32 number, and values and w are single numbers, the result is the
// exact value, or the two doubles around it. Everything if the primitive has no extent.
Interval interpolate_exact(const Interpolant& interpolant, Point sample);

Interval interpolate_inexact(const Interpolant& interpolant, Point sample);

// `reach`: each vertex may have moved by less than this many pixels in x and in y.
Interval interpolate_permitted(const Interpolant& interpolant, Point sample, double reach);

// With w taken at one point and the attribute over w at another, as some implementations do for
// samples beside the pixel's centre: the mean of the values over w at the sample, times w at
// `w_place`. Without perspective equal to the two above.
Interval interpolate_exact(const Interpolant& interpolant, Point sample, Point w_place);
Interval interpolate_inexact(const Interpolant& interpolant, Point sample, Point w_place);

// The change of the value there, per pixel along x or along y: the analytic derivative. For a
// linear attribute the exact one is the same interval for every sample.
enum class Axis { x, y };
Interval differentiate_exact(const Interpolant& interpolant, Point sample, Axis axis);
Interval differentiate_inexact(const Interpolant& interpolant, Point sample, Axis axis);
Interval differentiate_permitted(const Interpolant& interpolant, Point sample, Axis axis,
                                 double reach);

// False if a triangle has no area, or a line no length.
bool has_extent(const Interpolant& interpolant);

}  // namespace edgecase
