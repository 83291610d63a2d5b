// SPDX-License-Identifier: MIT
//
// How often the fragment shader runs for a pixel of a multisampled target (GL 4.6 core, 14.3.1.1).
//
// One invocation for each pixel and primitive is enough, unless the draw asks for more. It asks for
// more by an input that is qualified `sample`, or by GL_SAMPLE_SHADING. A share s of n samples
// demands at least max(ceil(s n), 1) different values. Implementations choose which samples share
// an invocation. They may run more invocations than the draw asks for.
#pragma once

#include <array>

#include "model/sampling.h"
#include "rules/rule.h"

namespace edgecase {

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
