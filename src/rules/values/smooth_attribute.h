// SPDX-License-Identifier: MIT
//
// Smooth attributes and depth: linear interpolation (GL 4.6 core, 14.5.1 and 14.6.1).
//
// Inside a triangle an attribute is a weighted mean of its vertices' values, the weights being the
// areas of the triangles that the sample forms with the opposite edges; along a line it runs with
// t = (p - a).(b - a) / |b - a|^2. With w = 1, as here, the same holds for depth. Areas and
// products are exact integers; only the last steps are done in interval arithmetic, which is far
// finer than the float32 that a renderer answers in.
//
// What an implementation may answer is wider: each operation may err by about 1 part in 10^5 (2.3,
// floating-point computation), and the vertices may have been moved to the sub-pixel grid. Both
// follow the condition of the computation: a sliver's interval is wide, a large triangle's is not.
#pragma once

#include <array>

#include "exact/fixed.h"
#include "exact/interval.h"
#include "model/scene.h"
#include "rules/rule.h"

namespace edgecase {

Rule smooth_attribute_rule();
Rule depth_rule();

// How far along a line a sample lies: by its projection onto the line, as OpenGL says, or by its
// coordinate on the major axis alone, which is what a walk along that axis yields.
enum class LineParameter { projection, major_axis };

// One component of an attribute over one primitive; unused entries are ignored.
struct Interpolant {
  PrimitiveKind kind = PrimitiveKind::triangle;
  std::array<Point, 3> positions{};
  std::array<double, 3> values{};
  LineParameter line_parameter = LineParameter::projection;
};

// A narrow interval (about 2^-48 of the largest value, before division by a tiny area) that holds
// the exact value at the sample. Everything when the primitive has no extent.
Interval interpolate_exact(const Interpolant& interpolant, Point sample);

// What an implementation may answer there; each vertex may have moved by less than 2^-bits.
Interval interpolate_permitted(const Interpolant& interpolant, Point sample, int bits);

}  // namespace edgecase
