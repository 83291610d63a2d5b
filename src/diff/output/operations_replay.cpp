// SPDX-License-Identifier: MIT
#include "diff/output/operations_replay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "diff/values/ignored_multisample.h"
#include "diff/values/pixel_truth.h"
#include "diff/values/sample_writers.h"
#include "raster/coverage_stages.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

bool is_equal(const Rgba8Range& a, const Rgba8Range& b) {
  return std::ranges::equal(a, b, [](Unorm8Range one, Unorm8Range other) {
    return one.low == other.low && one.high == other.high;
  });
}

bool is_equal(const SampleState& a, const SampleState& b) {
  return a.color == b.color && is_equal(a.permitted_color, b.permitted_color) &&
         a.depth == b.depth && a.permitted_depth.low == b.permitted_depth.low &&
         a.permitted_depth.high == b.permitted_depth.high && a.source == b.source &&
         a.stencil == b.stencil && a.hits == b.hits && a.blended == b.blended &&
         a.operated == b.operated;
}

// A state that permits everything that either of the two permits.
SampleState merged(SampleState a, const SampleState& b) {
  for (std::size_t c = 0; c < 4; ++c) {
    a.permitted_color[c].low = std::min(a.permitted_color[c].low, b.permitted_color[c].low);
    a.permitted_color[c].high = std::max(a.permitted_color[c].high, b.permitted_color[c].high);
  }
  a.permitted_depth = hull(a.permitted_depth, b.permitted_depth);
  if (a.source != b.source) a.source.reset();
  a.blended = a.blended || b.blended;
  return a;
}

std::vector<SampleState> merged(const std::vector<SampleState>& states) {
  std::map<std::pair<std::uint8_t, std::uint32_t>, SampleState> by_count;
  for (const SampleState& state : states) {
    const auto [place, is_new] = by_count.try_emplace({state.stencil, state.hits}, state);
    if (!is_new) place->second = merged(place->second, state);
  }
  std::vector<SampleState> result;
  for (const auto& [key, state] : by_count) result.push_back(state);
  return result;
}

void add(const SampleState& state, std::vector<SampleState>& states) {
  const bool known =
      std::ranges::any_of(states, [&](const SampleState& other) { return is_equal(state, other); });
  if (!known) states.push_back(state);
}

SampleState with_step(SampleState state, OperationsStep step) {
  state.last = step;
  return state;
}

}  // namespace

SampleState Replay::cleared() const {
  SampleState state;
  for (std::size_t c = 0; c < 4; ++c) {
    const auto component = static_cast<double>(target_.clear[c]);
    state.color[c] = to_unorm8(component);
    if (tracked_ == Tracked::permitted) state.permitted_color[c] = unorm8_permitted(component);
  }
  const auto depth = static_cast<double>(target_.clear_depth);
  state.depth = to_depth(depth, target_.depth);
  if (tracked_ == Tracked::permitted) state.permitted_depth = depth_permitted(depth, target_.depth);
  state.stencil = target_.clear_stencil;
  return state;
}

std::vector<SampleState> Replay::run(std::span<const Arrival> arrivals) const {
  std::vector<SampleState> states{cleared()};
  std::vector<SampleState> next;
  for (const Arrival& arrival : arrivals) step(states, arrival, next);
  return states;
}

std::vector<SampleState> Replay::after(std::vector<SampleState> states,
                                       const Arrival& arrival) const {
  std::vector<SampleState> next;
  step(states, arrival, next);
  return states;
}

// `next`: memory that is used again from step to step.
void Replay::step(std::vector<SampleState>& states, const Arrival& arrival,
                  std::vector<SampleState>& next) const {
  next.clear();
  for (const SampleState& state : states) add_after(state, arrival, next);
  if (next.size() > kMostStates) next = merged(next);
  std::swap(states, next);
}

void Replay::add_after(const SampleState& state, const Arrival& arrival,
                       std::vector<SampleState>& next) const {
  Outcomes kept{arrival.is_kept, !arrival.is_kept};
  const bool is_open = arrival.may_be_dropped || !arrival.is_kept;
  if (freedom_.alpha == OutcomeScope::permitted)
    kept = {arrival.may_be_kept, arrival.may_be_dropped};
  if (freedom_.alpha == OutcomeScope::any && is_open) kept = {true, true};
  if (kept.fail) add(with_step(state, OperationsStep::dropped), next);
  if (!kept.pass) return;
  add_tested(state, arrival, arrival.front_facing, next);
  if (freedom_.facing == OutcomeScope::permitted && arrival.may_face_otherwise)
    add_tested(state, arrival, !arrival.front_facing, next);
}

