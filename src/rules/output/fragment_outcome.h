// SPDX-License-Identifier: MIT
//
// The outcome of a fragment at one sample of the target (GL 4.6 core, 17.3 and 17.4.2), once for
// every kind of number:
//
//   stencil test -> depth test -> blending -> colour mask -> depth mask
//
// A kind of number names the types of the values that a fragment brings and that a sample stores,
// with a `written_color`, a `to_depth` and `depth_outcomes` of these types. A test of exact
// numbers has one outcome. Permitted numbers are an exact number with the range of all that may
// stand in its place, so a test of them may go either way: then all outcomes are followed.
//
// Scissor, coverage and alpha to coverage decide earlier which samples a fragment stands for.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "exact/interval.h"
#include "model/fragment_operations.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

struct ExactNumbers {
  using Color = std::array<double, 4>;  // red, green, blue, alpha; NaN counts as 0
  using Codes = Rgba8;
  using Depth = double;
  static Color color(const std::array<double, 4>& exact) { return exact; }
  static Depth depth(double exact) { return exact; }
};

template <class Exact, class Range>
struct Permitted {
  Exact exact{};
  Range permitted{};
  friend bool operator==(const Permitted&, const Permitted&) = default;
};

struct PermittedNumbers {
  using Color = Permitted<ExactNumbers::Color, std::array<Interval, 4>>;
  using Codes = Permitted<Rgba8, Rgba8Range>;
  struct Depth : Permitted<double, Interval> {
    // The depth before conversion, if the renderer reported it: where two are the same, so are the
    // numbers that they are converted to, whichever these are.
    std::optional<double> reported = std::nullopt;
    friend bool operator==(const Depth&, const Depth&) = default;
  };
  // Nothing but the exact number is permitted.
  static Color color(const std::array<double, 4>& exact) {
    return {exact, {exact[0], exact[1], exact[2], exact[3]}};
  }
  static Depth depth(double exact) { return {{exact, exact}}; }
};

// What a fragment brings to a sample, before conversion to the target's formats.
template <class Numbers>
struct FragmentValues {
  typename Numbers::Color color{};  // the shader's output
  typename Numbers::Depth depth{};  // 0 to 1, at the sample
  bool front_facing = true;
  bool writes_depth = true;  // if the draw writes depth at all
};
using ExactFragment = FragmentValues<ExactNumbers>;
using PermittedFragment = FragmentValues<PermittedNumbers>;

template <class Numbers>
struct SampleValues {
  typename Numbers::Codes color{};
  typename Numbers::Depth depth{};  // a value of the format
  std::uint8_t stencil = 0;
  std::uint32_t hits = 0;  // fragments that passed all tests
  bool blended = false;    // something that is stored is the result of blending
  // Under StencilMethod::once_a_draw: the draw that changed the stencil value last.
  const FragmentOperations* operated = nullptr;
  friend bool operator==(const SampleValues&, const SampleValues&) = default;
};
using ExactSample = SampleValues<ExactNumbers>;
using PermittedSample = SampleValues<PermittedNumbers>;

enum class FragmentOutcome : unsigned char { dropped, stencil_failed, depth_failed, passed };

// The outcomes of a step that are followed: exact's, all that the specification permits, or any.
enum class OutcomeScope : unsigned char { exact, permitted, any };

// Of exact numbers, `permitted` is the same as `exact`. Facing and alpha to coverage are followed
// by who knows what is permitted of them.
struct OperationsFreedom {
  OutcomeScope depth_test = OutcomeScope::exact;
  OutcomeScope stencil_test = OutcomeScope::exact;  // no other is permitted
  OutcomeScope facing = OutcomeScope::exact;
  OutcomeScope alpha = OutcomeScope::exact;
};
inline constexpr OperationsFreedom kAllPermitted{OutcomeScope::permitted, OutcomeScope::exact,
                                                 OutcomeScope::permitted, OutcomeScope::permitted};

// What decides about all fragments of a target alike.
struct OutputRules {
  const Target& target;
  OutputChoice choice;
  OperationsFreedom freedom = {};
};

