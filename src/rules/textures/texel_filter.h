// SPDX-License-Identifier: MIT
//
// Filters within one level (GL 4.6 core, 8.14.2 and 8.14.3). Nearest takes the texel that holds the
// point. Linear takes the weighted mean of the four texels whose centres surround it, or of two in
// one dimension.
//
//     u in texels of the level     0     1     2     3
//                                  |--0--|--1--|--2--|
//     nearest  floor(u)
//     linear   i = floor(u - 1/2), weights 1 - a of i and a of i + 1, a = frac(u - 1/2)
//
// Coordinates are intervals, and the result holds the colours of all points in them. Exact
// coordinates give one colour. A coordinate interval that contains a texel's border gives two.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "exact/interval.h"
#include "model/texture.h"
#include "rules/rule.h"
#include "rules/textures/texture_image.h"

namespace edgecase {

Rule texel_filter_rule();  // texture.filter: nearest and linear; its rulings on weights
Rule texel_grid_rule();    // texture.texel-grid
inline constexpr int kRulingOnSrgb = 53;  // of coarse samplers

// The grid on which texel coordinates are put before texels and weights are derived from them.
enum class TexelGrid {
  none,
  floor_8,        // multiples of 1/256, rounded down
  nearest_8,      // to the nearest, half up
  linear_even_8,  // to the nearest, half to even; only under linear filters of rgba8 textures
};
template <>
inline constexpr auto kNames<TexelGrid> = std::to_array<TabledAlternative<TexelGrid>>(
    {{TexelGrid::none, "none", Openness::open, "coordinates in texels are taken as they are"},
     {TexelGrid::floor_8, "floor-8", Openness::open,
      "they are moved to the largest multiple of 1/256 texel that is not above"},
     {TexelGrid::nearest_8, "nearest-8", Openness::open,
      "they are moved to the nearest multiple of 1/256 texel, a tie to the right or up"},
     {TexelGrid::linear_even_8, "linear-even-8", Openness::open,
      "for linear filters of rgba8 textures, they are moved to the nearest multiple of 1/256 "
      "texel, "
      "a tie to the even one; otherwise they are taken as they are"}});

// A coordinate in texels, rounded to the grid.
Interval on_grid(Interval coordinate, TexelGrid grid);

// A point of a texture; the image's lower left corner is (0, 0) and its upper right one (1, 1). A
// coordinate that is a single point, but infinite or NaN, counts as 0: OpenGL defines no result for
// it. An interval with an end that is NaN is unbounded on that side.
struct TexturePoint {
  Interval s;
  Interval t;  // ignored in one dimension
};

struct TexelLookup {
  const std::array<Wrap, 2>& wrap;
  const std::array<float, 4>& border;  // taken as it is, in linear numbers, clamped to the format's
                                       // range unless the texture is of floats
  WrapChoice choice = WrapChoice::as_set;
  TexelGrid grid = TexelGrid::none;
  // How far a coordinate in texels may be off, in either direction; 0: not at all.
  double slack = 0;
};

// Beyond this many colours, those of neighbouring texels share a box.
constexpr std::size_t kMostBoxes = 4096;

// Colours that a level may yield, each a box that may contain the true colour; no two of them
// equal, at least one and at most kMostBoxes. One, if the coordinates are exact, or under a linear
// filter exact except for rounding, less than 2^-20 texels wide. The work is bounded by the number
// of texels, however wide the coordinates.
Texels filter_level(const DecodedLevel& level, int dimensions, TextureFormat format, Filter filter,
                    const TexturePoint& point, const TexelLookup& lookup);

// Precision of texture samplers. OpenGL states none for the logarithm of the scale factor, for the
// weight of the second level and for positions within a texel, which samplers keep in fixed point.
// They are judged by bounds, whatever the arithmetic. The bounds are those of the Khronos
// conformance tests (KhronosGroup/VK-GL-CTS, modules/gles3/functional/es3fTextureFilteringTests.cpp
// and framework/common/tcuTexLookupVerifier.hpp), which look up with 6 bits of level of detail and
// 7 bits of texel coordinates. If that fails they try 4 and 4 bits, and pass with a warning about
// quality.

struct SamplerPrecision {
  double level;  // error of the level of detail in levels, either way
  double texel;  // error of a coordinate in texels, either way
};

// Permitted (rulings 20, 22 and 24).
inline constexpr SamplerPrecision kPermittedPrecision{0x1p-6, 0x1p-7};
// Contested beyond that (ruling 50).
inline constexpr SamplerPrecision kContestedPrecision{0x1p-4, 0x1p-4};

// The relative error that the result of a floating-point operation may have, about 1 part in 10^5
// (GL 4.6 core, 2.3.4.1).
inline constexpr double kLookupError = 1e-5;

// True if a sampler takes means of texels within a level.
inline bool has_linear_filter(const Sampler& sampler) {
  return sampler.magnify == Filter::linear || sampler.minify == Filter::linear;
}

// The largest number of means of two that it takes: along each axis, and between levels.
inline int means_of(const Sampler& sampler, const Texture& texture) {
  return (has_linear_filter(sampler) ? texture.dimensions : 0) +
         (sampler.mipmap == MipFilter::linear ? 1 : 0);
}

// The number of operations in a row that make a number: a mean is a difference, two products and a
// sum, and so is a probe's part in an anisotropic filter.
inline double operations_of(const Sampler& sampler, const Texture& texture) {
  const double probes = sampler.max_anisotropy > 1 ? std::ceil(sampler.max_anisotropy) : 0;
  return 1 + 3 * means_of(sampler, texture) + probes;
}

}  // namespace edgecase
