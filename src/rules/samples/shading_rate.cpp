// SPDX-License-Identifier: MIT
#include "rules/samples/shading_rate.h"

namespace edgecase {

bool runs_per_sample(const Multisampling& use, int samples, ShadingRate choice) {
  if (!use.enabled || samples == 1) return false;
  switch (choice) {
    case ShadingRate::as_needed:
      return least_invocations(use, samples) > 1;
    case ShadingRate::per_sample:
      return true;
    case ShadingRate::per_pixel:
      return false;
  }
  return false;
}

Rule shading_rate_rule() {
  return {
      RuleId::sample_shading_rate,
      "The shader runs at least as often for a pixel as the draw asks for",
      "14.3.1.1 (sample shading)",
      "more invocations than are asked for, and which samples share one (ruling 34)",
      "as-needed",
      alternatives_of<ShadingRate>(),
      {{34,
        "A pixel of n samples has at least m = max(ceil(s n), 1) invocations under "
        "GL_SAMPLE_SHADING with share s, and n where an input is qualified sample. A pixel of "
        "which a primitive covers only k samples has at least k/n of these, rounded up, and at "
        "most k. Their coverage masks share no bit, and together contain the covered samples. "
        "Fewer invocations than requested are a violation, more are not."},
       {kRulingOnPartlyCovered,
        "Contested: a pixel of n samples, of which a primitive covers k, has fewer than k m/n "
        "invocations, rounded up, but at least max(1, m - (n - k)). Here m is the least for a "
        "whole pixel: max(ceil(s n), 1) under GL_SAMPLE_SHADING with share s, and n where an input "
        "is qualified sample. 14.3.1.1 asks for m sets of inputs for each fragment; where samples "
        "share them evenly, k samples have k m/n. But it lets the implementation associate sets "
        "with samples as it likes, and OpenGL ES 3.2 does, too (13.4.1): samples that are not "
        "covered may have one each, and those that are covered may share the others. The Khronos "
        "tests (dEQP-GLES31.functional.sample_shading.min_sample_shading.*) look at whole pixels "
        "alone."}}};
}

}  // namespace edgecase
