// SPDX-License-Identifier: MIT
#include "rules/output/fragment_tests.h"

#include <algorithm>

#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

StencilOperation operation_by(StencilOperation operation, StencilMethod method) {
  const bool wraps = method == StencilMethod::wrapping;
  const bool saturates = method == StencilMethod::saturating;
  if (operation == StencilOperation::incr && wraps) return StencilOperation::incr_wrap;
  if (operation == StencilOperation::decr && wraps) return StencilOperation::decr_wrap;
  if (operation == StencilOperation::incr_wrap && saturates) return StencilOperation::incr;
  if (operation == StencilOperation::decr_wrap && saturates) return StencilOperation::decr;
  return operation;
}

// The result before the write mask; only its lowest 8 bits count.
int result_of(StencilOperation operation, int reference, int stored) {
  switch (operation) {
    case StencilOperation::keep:
      return stored;
    case StencilOperation::zero:
      return 0;
    case StencilOperation::replace:
      return reference;
    case StencilOperation::incr:
      return stored == 0xff ? stored : stored + 1;
    case StencilOperation::incr_wrap:
      return stored + 1;
    case StencilOperation::decr:
      return stored == 0 ? stored : stored - 1;
    case StencilOperation::decr_wrap:
      return stored - 1;
    case StencilOperation::invert:
      return ~stored;
  }
  return stored;
}

}  // namespace

const StencilFace& face_of(const StencilTest& test, bool front_facing, StencilMethod method) {
  return front_facing || method == StencilMethod::one_sided ? test.front : test.back;
}

bool passes_stencil_test(const StencilFace& face, std::uint8_t stored, StencilMethod method) {
  if (method == StencilMethod::ignored) return true;
  const int mask = method == StencilMethod::unmasked ? 0xff : face.read_mask;
  const int left = face.reference & mask;
  const int right = stored & mask;
  const bool is_less = method == StencilMethod::stored_first ? right < left : left < right;
  return holds(face.function, is_less, left == right);
}

std::uint8_t after(StencilOperation operation, const StencilFace& face, std::uint8_t stored,
                   StencilMethod method) {
  if (method == StencilMethod::ignored) return stored;
  const int result = result_of(operation_by(operation, method), face.reference, stored);
  const int mask = method == StencilMethod::write_mask_ignored ? 0xff : face.write_mask;
  return static_cast<std::uint8_t>((result & mask) | (stored & ~mask));
}

Rule stencil_test_rule() {
  return {
      RuleId::stencil_test,
      "A fragment passes if the draw's comparison of reference and stored value holds",
      "17.3.3 (stencil test), with 17.4.2 (fine control of buffer updates)",
      "none",
      "as-set",
      alternatives_of<StencilMethod>(),
      {{41,
        "Stencil tests, equations, factors and masks are as set: nothing about them is open, and "
        "no bit of a stencil value is. Replayed over the renderer's own fragments they must "
        "yield what it stores, in some way that rulings 37 to 40 leave open."}}};
}

namespace {

CompareFunction function_by(CompareFunction function, DepthTestMethod method) {
  const bool ties_pass = method == DepthTestMethod::ties_pass;
  const bool ties_fail = method == DepthTestMethod::ties_fail;
  if (function == CompareFunction::less && ties_pass) return CompareFunction::lequal;
  if (function == CompareFunction::greater && ties_pass) return CompareFunction::gequal;
  if (function == CompareFunction::lequal && ties_fail) return CompareFunction::less;
  if (function == CompareFunction::gequal && ties_fail) return CompareFunction::greater;
  return function;
}

// The possible relations of a depth to a stored one.
struct Comparisons {
  bool less = false;
  bool equal = false;
  bool greater = false;
};

TestOutcomes outcomes_of(CompareFunction function, Comparisons may_be) {
  TestOutcomes outcomes;
  const auto add = [&](bool less, bool equal) {
    (holds(function, less, equal) ? outcomes.may_pass : outcomes.may_fail) = true;
  };
  if (may_be.less) add(true, false);
  if (may_be.equal) add(false, true);
  if (may_be.greater) add(false, false);
  return outcomes;
}

}  // namespace

bool passes_depth_test(const DepthTest& test, double depth, double stored, DepthFormat format,
                       DepthTestMethod method, DepthBits bits) {
  if (format == DepthFormat::none || method == DepthTestMethod::ignored) return true;
  const double compared =
      method == DepthTestMethod::unconverted ? depth : to_depth(depth, format, bits);
  return holds(function_by(test.function, method), compared < stored, compared == stored);
}

// Both ends of a range are values of the format, so overlapping ranges have one in common: the
// larger of the lower ends.
TestOutcomes permitted_outcomes(CompareFunction function, Interval depth, Interval stored,
                                bool same) {
  const bool overlap = depth.low <= stored.high && stored.low <= depth.high;
  return outcomes_of(function, {.less = !same && depth.low < stored.high,
                                .equal = same || overlap,
                                .greater = !same && depth.high > stored.low});
}

// Depths can be equal if both ranges contain a common value of the format.
TestOutcomes unconverted_outcomes(CompareFunction function, Interval depth, Interval stored,
                                  DepthFormat format) {
  const Interval common{std::max(depth.low, stored.low), std::min(depth.high, stored.high)};
  const double first = depth_permitted(common.low, format).high;
  return outcomes_of(function, {.less = depth.low < stored.high,
                                .equal = common.low <= common.high && first <= common.high,
                                .greater = depth.high > stored.low});
}

Rule depth_test_rule() {
  return {
      RuleId::depth_test,
      "A fragment passes if the draw's comparison of its depth with the stored one holds",
      "17.3.4 (depth buffer test), with 13.8.1 (controlling the viewport)",
      "none in the comparison; either outcome where the latitude of the depths leaves it open "
      "(ruling 39)",
      "as-set",
      alternatives_of<DepthTestMethod>(),
      {{39,
        "Depth tests: a fragment's depth is converted to the buffer's format and then compared "
        "with the stored value (13.8.1; 17.3.4). We compare the depths that the renderer itself "
        "reports, of the fragment and of the one whose depth is stored, each as either value "
        "that ruling 18 permits for it. If permitted pairs differ in order, the fragment may "
        "pass or fail, and all consequences must agree: a fragment that passes is blended, "
        "counted and stored, one that fails is none of these. Depths that the renderer reports "
        "as one and the same number are converted to one and the same value, and compare as "
        "equal. If the renderer reports no depth, any depth that rulings 9 and 38 permit is "
        "possible."},
       {kRulingOnUnconvertedDepth,
        "Contested: depths are compared as they are, before conversion, with what a fixed-point "
        "buffer stores. This must account for all samples of a case. 15.2.3 converts depths to "
        "fixed-point before the tests, as window depths are, and 14.6.5 has depths that differ by "
        "r distinct; without the conversion a depth may not equal itself as stored. But 13.8.1 "
        "lets window depths be floating-point numbers, and 17.3.4 names no conversion before the "
        "comparison. The Khronos tests with equal depths (dEQP-GLES3.functional.depth_stencil.*) "
        "pass only if the same depth compares as equal; none asks this by itself. OpenGL ES 3.2 "
        "has the same sentences (12.6.1, 14.2.3, 15.1.3)."}}};
}

Rule depth_mask_rule() {
  return {RuleId::depth_mask,
          "Masked depths are not stored",
          "17.4.2 (fine control of buffer updates)",
          "none",
          "as-set",
          alternatives_of<DepthMaskMethod>(),
          {}};
}

}  // namespace edgecase
