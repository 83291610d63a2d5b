// SPDX-License-Identifier: MIT
//
// Precision of texture samplers. OpenGL states none for the logarithm of the scale factor, for the
// weight of the second level and for positions within a texel, which samplers keep in fixed point.
// They are judged by bounds, whatever the arithmetic. The bounds are those of the Khronos
// conformance tests (KhronosGroup/VK-GL-CTS, modules/gles3/functional/es3fTextureFilteringTests.cpp
// and framework/common/tcuTexLookupVerifier.hpp), which look up with 6 bits of level of detail and
// 7 bits of texel coordinates. If that fails they try 4 and 4 bits, and pass with a warning about
// quality.
#pragma once

#include <cmath>

#include "model/texture.h"

namespace edgecase {

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
