// SPDX-License-Identifier: MIT
#include "diff/output/test_of_one_sample.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "rules/output/fragment_tests.h"

namespace edgecase {
namespace {

// A sample, and the one whose tests decide for it.
struct Pair {
  PermittedSample own;
  PermittedSample tested;
};

// Pairs beyond this number are not followed: then the pixel does not agree.
constexpr std::size_t kMostPairs = 16 * kMostStates;

// A sample's arrivals, matched with the pixel's fragments: null for those that do not cover it.
std::vector<const Arrival*> by_fragment(const std::vector<Arrival>& arrivals,
                                        std::span<const Fragment> fragments) {
  std::vector<const Arrival*> matched;
  auto next = arrivals.begin();
  for (const Fragment& fragment : fragments) {
    const bool covers = next != arrivals.end() && next->fragment == &fragment;
    matched.push_back(covers ? &*next++ : nullptr);
  }
  return matched;
}

// The outcome of the tested sample decides. Where the new stencil value is the old one, other
// samples may be set to it, as the letter has it, or be left as they are.
void add_shared(const Pair& before, const Arrival& own, const PermittedSample& outcome,
                const OutputRules& by, std::vector<Pair>& next) {
  const bool passes = outcome.hits != before.tested.hits;
  PermittedSample state =
      passes ? written(own.values, *own.operations, by, before.own) : before.own;
  const bool is_changed = outcome.stencil != before.tested.stencil;
  if (!is_changed) next.push_back({state, outcome});
  if (by.target.stencil == StencilFormat::none || !own.operations->stencil) return;
  const unsigned mask =
      face_of(*own.operations->stencil, own.values.front_facing, by.choice.stencil).write_mask;
  state.stencil =
      static_cast<std::uint8_t>((before.own.stencil & ~mask) | (outcome.stencil & mask));
  if (is_changed || state.stencil != before.own.stencil) next.push_back({state, outcome});
}

void add_after(const Pair& before, const Arrival* own, const Arrival* tested, const OutputRules& by,
               std::vector<Pair>& next) {
  const auto after = [&](const PermittedSample& state, const Arrival* arrival) {
    return arrival == nullptr ? std::vector{state} : states_after(state, *arrival, by);
  };
  const bool shares_tests = own != nullptr && tested != nullptr && own->is_unsampled;
  for (const PermittedSample& outcome : after(before.tested, tested)) {
    if (shares_tests)
      add_shared(before, *own, outcome, by, next);
    else
      for (const PermittedSample& state : after(before.own, own)) next.push_back({state, outcome});
  }
}

std::vector<Pair> replayed(const std::vector<const Arrival*>& own,
                           const std::vector<const Arrival*>& tested, const OutputRules& by) {
  const auto cleared = cleared_sample<PermittedNumbers>(by.target);
  std::vector<Pair> pairs{{cleared, cleared}};
  for (std::size_t i = 0; i < own.size() && pairs.size() <= kMostPairs; ++i) {
    std::vector<Pair> next;
    for (const Pair& pair : pairs) add_after(pair, own[i], tested[i], by, next);
    pairs = std::move(next);
  }
  if (pairs.size() > kMostPairs) pairs.clear();
  return pairs;
}

}  // namespace

bool may_test_one_sample(std::span<const OperationsQuestion> pixel) {
  const Target& target = pixel.front().target();
  return std::ranges::any_of(pixel.front().arrivals({}), [&](const Arrival& arrival) {
    const FragmentOperations& operations = *arrival.operations;
    const bool has_depth_test =
        target.depth != DepthFormat::none && operations.depth.function != CompareFunction::always;
    const bool has_stencil_test = target.stencil != StencilFormat::none && operations.stencil;
    return arrival.is_unsampled && (has_depth_test || has_stencil_test);
  });
}

bool agrees_by_test_of(std::span<const OperationsQuestion> pixel, int tested) {
  const OperationsQuestion& deciding = pixel[static_cast<std::size_t>(tested)];
  const DepthFormat format = deciding.target().depth;
  const std::vector<Arrival> arrivals = deciding.arrivals({});
  const auto deciding_arrivals = by_fragment(arrivals, deciding.fragments());
  const OutputRules rules{deciding.target(), standard_choices().output, kAllPermitted};
  return std::ranges::all_of(pixel, [&](const OperationsQuestion& own) {
    if (own.sample == tested) return own.agrees({}, kAllPermitted);
    const std::vector<Arrival> own_arrivals = own.arrivals({});
    return std::ranges::any_of(
        replayed(by_fragment(own_arrivals, own.fragments()), deciding_arrivals, rules),
        [&](const Pair& pair) {
          return agrees(pair.own, own.stored, format) &&
                 agrees(pair.tested, deciding.stored, format);
        });
  });
}

}  // namespace edgecase
