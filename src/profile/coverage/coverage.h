// SPDX-License-Identifier: MIT
//
// Coverage: which pixels of targets with one sample a renderer draws.
//
//   random scenes and probes -> inferred choice -> how it draws each family of probes
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "generate/grids.h"
#include "model/names.h"
#include "model/scene.h"
#include "profile/evidence/findings.h"
#include "rules/choices.h"

namespace edgecase {

// Probes: constructed scenes, each with one question to a renderer, always the same.
//
// Random scenes measure how often a rule is followed; probes find out which. They form families:
// every place of a diamond for every direction of a line, every side and corner of a triangle,
// joints, edges shared by triangles, provoking vertices, vertices beyond the viewport. Except for
// clip probes, every vertex lies strictly inside the viewport, which is the target, a power of two.
// All coordinates reach OpenGL unrounded.

// A line that starts or ends at a place of a pixel's diamond and has its other end strictly inside
// a diamond.
struct DiamondProbe {
  Scene scene;
  PixelPosition pixel;
  LineDirection direction = LineDirection::right;
  bool at_start = true;
  DiamondPlace place = DiamondPlace::inside;
  // Whether pixels other than those with the same corner depend on ties, too. They do if the line
  // runs along boundaries: rightward from a bottom corner, diagonally from some edges.
  bool tied_elsewhere = false;
};
// At least four for every direction, end and place.
std::vector<DiamondProbe> diamond_probes(Surface surface);

// Which side of a triangle an edge is, y up: the interior of a `lower_left` edge is to its right
// and above it.
enum class EdgeSide {
  left,
  right,
  bottom,
  top,
  lower_left,
  lower_right,
  upper_left,
  upper_right,
};
template <>
inline constexpr auto kNames<EdgeSide> =
    std::to_array<Named<EdgeSide>>({{EdgeSide::left, "left"},
                                    {EdgeSide::right, "right"},
                                    {EdgeSide::bottom, "bottom"},
                                    {EdgeSide::top, "top"},
                                    {EdgeSide::lower_left, "lower left"},
                                    {EdgeSide::lower_right, "lower right"},
                                    {EdgeSide::upper_left, "upper left"},
                                    {EdgeSide::upper_right, "upper right"}});

// Which side of a counter-clockwise triangle a -> b is. The points must differ.
EdgeSide side_of(Point a, Point b);

// A triangle with one pixel's sample on an edge, or on a corner where two edges meet. Coordinates
// are multiples of 1/16.
struct EdgeProbe {
  Scene scene;
  PixelPosition pixel;
  EdgeSide side = EdgeSide::left;
  std::optional<EdgeSide> corner_with;  // for a corner: the edge after `side`, counter-clockwise
};
std::vector<EdgeProbe> edge_probes(Surface surface);

// A chain of two to six segments, each starting bit-identically where the previous one ends; as a
// strip, or as separate lines in one draw.
struct JointProbe {
  Scene scene;
  bool goes_on = true;                     // one major axis and direction; else one joint turns
  std::optional<DiamondPlace> place;       // of the first joint in its pixel; nothing: anywhere
  std::optional<LineDirection> direction;  // of all segments, if they share one
};
std::vector<JointProbe> joint_probes(Surface surface);

enum class SharedEdgeShape {
  quad,   // two triangles, split along one of the diagonals
  strip,  // a triangle strip
  fan,    // triangles all or part of the way round an inner vertex
};
template <>
inline constexpr auto kNames<SharedEdgeShape> =
    std::to_array<Named<SharedEdgeShape>>({{SharedEdgeShape::quad, "quad"},
                                           {SharedEdgeShape::strip, "strip"},
                                           {SharedEdgeShape::fan, "fan"}});

// Consecutive triangles on opposite sides of common edges with bit-identical ends, in one draw:
// separate triangles, a strip or a fan. Triangles do not overlap, and no vertex lies on another's
// edge.
struct SharedEdgeProbe {
  Scene scene;
  SharedEdgeShape shape = SharedEdgeShape::quad;
  bool closed = false;  // for a fan: the last triangle shares an edge with the first
};
std::vector<SharedEdgeProbe> shared_edge_probes(Surface surface);

// Every primitive type under either convention, with one to four flat primitives, and a distinct
// colour for every vertex. Every primitive covers pixels that no other does.
std::vector<Scene> provoking_probes(Surface surface);

// Sides of the viewport, as bits of a set.
enum ClipSide : unsigned {
  kClipLeft = 1u << 0,
  kClipRight = 1u << 1,
  kClipBottom = 1u << 2,
  kClipTop = 1u << 3,
};

// A primitive with vertices beyond the viewport, by up to three times its size, which is at most
// 64: |x - centre| <= 3.5 * 64 < 2^8, which is 24 significant bits with 16 fraction bits, as in
// float32. So clip coordinates are exact, though a renderer's results from them need not be.
struct ClipProbe {
  Scene scene;
  unsigned sides = 0;  // those beyond which a vertex lies
  // The same draw and target in a viewport so large that nothing has to be clipped.
  Scene unclipped;
};
std::vector<ClipProbe> clip_probes(Surface surface);

// Probes with their observations: observations[i] is of probes[i].scene.
template <class Probe>
struct Seen {
  std::span<const Probe> probes;
  std::span<const Observation> observations;
};

// Who owns each part of a diamond at the start and at the end of lines, by direction.
std::vector<OwnershipTable> diamond_tables(const Seen<DiamondProbe>& seen);
// The share of probes in which the choice and the renderer agree on the probed pixel.
Trait diamond_trait(const Seen<DiamondProbe>& seen, const CoverageChoice& lines);

// Who owns samples exactly on each side and corner of triangles.
std::vector<OwnershipTable> edge_tables(const Seen<EdgeProbe>& seen);
Trait edge_trait(const Seen<EdgeProbe>& seen, const CoverageChoice& triangles);

// Whether joints of lines that continue in one direction satisfy ruling 14, and whether turning
// joints are drawn as the choice draws their segments.
std::vector<Trait> joint_traits(const Seen<JointProbe>& seen, const CoverageChoice& lines);

// Holes and double hits on edges that two triangles share (ruling 5, with the bits of ruling 4).
Trait shared_edge_trait(std::span<const Observation* const> observations, int bits);

// Whether primitives that extend beyond the viewport are drawn as in one that contains them.
std::vector<Trait> clip_traits(const Seen<ClipProbe>& seen, std::span<const Observation> unclipped);

// Which vertex gives flat primitives their colour. renderings[i] is of scenes[i], a provoking
// probe; nothing if the renderer does not draw it.
Trait provoking_trait(std::span<const Scene> scenes,
                      std::span<const std::optional<Rendering>> renderings);

extern const Subject kCoverageSubject;

}  // namespace edgecase
