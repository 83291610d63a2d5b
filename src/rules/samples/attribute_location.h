// SPDX-License-Identifier: MIT
//
// Where the attributes of a multisampled fragment are evaluated, and how often the shader runs.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "exact/fixed.h"
#include "model/sampling.h"
#include "model/scene.h"
#include "rules/rule.h"

namespace edgecase {

// Essay: Where attributes are evaluated
//
// Where in a multisampled pixel attributes are evaluated (GL 4.6 core, 14.3.1 and 14.3.1.1; GLSL
// 4.60, 4.5).
//
// A fragment that stands for several samples has one value of each attribute. The attribute is
// evaluated at one place: anywhere in the pixel, unless the shader qualifies it. `centroid` asks
// for a place in the part of the pixel that the primitive covers. `sample` asks for the location of
// the sample that the invocation runs for. Under GL_SAMPLE_SHADING with a share of 1 every
// attribute is evaluated at the sample. The depth of a sample is always evaluated at that sample.

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

// Convex regions of the window are intersections of half planes. One half plane, in units of 2^-16
// pixels: the points with normal_x x + normal_y y <= limit; normals up to 2^31, limits up to 2^62.
struct HalfPlane {
  std::int64_t normal_x = 0;
  std::int64_t normal_y = 0;
  Int128 limit = 0;
};

// A pixel, including its boundary.
std::array<HalfPlane, 4> half_planes_of(PixelPosition pixel);

// The corners of the intersection of half planes, which must be bounded. A corner that is no
// multiple of 2^-16 is replaced by the multiples around it. Empty if they do not intersect.
std::vector<Point> corners_of(std::span<const HalfPlane> planes);

// Essay: How often the shader runs
//
// How often the fragment shader runs for a pixel of a multisampled target (GL 4.6 core, 14.3.1.1).
//
// One invocation for each pixel and primitive is enough, unless the draw asks for more. It asks for
// more by an input that is qualified `sample`, or by GL_SAMPLE_SHADING. A share s of n samples
// demands at least max(ceil(s n), 1) different values. Implementations choose which samples share
// an invocation. They may run more invocations than the draw asks for.

Rule shading_rate_rule();  // sample.shading-rate
inline constexpr int kRulingOnPartlyCovered = 60;

enum class ShadingRate {
  as_needed,   // once for the pixel or, if more is requested, once for each covered sample
  per_sample,  // once for each covered sample, always
  per_pixel,   // once for the pixel, whatever is requested
};
template <>
inline constexpr auto kNames<ShadingRate> = std::to_array<TabledAlternative<ShadingRate>>(
    {{ShadingRate::as_needed, "as-needed", Openness::open,
      "once for each pixel and primitive, or once for each covered sample if the draw asks for "
      "more "
      "than one invocation"},
     {ShadingRate::per_sample, "per-sample", Openness::open, "once for each covered sample"},
     {ShadingRate::per_pixel, "per-pixel", Openness::illegal,
      "once for each pixel and primitive, whatever is asked for"}});

// True if the shader runs once for each covered sample; never without multisampling.
bool runs_per_sample(const Multisampling& use, int samples, ShadingRate choice);

}  // namespace edgecase
