// SPDX-License-Identifier: MIT
#include "rules/output/fragment_outcome.h"

#include <algorithm>

namespace edgecase {
namespace {

bool follows_any(OutcomeScope scope, CompareFunction function) {
  return scope == OutcomeScope::any && function != CompareFunction::always;
}

}  // namespace

PermittedNumbers::Codes written_color(const FragmentOperations& operations,
                                      const PermittedNumbers::Color& source,
                                      const PermittedNumbers::Codes& destination,
                                      const BlendChoice& choice) {
  PermittedNumbers::Codes result;
  result.exact = written_color(operations, source.exact, destination.exact, choice);
  if (choice.method == BlendMethod::as_set)
    result.permitted =
        permitted_color(operations, source.permitted, destination.permitted, choice.mask);
  else
    std::ranges::transform(result.exact, result.permitted.begin(), [](std::uint8_t code) {
      return Unorm8Range{code, code};
    });
  return result;
}

PermittedNumbers::Depth to_depth(const PermittedNumbers::Depth& depth, DepthFormat format,
                                 DepthBits bits) {
  const double exact = to_depth(depth.exact, format, bits);
  const bool is_as_set = bits == DepthBits::as_set;
  return {{exact, is_as_set ? depth_permitted(depth.permitted, format) : Interval(exact)},
          depth.reported};
}

TestOutcomes depth_outcomes(const DepthTest& test, double depth, double stored,
                            const OutputRules& by) {
  if (by.target.depth != DepthFormat::none && follows_any(by.freedom.depth_test, test.function))
    return {true, true};
  const bool passes = passes_depth_test(test, depth, stored, by.target.depth, by.choice.depth,
                                        by.choice.depth_bits);
  return {passes, !passes};
}

TestOutcomes depth_outcomes(const DepthTest& test, const PermittedNumbers::Depth& depth,
                            const PermittedNumbers::Depth& stored, const OutputRules& by) {
  const DepthFormat format = by.target.depth;
  const bool is_open =
      by.freedom.depth_test == OutcomeScope::permitted && format != DepthFormat::none;
  if (is_open && by.choice.depth == DepthTestMethod::unconverted)
    return unconverted_outcomes(test.function, depth.permitted, stored.permitted, format);
  if (!is_open || by.choice.depth != DepthTestMethod::as_set ||
      by.choice.depth_bits != DepthBits::as_set)
    return depth_outcomes(test, depth.exact, stored.exact, by);
  return permitted_outcomes(test.function, depth_permitted(depth.permitted, format),
                            stored.permitted, depth.reported && depth.reported == stored.reported);
}

TestOutcomes stencil_outcomes(const StencilFace* face, std::uint8_t stored, const OutputRules& by) {
  if (face == nullptr) return {true, false};
  if (follows_any(by.freedom.stencil_test, face->function)) return {true, true};
  const bool passes = passes_stencil_test(*face, stored, by.choice.stencil);
  return {passes, !passes};
}

FragmentOutcome apply(const ExactFragment& fragment, const FragmentOperations& operations,
                      const OutputRules& by, ExactSample& sample) {
  FragmentOutcome result{};
  for_each_outcome(fragment, operations, by, ExactSample(sample),
                   [&](const ExactSample& after, FragmentOutcome outcome) {
                     sample = after;
                     result = outcome;
                   });
  return result;
}

}  // namespace edgecase