void Replay::add_tested(const SampleState& state, const Arrival& arrival, bool front_facing,
                        std::vector<SampleState>& next) const {
  const FragmentOperations& operations = *arrival.operations;
  const bool has_stencil = target_.stencil != StencilFormat::none && operations.stencil;
  const StencilFace* face = nullptr;
  if (has_stencil) face = &face_of(*operations.stencil, front_facing, output_.stencil);
  const auto with = [&](SampleState reached, StencilOperation StencilFace::*operation,
                        OperationsStep step) {
    const bool is_first = output_.stencil != StencilMethod::once_a_draw ||
                          std::exchange(reached.operated, &operations) != &operations;
    if (face != nullptr && is_first)
      reached.stencil = edgecase::after(face->*operation, *face, reached.stencil, output_.stencil);
    add(with_step(std::move(reached), step), next);
  };
  const Outcomes stencil = face != nullptr ? stencil_outcomes(state, *face) : Outcomes{true, false};
  if (stencil.fail) with(state, &StencilFace::fail, OperationsStep::stencil_failed);
  if (!stencil.pass) return;
  const Outcomes depth = depth_outcomes(state, arrival);
  if (depth.fail) with(state, &StencilFace::depth_fail, OperationsStep::depth_failed);
  if (!depth.pass) return;
  SampleState reached = written(state, arrival);
  if (has_either_depth(reached, arrival)) {
    SampleState other = reached;
    reached.depth = reached.permitted_depth.low;
    other.depth = other.permitted_depth.high;
    reached.permitted_depth = reached.depth;
    other.permitted_depth = other.depth;
    with(std::move(reached), &StencilFace::pass, OperationsStep::passed);
    reached = std::move(other);
  }
  with(std::move(reached), &StencilFace::pass, OperationsStep::passed);
}

Replay::Outcomes Replay::stencil_outcomes(const SampleState& state, const StencilFace& face) const {
  if (freedom_.stencil_test == OutcomeScope::any && face.function != CompareFunction::always)
    return {true, true};
  const bool passes = passes_stencil_test(face, state.stencil, output_.stencil);
  return {passes, !passes};
}

Replay::Outcomes Replay::depth_outcomes(const SampleState& state, const Arrival& arrival) const {
  if (target_.depth == DepthFormat::none) return {true, false};
  const DepthTest& test = arrival.operations->depth;
  if (freedom_.depth_test == OutcomeScope::any && test.function != CompareFunction::always)
    return {true, true};
  if (compares_unconverted()) {
    const auto [may_pass, may_fail] = unconverted_outcomes(test.function, arrival.permitted_depth,
                                                           state.permitted_depth, target_.depth);
    return {may_pass, may_fail};
  }
  if (freedom_.depth_test == OutcomeScope::exact || output_.depth != DepthTestMethod::as_set ||
      output_.depth_bits != DepthBits::as_set) {
    const bool passes = passes_depth_test(test, arrival.depth, state.depth, target_.depth,
                                          output_.depth, output_.depth_bits);
    return {passes, !passes};
  }
  const bool same = arrival.reported_depth && arrival.reported_depth == state.source;
  const auto [may_pass, may_fail] =
      permitted_outcomes(test.function, depth_permitted(arrival.permitted_depth, target_.depth),
                         state.permitted_depth, same);
  return {may_pass, may_fail};
}

// If depths are compared unconverted, it matters which of two neighbouring values was stored for a
// depth: each has a state of its own.
bool Replay::has_either_depth(const SampleState& state, const Arrival& arrival) const {
  const bool is_own = state.source && state.source == arrival.reported_depth;
  return compares_unconverted() && is_own &&
         state.permitted_depth.low != state.permitted_depth.high;
}

void Replay::set_permitted_color(const Arrival& arrival, SampleState& state) const {
  if (output_.blend.method != BlendMethod::as_set) {
    // For another equation, only its own result is known to be possible.
    for (std::size_t c = 0; c < 4; ++c) state.permitted_color[c] = {state.color[c], state.color[c]};
    return;
  }
  FragmentOperations operations = *arrival.operations;
  if (output_.blend.mask == ColorMaskMethod::ignored) operations.color_mask.fill(true);
  state.permitted_color =
      permitted_color(operations, arrival.permitted_color, state.permitted_color);
}

