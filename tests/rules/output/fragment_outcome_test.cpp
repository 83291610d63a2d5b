// SPDX-License-Identifier: MIT
//
// What becomes of a fragment is one function over a kind of number. Exact numbers have the literal
// oracle's outcome, permitted numbers without width the same one, and permitted numbers with width
// every outcome that exact numbers within them have.
#include "rules/output/fragment_outcome.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/raster/operation_oracle.h"
#include "tests/raster/random_operations.h"

namespace edgecase {
namespace {

constexpr CompareFunction kFunctions[] = {CompareFunction::never,   CompareFunction::less,
                                          CompareFunction::equal,   CompareFunction::lequal,
                                          CompareFunction::greater, CompareFunction::notequal,
                                          CompareFunction::gequal,  CompareFunction::always};
constexpr DepthFormat kDepths[] = {DepthFormat::none, DepthFormat::depth16, DepthFormat::depth24,
                                   DepthFormat::depth32f};

Target target_with(DepthFormat depth, StencilFormat stencil) {
  Target target;
  target.width = target.height = 1;
  target.depth = depth;
  target.stencil = stencil;
  return target;
}

struct Step {
  PermittedSample sample;
  FragmentOutcome outcome;
};

std::vector<Step> steps_of(const PermittedFragment& fragment, const FragmentOperations& operations,
                           const OutputRules& by, const PermittedSample& stored) {
  std::vector<Step> steps;
  for_each_outcome(fragment, operations, by, stored,
                   [&](const PermittedSample& sample, FragmentOutcome outcome) {
                     steps.push_back({sample, outcome});
                   });
  return steps;
}

PermittedSample without_width(const ExactSample& sample) {
  PermittedSample result;
  result.color.exact = sample.color;
  for (std::size_t c = 0; c < 4; ++c)
    result.color.permitted[c] = {sample.color[c], sample.color[c]};
  result.depth = PermittedNumbers::depth(sample.depth);
  result.stencil = sample.stencil;
  result.hits = sample.hits;
  result.blended = sample.blended;
  result.operated = sample.operated;
  return result;
}

PermittedFragment without_width(const ExactFragment& fragment) {
  return {PermittedNumbers::color(fragment.color), PermittedNumbers::depth(fragment.depth),
          fragment.front_facing, fragment.writes_depth};
}

// All three at one fragment. The values must be ones that every format holds: 0 and 1.
void expect_one_outcome(const ExactFragment& fragment, const FragmentOperations& operations,
                        const Target& target, const ExactSample& before) {
  ExactSample exact = before;
  const FragmentOutcome outcome = apply(fragment, operations, {target, {}}, exact);
  const auto steps = steps_of(without_width(fragment), operations, {target, {}, kAllPermitted},
                              without_width(before));
  ASSERT_EQ(steps.size(), 1U);
  ASSERT_EQ(steps[0].outcome, outcome);
  ASSERT_TRUE(steps[0].sample == without_width(exact));

  oracle::Stored stored{{}, before.depth, before.stencil, before.hits};
  std::copy(before.color.begin(), before.color.end(), stored.color.begin());
  oracle::arrive({fragment.color, fragment.depth, fragment.front_facing}, operations, target,
                 stored);
  ASSERT_TRUE(std::equal(exact.color.begin(), exact.color.end(), stored.color.begin()));
  ASSERT_EQ(exact.depth, stored.depth);
  ASSERT_EQ(exact.stencil, stored.stencil);
  ASSERT_EQ(exact.hits, stored.hits);
  ASSERT_EQ(outcome == FragmentOutcome::passed, exact.hits == before.hits + 1);
}

// The three operations differ, and each is each of the three once.
StencilFace face_with(CompareFunction function, int reference, int operation) {
  const auto rotated = [&](int by) { return static_cast<StencilOperation>((operation + by) % 8); };
  return {function,  static_cast<std::uint8_t>(reference), 0xff, 0x7f, rotated(0), rotated(1),
          rotated(3)};
}

// Each relation of the depths and of the stencil values under each function, operation and mask.
TEST(FragmentOutcome, IsTheSameForExactNumbersAndForRangesWithoutWidth) {
  for (const DepthFormat format : kDepths)
    for (const CompareFunction depth_function : kFunctions)
      for (int bits = 0; bits < 8; ++bits) {
        FragmentOperations operations;
        operations.depth = {depth_function, (bits & 1) != 0};
        const ExactFragment fragment{{1, 0, 1, 0}, (bits & 2) != 0 ? 1.0 : 0.0};
        ExactSample before{{0, 255, 0, 255}, (bits & 4) != 0 ? 1.0 : 0.0, 1};
        expect_one_outcome(fragment, operations, target_with(format, StencilFormat::none), before);
        const Target target = target_with(format, StencilFormat::stencil8);
        for (const CompareFunction function : kFunctions)
          for (const int reference : {0, 1, 255})
            for (int operation = 0; operation < 8; ++operation) {
              before.stencil = operation % 2 == 0 ? 1 : 255;
              operations.stencil = {face_with(function, reference, operation), {}};
              expect_one_outcome(fragment, operations, target, before);
              if (HasFatalFailure()) return;
            }
      }
}

TEST(FragmentOutcome, OfABackFaceIsByItsOwnState) {
  FragmentOperations operations;
  operations.stencil = {face_with(CompareFunction::never, 1, 2),
                        face_with(CompareFunction::always, 1, 1)};
  const Target target = target_with(DepthFormat::none, StencilFormat::stencil8);
  for (const bool front_facing : {false, true}) {
    const ExactFragment fragment{{}, 0, front_facing};
    expect_one_outcome(fragment, operations, target, {});
    ExactSample sample;
    EXPECT_EQ(apply(fragment, operations, {target, {}}, sample),
              front_facing ? FragmentOutcome::stencil_failed : FragmentOutcome::passed);
  }
}

// All equations, factors and masks, of operands that are 0 or 1.
TEST(FragmentOutcome, BlendsAlikeInBothKindsOfNumber) {
  const Target target = target_with(DepthFormat::none, StencilFormat::none);
  for (int equation = 0; equation < 5; ++equation)
    for (int source = 0; source < 15; ++source)
      for (int destination = 0; destination < 15; ++destination)
        for (int bits = 0; bits < 16; ++bits) {
          const BlendTerm term{static_cast<BlendEquation>(equation),
                               static_cast<BlendFactor>(source),
                               static_cast<BlendFactor>(destination)};
          FragmentOperations operations;
          operations.blending = Blending{term, term, {0, 1, 1, 0}};
          for (std::size_t c = 0; c < 4; ++c) operations.color_mask[c] = (bits >> c & 1) != 0;
          const double alpha = bits % 3 == 0 ? 0 : 1;
          expect_one_outcome({{1, 0, 1, alpha}}, operations, target, {{0, 255, 255, 0}});
          if (HasFatalFailure()) return;
        }
}

// ---------------------------------------------------------------------------------------- ranges

double number_within(Interval range, RandomScenes& random) {
  return std::clamp(range.low + (range.high - range.low) * random.below(9) / 8, range.low,
                    range.high);
}

// Some of them without width.
Interval any_range(RandomScenes& random) {
  const double low = random.below(17) / 16.0;
  return {low, low + random.below(3) / 16.0};
}

PermittedFragment any_fragment(RandomScenes& random) {
  PermittedFragment fragment;
  for (Interval& component : fragment.color.permitted) component = any_range(random);
  fragment.depth.permitted = any_range(random);
  fragment.front_facing = random.below(2) == 0;
  return fragment;
}

ExactFragment any_within(const PermittedFragment& fragment, RandomScenes& random) {
  ExactFragment result{{}, number_within(fragment.depth.permitted, random), fragment.front_facing};
  for (std::size_t c = 0; c < 4; ++c)
    result.color[c] = number_within(fragment.color.permitted[c], random);
  return result;
}

bool contains(const PermittedSample& range, const ExactSample& exact) {
  for (std::size_t c = 0; c < 4; ++c)
    if (exact.color[c] < range.color.permitted[c].low ||
        exact.color[c] > range.color.permitted[c].high)
      return false;
  return range.depth.permitted.contains(exact.depth) && range.stencil == exact.stencil &&
         range.hits == exact.hits;
}

// Three fragments at one sample; wherever exact's lie within the ranges, so does what is stored.
TEST(FragmentOutcome, OfRangesHoldsThatOfEveryNumberWithin) {
  RandomScenes random(91);
  long branched = 0;
  for (int i = 0; i < 10000; ++i) {
    Target target = target_with(kDepths[i % 4], StencilFormat::stencil8);
    target.clear_depth = static_cast<float>(random.below(17)) / 16;
    std::vector<PermittedSample> states{cleared_sample<PermittedNumbers>(target)};
    std::vector<ExactSample> samples(8, cleared_sample<ExactNumbers>(target));
    for (int step = 0; step < 3; ++step) {
      FragmentOperations operations = random_operations(random);
      operations.depth.function = kFunctions[random.below(8)];
      const PermittedFragment fragment = any_fragment(random);
      std::vector<PermittedSample> next;
      for (const PermittedSample& state : states) {
        const auto steps = steps_of(fragment, operations, {target, {}, kAllPermitted}, state);
        branched += steps.size() > 1;
        for (const Step& reached : steps) next.push_back(reached.sample);
      }
      states = next;
      for (ExactSample& sample : samples) {
        apply(any_within(fragment, random), operations, {target, {}}, sample);
        ASSERT_TRUE(std::ranges::any_of(
            states, [&](const PermittedSample& state) { return contains(state, sample); }))
            << i << ", fragment " << step;
      }
    }
  }
  EXPECT_GT(branched, 1000);
}

}  // namespace
}  // namespace edgecase
