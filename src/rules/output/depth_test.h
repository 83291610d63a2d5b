// SPDX-License-Identifier: MIT
//
// The depth test (GL 4.6 core, 17.3.4) compares a fragment's depth with the stored one. The draw
// names the comparison. A fragment that fails it is discarded. A fragment that passes has its depth
// stored, unless the draw masks depths (17.4.2).
//
// The test compares values in the depth buffer's format. A fragment's depth is converted first
// (13.8.1, rules/values/depth_buffer.h).
#pragma once

#include <span>
#include <string_view>

#include "exact/interval.h"
#include "model/scene.h"
#include "rules/rule.h"

namespace edgecase {

Rule depth_test_rule();  // depth.test
Rule depth_mask_rule();  // depth.mask

enum class DepthTestMethod {
  as_set,
  unconverted,  // the fragment's depth is compared before it is converted
  ties_pass,    // less and greater let equal depths pass
  ties_fail,    // lequal and gequal reject equal depths
  ignored,      // every fragment passes
};
template <>
inline constexpr auto kNames<DepthTestMethod> = std::to_array<TabledAlternative<DepthTestMethod>>(
    {{DepthTestMethod::as_set, "as-set", Openness::mandated,
      "the fragment's depth, as the buffer would store it, is compared with the stored one"},
     {DepthTestMethod::unconverted, "unconverted", Openness::illegal,
      "the fragment's depth is compared before it is converted; the equal test may fail against a "
      "stored value of the same depth"},
     {DepthTestMethod::ties_pass, "ties-pass", Openness::illegal,
      "less and greater let equal depths pass"},
     {DepthTestMethod::ties_fail, "ties-fail", Openness::illegal,
      "lequal and gequal do not let equal depths pass"},
     {DepthTestMethod::ignored, "ignored", Openness::illegal, "every fragment passes"}});

// Whether a draw that masks depths stores any.
enum class DepthMaskMethod { as_set, ignored };
template <>
inline constexpr auto kNames<DepthMaskMethod> = std::to_array<TabledAlternative<DepthMaskMethod>>(
    {{DepthMaskMethod::as_set, "as-set", Openness::mandated,
      "draws that mask depths leave the stored depth as it is"},
     {DepthMaskMethod::ignored, "ignored", Openness::illegal,
      "the depth of every fragment that passes is stored"}});

// True if the depth of a fragment that passes is stored.
inline bool stores_depth(const DepthTest& test, DepthMaskMethod method) {
  return test.write || method == DepthMaskMethod::ignored;
}

// True if a fragment passes. `depth`: 0 to 1, before conversion; `stored`: a value of the format.
// Always true without a depth buffer.
bool passes_depth_test(const DepthTest& test, double depth, double stored, DepthFormat format,
                       DepthTestMethod method);

// The possible outcomes of a test; at least one.
struct TestOutcomes {
  bool may_pass = false;
  bool may_fail = false;
};

// For depths known as ranges of the format's values, both ends included. `same`: they are known to
// be one and the same number, whichever of the range it is.
TestOutcomes permitted_outcomes(CompareFunction function, Interval depth, Interval stored,
                                bool same);

// The same for a depth that is compared before conversion: `depth` is a range of numbers.
TestOutcomes unconverted_outcomes(CompareFunction function, Interval depth, Interval stored,
                                  DepthFormat format);

}  // namespace edgecase