SampleState Replay::written(SampleState state, const Arrival& arrival) const {
  const FragmentOperations& operations = *arrival.operations;
  state.color = written_color(operations, arrival.color, Rgba8(state.color), output_.blend);
  if (tracked_ == Tracked::permitted) set_permitted_color(arrival, state);
  const bool all = output_.blend.mask == ColorMaskMethod::ignored ||
                   std::ranges::all_of(operations.color_mask, [](bool on) { return on; });
  state.blended = operations.blending || (state.blended && !all);
  if (target_.depth != DepthFormat::none && arrival.writes_depth &&
      stores_depth(operations.depth, output_.depth_mask)) {
    state.depth = to_depth(arrival.depth, target_.depth, output_.depth_bits);
    // Of fewer bits, only their own value is known to be possible.
    if (tracked_ == Tracked::permitted)
      state.permitted_depth = output_.depth_bits == DepthBits::as_set
                                  ? depth_permitted(arrival.permitted_depth, target_.depth)
                                  : Interval(state.depth);
    state.source = arrival.reported_depth;
  }
  ++state.hits;
  return state;
}

namespace {

bool permits(const SampleState& state, const std::uint8_t* color) {
  for (std::size_t c = 0; c < 4; ++c)
    if (color[c] < state.permitted_color[c].low || color[c] > state.permitted_color[c].high)
      return false;
  return true;
}

// A permitted range of depths also contains numbers between the format's values.
bool permits(const SampleState& state, double depth, DepthFormat format) {
  if (depth == state.depth) return true;
  return is_depth_of(depth, format) && state.permitted_depth.contains(depth);
}

}  // namespace

bool agrees(const SampleState& state, const StoredSample& stored, DepthFormat format,
            ComparedPlanes planes) {
  if (planes.stencil && stored.stencil && *stored.stencil != state.stencil) return false;
  if (planes.hits && stored.hits && *stored.hits != state.hits) return false;
  if (planes.color && stored.color != nullptr && !permits(state, stored.color)) return false;
  return !planes.depth || !stored.depth || permits(state, *stored.depth, format);
}

bool any_agrees(std::span<const SampleState> states, const StoredSample& stored, DepthFormat format,
                ComparedPlanes planes) {
  return std::ranges::any_of(
      states, [&](const SampleState& state) { return agrees(state, stored, format, planes); });
}

bool has_color(const SampleState& state, const StoredSample& stored) {
  return stored.color == nullptr ||
         std::equal(state.color.begin(), state.color.end(), stored.color);
}

bool is_exact(const SampleState& state, const StoredSample& stored) {
  return has_color(state, stored) && (!stored.depth || *stored.depth == state.depth) &&
         (!stored.stencil || *stored.stencil == state.stencil) &&
         (!stored.hits || *stored.hits == state.hits);
}

// ---------------------------------------------------------------------------------------- arrivals

bool is_standard(const RuleChoices& choice) {
  const RuleChoices& standard = standard_choices();
  return choice.output.depth == standard.output.depth &&
         choice.output.depth_mask == standard.output.depth_mask &&
         choice.output.stencil == standard.output.stencil &&
         choice.output.blend.method == standard.output.blend.method &&
         choice.output.blend.rounding == standard.output.blend.rounding &&
         choice.output.blend.mask == standard.output.blend.mask &&
         choice.triangles.facing == standard.triangles.facing &&
         choice.triangles.multisample_switch == standard.triangles.multisample_switch &&
         choice.values.locations.depth == standard.values.locations.depth &&
         choice.samples.alpha_to_coverage == standard.samples.alpha_to_coverage;
}

Arrivals::Arrivals(const ValueContext& context)
    : context_(context), facings_(context.primitives.size()) {}

const std::vector<Arrival>& Arrivals::at(std::span<const Fragment> at_pixel, int sample,
                                         const RuleChoices& choice, Tracked tracked) const {
  const Asked asked{at_pixel.data(),
                    at_pixel.size(),
                    sample,
                    choice.triangles.multisample_switch,
                    choice.triangles.facing,
                    choice.values.locations,
                    choice.samples.alpha_to_coverage,
                    tracked};
  Asked wider = asked;
  wider.tracked = Tracked::permitted;
  if (asked_ == asked || asked_ == wider) return answer_;
  asked_ = asked;
  answer_.clear();
  for (const Fragment& fragment : at_pixel)
    if (covers_sample(context_, fragment, sample, choice.triangles.multisample_switch))
      answer_.push_back(arrival_of(fragment, at_pixel, sample, choice, tracked));
  return answer_;
}

