// SPDX-License-Identifier: MIT
//
// Precision of texture samplers. OpenGL states none for the logarithm of the scale factor, for the
// weight of the second level and for positions within a texel, which samplers keep in fixed point.
// It is judged by bounds, whatever arithmetic is behind it. They are those of the Khronos
// conformance tests (KhronosGroup/VK-GL-CTS, modules/gles3/functional/es3fTextureFilteringTests.cpp
// and framework/common/tcuTexLookupVerifier.hpp), which look up with 6 bits of level of detail and
// 7 bits of texel coordinates, and where that fails with 4 and 4 bits, which passes with a warning
// about quality.
#pragma once

namespace edgecase {

struct SamplerPrecision {
  double level;  // levels that the level of detail may be off, either way
  double texel;  // texels that a coordinate may be off, either way
};

// Permitted (rulings 20, 22 and 24).
inline constexpr SamplerPrecision kPermittedPrecision{0x1p-6, 0x1p-7};
// Contested beyond that (ruling 50).
inline constexpr SamplerPrecision kContestedPrecision{0x1p-4, 0x1p-4};

// The part of itself that the result of a floating-point operation may be off, about 1 part in 10^5
// (GL 4.6 core, 2.3.4.1).
inline constexpr double kLookupError = 1e-5;

}  // namespace edgecase
