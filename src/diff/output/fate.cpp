// SPDX-License-Identifier: MIT
#include "diff/output/fate.h"

#include <algorithm>
#include <map>
#include <utility>

#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

bool is_equal(const Rgba8Range& a, const Rgba8Range& b) {
  return std::ranges::equal(a, b, [](Unorm8Range one, Unorm8Range other) {
    return one.low == other.low && one.high == other.high;
  });
}

bool is_equal(const FateState& a, const FateState& b) {
  return a.color == b.color && is_equal(a.permitted_color, b.permitted_color) &&
         a.depth == b.depth && a.permitted_depth.low == b.permitted_depth.low &&
         a.permitted_depth.high == b.permitted_depth.high && a.source == b.source &&
         a.stencil == b.stencil && a.hits == b.hits && a.blended == b.blended;
}

// The state that permits all that either does.
FateState merged(FateState a, const FateState& b) {
  for (std::size_t c = 0; c < 4; ++c) {
    a.permitted_color[c].low = std::min(a.permitted_color[c].low, b.permitted_color[c].low);
    a.permitted_color[c].high = std::max(a.permitted_color[c].high, b.permitted_color[c].high);
  }
  a.permitted_depth = hull(a.permitted_depth, b.permitted_depth);
  if (a.source != b.source) a.source.reset();
  a.blended = a.blended || b.blended;
  return a;
}

std::vector<FateState> merged(const std::vector<FateState>& states) {
  std::map<std::pair<std::uint8_t, std::uint32_t>, FateState> by_count;
  for (const FateState& state : states) {
    const auto [place, is_new] = by_count.try_emplace({state.stencil, state.hits}, state);
    if (!is_new) place->second = merged(place->second, state);
  }
  std::vector<FateState> result;
  for (const auto& [key, state] : by_count) result.push_back(state);
  return result;
}

void add(const FateState& state, std::vector<FateState>& states) {
  const bool known =
      std::ranges::any_of(states, [&](const FateState& other) { return is_equal(state, other); });
  if (!known) states.push_back(state);
}

FateState with_step(FateState state, FateStep step) {
  state.last = step;
  return state;
}

}  // namespace

FateState Replay::cleared() const {
  FateState state;
  for (std::size_t c = 0; c < 4; ++c) {
    const auto component = static_cast<double>(target_.clear[c]);
    state.color[c] = to_unorm8(component);
    state.permitted_color[c] = unorm8_permitted(component);
  }
  const auto depth = static_cast<double>(target_.clear_depth);
  state.depth = to_depth(depth, target_.depth);
  state.permitted_depth = depth_permitted(depth, target_.depth);
  state.stencil = target_.clear_stencil;
  return state;
}

std::vector<FateState> Replay::run(std::span<const Arrival> arrivals) const {
  std::vector<FateState> states{cleared()};
  for (const Arrival& arrival : arrivals) states = after(states, arrival);
  return states;
}

std::vector<FateState> Replay::after(const std::vector<FateState>& states,
                                     const Arrival& arrival) const {
  std::vector<FateState> next;
  for (const FateState& state : states) add_after(state, arrival, next);
  return next.size() > kMostStates ? merged(next) : next;
}

void Replay::add_after(const FateState& state, const Arrival& arrival,
                       std::vector<FateState>& next) const {
  Outcomes kept{arrival.is_kept, !arrival.is_kept};
  const bool is_open = arrival.may_be_dropped || !arrival.is_kept;
  if (freedom_.alpha == FateScope::permitted) kept = {arrival.may_be_kept, arrival.may_be_dropped};
  if (freedom_.alpha == FateScope::any && is_open) kept = {true, true};
  if (kept.fail) add(with_step(state, FateStep::dropped), next);
  if (!kept.pass) return;
  add_tested(state, arrival, arrival.front_facing, next);
  if (freedom_.facing == FateScope::permitted && arrival.may_face_otherwise)
    add_tested(state, arrival, !arrival.front_facing, next);
}

void Replay::add_tested(const FateState& state, const Arrival& arrival, bool front_facing,
                        std::vector<FateState>& next) const {
  const FragmentOperations& operations = *arrival.operations;
  const bool has_stencil = target_.stencil != StencilFormat::none && operations.stencil;
  const StencilFace* face = nullptr;
  if (has_stencil) face = &face_of(*operations.stencil, front_facing, output_.stencil);
  const auto with = [&](FateState reached, StencilOperation StencilFace::*operation,
                        FateStep step) {
    if (face != nullptr)
      reached.stencil = edgecase::after(face->*operation, *face, reached.stencil, output_.stencil);
    add(with_step(std::move(reached), step), next);
  };
  const Outcomes stencil = face != nullptr ? stencil_outcomes(state, *face) : Outcomes{true, false};
  if (stencil.fail) with(state, &StencilFace::fail, FateStep::stencil_failed);
  if (!stencil.pass) return;
  const Outcomes depth = depth_outcomes(state, arrival);
  if (depth.fail) with(state, &StencilFace::depth_fail, FateStep::depth_failed);
  if (!depth.pass) return;
  for (FateState& reached : written_depths(written(state, arrival), arrival))
    with(std::move(reached), &StencilFace::pass, FateStep::passed);
}

