// SPDX-License-Identifier: MIT
//
// How large points and multisampled lines may be, and which samples a primitive may cover with the
// latitude of its vertices and of its size.
#pragma once

#include "diff/coverage/coverage_compare.h"
#include "exact/fixed.h"
#include "model/scene.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/renderer_claims.h"

namespace edgecase {

// The least and the largest size that a requested size may become, both more than 0: none farther
// from it than the nearest of the claimed sizes and 1, all of which are supported. Additional sizes
// may be supported (14.4.1), so that any between them may be the nearest.
struct SizeRange {
  Fixed low;
  Fixed high;
};
SizeRange permitted_sizes(Fixed asked, const SizeSteps& supported);

// The latitude of vertices and of sizes of points and lines.
struct Latitudes {
  Triangle positions;  // the nearest points of the vertices, as many as there are; none if clipped
  Fixed reach;         // as reach_of has it, which accounts for their error
  SizeRange sizes;
};
Latitudes latitudes_of(const ScenePrimitive& primitive, int bits, const SupportedSizes& supported);

// Whether some permitted position and size of the primitive, which is not clipped, covers the
// sample or leaves it out. Both are true of one on the boundary.
bool possibly_covered(const ScenePrimitive& primitive, Point sample, const Latitudes& latitudes);
bool possibly_uncovered(const ScenePrimitive& primitive, Point sample, const Latitudes& latitudes);

// The sizes that may excuse what was drawn of a primitive: those that the renderer claims, if one
// permitted size explains all of it. A renderer that draws some samples by one size and others by
// another has no size that is the nearest supported one, so its claim excuses nothing.
SupportedSizes sizes_that_excuse(const ScenePrimitive& primitive, const PrimitiveCoverage& coverage,
                                 const CoverageContext& context);

}  // namespace edgecase
