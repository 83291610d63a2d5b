// SPDX-License-Identifier: MIT
//
// Where in a multisampled pixel attributes are evaluated (GL 4.6 core, 14.3.1 and 14.3.1.1; GLSL
// 4.60, 4.5).
//
// A fragment that stands for several samples has one value of each attribute. The attribute is
// evaluated at one place: anywhere in the pixel, unless the shader qualifies it. `centroid` asks
// for a place in the part of the pixel that the primitive covers. `sample` asks for the location of
// the sample that the invocation runs for. Under GL_SAMPLE_SHADING with a share of 1 every
// attribute is evaluated at the sample. The depth of a sample is always evaluated at that sample.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "exact/fixed.h"
#include "model/sampling.h"
#include "model/scene.h"
#include "rules/rule.h"

namespace edgecase {

Rule attribute_location_rule();  // attribute.location
Rule centroid_rule();            // attribute.centroid
Rule sample_depth_rule();        // sample.depth

// For unqualified attributes, if the shader runs once for the pixel.
enum class PlainLocation {
  centre,
  first_covered,   // the covered sample of lowest index
  half_pixel_off,  // of points and lines, half a pixel right of and above the correct location
};
template <>
inline constexpr auto kNames<PlainLocation> = std::to_array<TabledAlternative<PlainLocation>>(
    {{PlainLocation::centre, "centre", Openness::open, "the pixel's centre"},
     {PlainLocation::first_covered, "first-covered", Openness::open,
      "the covered sample of lowest index"},
     {PlainLocation::half_pixel_off, "half-pixel-off", Openness::illegal,
      "for points and lines, half a pixel to the right of and above the proper place: at the "
      "pixel's corner or beyond it"}});

// For attributes qualified `centroid`, if the shader runs once for the pixel.
enum class CentroidLocation {
  centre_or_first,  // the centre if all samples are covered, else the first covered sample
  first_covered,
  mean_covered,  // the mean of the covered samples, to the nearest 2^-16
  centre,        // regardless of coverage
};
template <>
inline constexpr auto kNames<CentroidLocation> = std::to_array<TabledAlternative<CentroidLocation>>(
    {{CentroidLocation::centre_or_first, "centre-or-first", Openness::open,
      "the centre where all samples are covered, else the covered sample of lowest index"},
     {CentroidLocation::first_covered, "first-covered", Openness::open,
      "the covered sample of lowest index"},
     {CentroidLocation::mean_covered, "mean-covered", Openness::open,
      "the mean of the covered samples"},
     {CentroidLocation::centre, "centre", Openness::illegal,
      "the pixel's centre, even where the primitive does not cover it"}});

// For the depth given to a sample.
enum class DepthLocation {
  at_sample,
  centre,              // one depth for all samples of the pixel
  mirrored_x,          // left and right of the pixel exchanged; gl_FragCoord.z is that of sample 0
  mirrored_x_or_zero,  // the same, but gl_FragCoord.z is 0 if the sample mask lacks sample 0
  half_pixel_off,      // of points and lines, half a pixel right of and above the sample
};
template <>
inline constexpr auto kNames<DepthLocation> = std::to_array<TabledAlternative<DepthLocation>>(
    {{DepthLocation::at_sample, "at-sample", Openness::mandated, "at the sample"},
     {DepthLocation::centre, "centre", Openness::illegal, "at the pixel's centre, for all samples"},
     {DepthLocation::mirrored_x, "mirrored-x", Openness::illegal,
      "at the sample, with the pixel's left and right exchanged; gl_FragCoord.z likewise at sample "
      "0"},
     {DepthLocation::mirrored_x_or_zero, "mirrored-x-or-zero", Openness::illegal,
      "the same, but gl_FragCoord.z is 0 where the sample mask lacks sample 0"},
     {DepthLocation::half_pixel_off, "half-pixel-off", Openness::illegal,
      "for points and lines, half a pixel to the right of and above the sample or gl_FragCoord"}});

struct LocationChoice {
  PlainLocation plain = PlainLocation::centre;
  CentroidLocation centroid = CentroidLocation::centre_or_first;
  DepthLocation depth = DepthLocation::at_sample;

  friend bool operator==(const LocationChoice&, const LocationChoice&) = default;
};

// One invocation of the shader for a pixel of a multisampled draw.
struct Invocation {
  PrimitiveKind kind = PrimitiveKind::triangle;
  std::uint32_t coverage = 1;  // bit s: it represents sample s; at least one bit
  bool per_sample = false;     // it runs for one sample
};

// A location within the pixel. `positions`: those of its samples.
Point attribute_location(AttributeLocation qualifier, const Invocation& invocation,
                         const SamplePositions& positions, const LocationChoice& choice);
// gl_FragCoord.xy: the centre, or the sample.
Point coordinates_location(const Invocation& invocation, const SamplePositions& positions);
// gl_FragCoord.z, which is also the depth that a fragment reports.
Point fragment_depth_location(const Invocation& invocation, const SamplePositions& positions,
                              const LocationChoice& choice);
// True if gl_FragCoord.z is 0 instead.
bool fragment_depth_is_zero(const Multisampling& use, const LocationChoice& choice);
// The depth that is written to a sample.
Point sample_depth_location(PrimitiveKind kind, Point sample, const LocationChoice& choice);

// True if all attributes of an invocation are bound to its sample (rulings 29 and 30).
bool is_at_sample(const Multisampling& use);

// Where in the window rulings 29 and 30 allow an attribute of a primitive to be evaluated in a
// pixel of a multisampled target: the corners of a convex region that contains all of these
// locations, in no particular order. Only the sample (`sample`: within the pixel, that of the
// invocation) if the attribute is bound to it; the whole pixel if it is not qualified or, whatever
// its qualifier, without GL_MULTISAMPLE; for `centroid` the intersection of the pixel and the
// primitive, each vertex moved by less than `reach`, or the whole pixel if they do not intersect.
// Rounded outwards to multiples of 2^-16.
std::vector<Point> permitted_locations(const ScenePrimitive& primitive, PixelPosition pixel,
                                       Point sample, Fixed reach);

// The same for gl_FragCoord, which has no qualifier (GLSL 4.60, 7.1.5): only the sample under
// GL_SAMPLE_SHADING with a share of 1, else the whole pixel.
std::vector<Point> permitted_coordinate_locations(const Multisampling& use, PixelPosition pixel,
                                                  Point sample);

}  // namespace edgecase