Replay::Outcomes Replay::stencil_outcomes(const FateState& state, const StencilFace& face) const {
  if (freedom_.stencil_test == FateScope::any && face.function != CompareFunction::always)
    return {true, true};
  const bool passes = passes_stencil_test(face, state.stencil, output_.stencil);
  return {passes, !passes};
}

Replay::Outcomes Replay::depth_outcomes(const FateState& state, const Arrival& arrival) const {
  if (target_.depth == DepthFormat::none) return {true, false};
  const DepthTest& test = arrival.operations->depth;
  if (freedom_.depth_test == FateScope::any && test.function != CompareFunction::always)
    return {true, true};
  if (compares_unconverted()) {
    const auto [may_pass, may_fail] = unconverted_outcomes(test.function, arrival.permitted_depth,
                                                           state.permitted_depth, target_.depth);
    return {may_pass, may_fail};
  }
  if (freedom_.depth_test == FateScope::exact || output_.depth != DepthTestMethod::as_set) {
    const bool passes =
        passes_depth_test(test, arrival.depth, state.depth, target_.depth, output_.depth);
    return {passes, !passes};
  }
  const bool same = arrival.told_depth && arrival.told_depth == state.source;
  const auto [may_pass, may_fail] =
      permitted_outcomes(test.function, depth_permitted(arrival.permitted_depth, target_.depth),
                         state.permitted_depth, same);
  return {may_pass, may_fail};
}

// Where depths are compared unconverted, it matters which of two neighbours was stored of a depth:
// each has a state of its own.
std::vector<FateState> Replay::written_depths(FateState state, const Arrival& arrival) const {
  const auto [low, high] = state.permitted_depth;
  const bool is_own = state.source && state.source == arrival.told_depth;
  if (!compares_unconverted() || !is_own || low == high) return {std::move(state)};
  std::vector<FateState> states(2, state);
  states[0].depth = low;
  states[0].permitted_depth = low;
  states[1].depth = high;
  states[1].permitted_depth = high;
  return states;
}

FateState Replay::written(FateState state, const Arrival& arrival) const {
  FragmentOperations operations = *arrival.operations;
  const Rgba8 before = state.color;
  state.color = written_color(operations, arrival.color, before, output_.blend);
  if (output_.blend.mask == ColorMaskMethod::ignored) operations.color_mask.fill(true);
  if (output_.blend.method == BlendMethod::as_set) {
    state.permitted_color =
        permitted_color(operations, arrival.permitted_color, state.permitted_color);
  } else {
    // Nothing says what may come of another equation but what it yields.
    for (std::size_t c = 0; c < 4; ++c) state.permitted_color[c] = {state.color[c], state.color[c]};
  }
  const bool all = std::ranges::all_of(operations.color_mask, [](bool on) { return on; });
  state.blended = operations.blending || (state.blended && !all);
  if (target_.depth != DepthFormat::none && arrival.writes_depth &&
      stores_depth(operations.depth, output_.depth_mask)) {
    state.depth = to_depth(arrival.depth, target_.depth);
    state.permitted_depth = depth_permitted(arrival.permitted_depth, target_.depth);
    state.source = arrival.told_depth;
  }
  ++state.hits;
  return state;
}

namespace {

bool permits(const FateState& state, const std::uint8_t* color) {
  for (std::size_t c = 0; c < 4; ++c)
    if (color[c] < state.permitted_color[c].low || color[c] > state.permitted_color[c].high)
      return false;
  return true;
}

// A range of depths holds numbers between the format's values too.
bool permits(const FateState& state, double depth, DepthFormat format) {
  if (depth == state.depth) return true;
  return is_depth_of(depth, format) && state.permitted_depth.contains(depth);
}

}  // namespace

bool agrees(const FateState& state, const StoredSample& stored, DepthFormat format,
            FatePlanes planes) {
  if (planes.stencil && stored.stencil && *stored.stencil != state.stencil) return false;
  if (planes.hits && stored.hits && *stored.hits != state.hits) return false;
  if (planes.color && stored.color != nullptr && !permits(state, stored.color)) return false;
  return !planes.depth || !stored.depth || permits(state, *stored.depth, format);
}

bool any_agrees(std::span<const FateState> states, const StoredSample& stored, DepthFormat format,
                FatePlanes planes) {
  return std::ranges::any_of(
      states, [&](const FateState& state) { return agrees(state, stored, format, planes); });
}

bool has_color(const FateState& state, const StoredSample& stored) {
  return stored.color == nullptr ||
         std::equal(state.color.begin(), state.color.end(), stored.color);
}

bool is_exact(const FateState& state, const StoredSample& stored) {
  return has_color(state, stored) && (!stored.depth || *stored.depth == state.depth) &&
         (!stored.stencil || *stored.stencil == state.stencil) &&
         (!stored.hits || *stored.hits == state.hits);
}

}  // namespace edgecase
