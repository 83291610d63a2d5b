// SPDX-License-Identifier: MIT
#include "rules/output/stencil_test.h"

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
  return static_cast<std::uint8_t>((result & face.write_mask) | (stored & ~face.write_mask));
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

}  // namespace edgecase