Arrival Arrivals::arrival_of(const Fragment& fragment, std::span<const Fragment> at_pixel,
                             int sample, const RuleChoices& choice, Tracked tracked) const {
  Arrival arrival;
  arrival.fragment = &fragment;
  const Draw& draw = *context_.primitive_of(fragment).state;
  arrival.operations = &draw.operations;
  arrival.is_unsampled = context_.scene.target.samples > 1 && !draw.multisampling.enabled;
  const PixelTruth truth = truth_of_fragment(context_, fragment);
  arrival.color = truth.exact;
  for (std::size_t c = 0; c < 4; ++c) arrival.permitted_color[c] = accepted(truth, c);
  if (context_.scene.target.depth != DepthFormat::none) set_depth(arrival, sample, choice, tracked);
  if (arrival.operations->stencil) set_facing(arrival, choice);
  if (is_thinned(context_, fragment)) set_kept(arrival, at_pixel, sample, choice);
  return arrival;
}

// Each sample of a multisampled draw has its own depth, that of the primitive at the sample.
void Arrivals::set_depth(Arrival& arrival, int sample, const RuleChoices& choice,
                         Tracked tracked) const {
  const Fragment& fragment = *arrival.fragment;
  const ScenePrimitive& primitive = context_.primitive_of(fragment);
  const Target& target = context_.scene.target;
  const bool by_sample =
      target.samples > 1 &&
      (primitive.state->multisampling.enabled ||
       unsampled(primitive.kind, choice.triangles.multisample_switch) == Unsampled::by_each_sample);
  arrival.writes_depth =
      writes_depth(context_, fragment, sample, choice.triangles.multisample_switch);
  if (target.samples > 1 && !by_sample && !is_constant(context_.values_of(fragment).lawful.depth)) {
    set_depth_without_multisampling(arrival, tracked);
    return;
  }
  if (fragment.has_depth && !by_sample) {
    arrival.reported_depth = fragment.depth;
    arrival.depth = fragment.depth;
    arrival.permitted_depth =
        std::isnan(fragment.depth)
            ? Interval::everything()
            : clamped_depth(context_.values_of(fragment).lawful, fragment.depth);
    return;
  }
  const PrimitiveValues& values = context_.values_of(fragment);
  const Point place =
      place_in({fragment.x, fragment.y},
               by_sample ? sample_depth_location(primitive.kind, context_.sample_position(sample),
                                                 choice.values.locations)
                         : centre_of_pixel());
  arrival.depth = middle(depth_exact(values.chosen, place));
  if (tracked == Tracked::permitted) arrival.permitted_depth = depth_permitted_at(values, place);
}

// The depth is that of the pixel's centre, or of the sample or another one (14.3.1, 17.3.10),
// wherever gl_FragCoord.z was evaluated.
void Arrivals::set_depth_without_multisampling(Arrival& arrival, Tracked tracked) const {
  const Fragment& fragment = *arrival.fragment;
  const PrimitiveValues& values = context_.values_of(fragment);
  const Point centre = pixel_centre(fragment.x, fragment.y);
  const bool is_reported = fragment.has_depth && !std::isnan(fragment.depth);
  arrival.depth = is_reported ? fragment.depth : middle(depth_exact(values.chosen, centre));
  if (tracked == Tracked::exact) return;
  arrival.permitted_depth = hull(arrival.depth, depth_permitted_at(values, centre));
  for (const Point position : context_.sample_positions())
    arrival.permitted_depth =
        hull(arrival.permitted_depth,
             depth_permitted_at(values, place_in({fragment.x, fragment.y}, position)));
}

void Arrivals::set_facing(Arrival& arrival, const RuleChoices& choice) const {
  const ScenePrimitive& primitive = context_.primitive_of(*arrival.fragment);
  CoverageChoice coverage = context_.choices.of(primitive.kind);
  coverage.facing = choice.triangles.facing;
  arrival.front_facing = is_front_facing(primitive, context_.scene.target, coverage);
  const FacingLatitude latitude = facing_of(*arrival.fragment);
  arrival.may_face_otherwise =
      arrival.front_facing ? latitude.may_face_back : latitude.may_face_front;
}

FacingLatitude Arrivals::facing_of(const Fragment& fragment) const {
  std::optional<FacingLatitude>& facing = facings_[static_cast<std::size_t>(fragment.primitive)];
  if (!facing) facing = permitted_facing(context_.primitive_of(fragment), context_.bits());
  return *facing;
}

void Arrivals::set_kept(Arrival& arrival, std::span<const Fragment> at_pixel, int sample,
                        const RuleChoices& choice) const {
  const std::uint32_t kept =
      kept_by_alpha(context_, *arrival.fragment, at_pixel, choice.samples.alpha_to_coverage);
  arrival.is_kept = (kept >> sample & 1) != 0;
  const SampleCounts counts = written_samples(context_, *arrival.fragment);
  arrival.may_be_kept = counts.most > 0;
  arrival.may_be_dropped = counts.least < context_.scene.target.samples;
}

}  // namespace edgecase
