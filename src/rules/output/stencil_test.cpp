// SPDX-License-Identifier: MIT
#include "rules/output/stencil_test.h"

#include "rules/alternative_table.h"

namespace edgecase {
namespace {

constexpr TabledAlternative<StencilMethod> kMethods[] = {
    {StencilMethod::as_set, "as-set", Openness::mandated,
     "the masked reference is compared with the masked stored value; the outcome's operation is "
     "carried out under the write mask"},
    {StencilMethod::ignored, "ignored", Openness::illegal,
     "there is no test, and stored values stay"},
    {StencilMethod::one_sided, "one-sided", Openness::illegal,
     "back-facing polygons are treated as front-facing ones"},
    {StencilMethod::unmasked, "unmasked", Openness::illegal, "the comparison uses no mask"},
    {StencilMethod::stored_first, "stored-first", Openness::illegal,
     "the stored value is compared with the reference, which exchanges less and greater"},
    {StencilMethod::wrapping, "wrapping", Openness::illegal,
     "incr and decr wrap, as incr_wrap and decr_wrap do"},
    {StencilMethod::saturating, "saturating", Openness::illegal,
     "incr_wrap and decr_wrap stop at 255 and 0, as incr and decr do"}};
constexpr auto kAllMethods = values_in(kMethods);

StencilOperation operation_by(StencilOperation operation, StencilMethod method) {
  const bool wraps = method == StencilMethod::wrapping;
  const bool saturates = method == StencilMethod::saturating;
  if (operation == StencilOperation::incr && wraps) return StencilOperation::incr_wrap;
  if (operation == StencilOperation::decr && wraps) return StencilOperation::decr_wrap;
  if (operation == StencilOperation::incr_wrap && saturates) return StencilOperation::incr;
  if (operation == StencilOperation::decr_wrap && saturates) return StencilOperation::decr;
  return operation;
}

// Before the write mask: the lowest 8 bits count.
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

std::span<const StencilMethod> all_stencil_methods() {
  return kAllMethods;
}

const char* name_of(StencilMethod choice) {
  return name_in(kMethods, choice);
}

bool parse_name(std::string_view name, StencilMethod& choice) {
  return find_in(kMethods, name, choice);
}

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
      "stencil.test",
      "A fragment passes if the draw's comparison of reference and stored value holds",
      "17.3.3 (stencil test), with 17.4.2 (fine control of buffer updates)",
      "none",
      "as-set",
      alternatives_in(kMethods),
      {{41,
        "Stencil tests, equations, factors and masks are as set: of them nothing is open, and of "
        "stencil values no bit. Replayed over the renderer's own fragments they must yield what "
        "it stores, in some way that rulings 37 to 40 leave open."}}};
}

}  // namespace edgecase