// For a choice that is not the specification's, only its own result is known to be possible.
PermittedNumbers::Codes written_color(const FragmentOperations& operations,
                                      const PermittedNumbers::Color& source,
                                      const PermittedNumbers::Codes& destination,
                                      const BlendChoice& choice);

PermittedNumbers::Depth to_depth(const PermittedNumbers::Depth& depth, DepthFormat format,
                                 DepthBits bits);

// Without a depth buffer every fragment passes.
TestOutcomes depth_outcomes(const DepthTest& test, double depth, double stored,
                            const OutputRules& by);
TestOutcomes depth_outcomes(const DepthTest& test, const PermittedNumbers::Depth& depth,
                            const PermittedNumbers::Depth& stored, const OutputRules& by);
// Null: no test.
TestOutcomes stencil_outcomes(const StencilFace* face, std::uint8_t stored, const OutputRules& by);

template <class Numbers>
SampleValues<Numbers> cleared_sample(const Target& target) {
  std::array<double, 4> color{};
  std::copy(target.clear.begin(), target.clear.end(), color.begin());
  SampleValues<Numbers> sample;
  sample.color = written_color({}, Numbers::color(color), {}, BlendChoice{});
  sample.depth = to_depth(Numbers::depth(static_cast<double>(target.clear_depth)), target.depth,
                          DepthBits::as_set);
  sample.stencil = target.clear_stencil;
  return sample;
}

// A sample after a fragment that has passed all tests, which leaves the stencil value as it is.
template <class Numbers>
SampleValues<Numbers> written(const FragmentValues<Numbers>& fragment,
                              const FragmentOperations& operations, const OutputRules& by,
                              SampleValues<Numbers> sample) {
  sample.color = written_color(operations, fragment.color, sample.color, by.choice.blend);
  sample.blended = operations.blending ||
                   (sample.blended && !writes_all_components(operations, by.choice.blend.mask));
  if (by.target.depth != DepthFormat::none && fragment.writes_depth &&
      stores_depth(operations.depth, by.choice.depth_mask))
    sample.depth = to_depth(fragment.depth, by.target.depth, by.choice.depth_bits);
  ++sample.hits;
  return sample;
}

// Calls `visit` with the sample after each outcome that is followed, and the outcome; for exact
// numbers and no freedom, once.
template <class Numbers, class Visit>
void for_each_outcome(const FragmentValues<Numbers>& fragment, const FragmentOperations& operations,
                      const OutputRules& by, const SampleValues<Numbers>& stored,
                      const Visit& visit) {
  const StencilFace* face = nullptr;
  if (by.target.stencil != StencilFormat::none && operations.stencil)
    face = &face_of(*operations.stencil, fragment.front_facing, by.choice.stencil);
  const auto end = [&](SampleValues<Numbers> sample, StencilOperation StencilFace::*operation,
                       FragmentOutcome outcome) {
    const bool is_first = by.choice.stencil != StencilMethod::once_a_draw ||
                          std::exchange(sample.operated, &operations) != &operations;
    if (face != nullptr && is_first)
      sample.stencil = after(face->*operation, *face, sample.stencil, by.choice.stencil);
    visit(sample, outcome);
  };
  const TestOutcomes stencil = stencil_outcomes(face, stored.stencil, by);
  if (stencil.may_fail) end(stored, &StencilFace::fail, FragmentOutcome::stencil_failed);
  if (!stencil.may_pass) return;
  const TestOutcomes depth = depth_outcomes(operations.depth, fragment.depth, stored.depth, by);
  if (depth.may_fail) end(stored, &StencilFace::depth_fail, FragmentOutcome::depth_failed);
  if (depth.may_pass)
    end(written(fragment, operations, by, stored), &StencilFace::pass, FragmentOutcome::passed);
}

// Exact's outcome. `sample` becomes what is stored after it.
FragmentOutcome apply(const ExactFragment& fragment, const FragmentOperations& operations,
                      const OutputRules& by, ExactSample& sample);

}  // namespace edgecase
