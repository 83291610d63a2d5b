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

// A state that permits everything that either of the two permits.
PermittedSample merged(PermittedSample a, const PermittedSample& b) {
  for (std::size_t c = 0; c < 4; ++c) {
    Unorm8Range& range = a.color.permitted[c];
    range.low = std::min(range.low, b.color.permitted[c].low);
    range.high = std::max(range.high, b.color.permitted[c].high);
  }
  a.depth.permitted = hull(a.depth.permitted, b.depth.permitted);
  if (a.depth.reported != b.depth.reported) a.depth.reported.reset();
  a.blended = a.blended || b.blended;
  return a;
}

std::vector<PermittedSample> merged(const std::vector<PermittedSample>& states) {
  std::map<std::pair<std::uint8_t, std::uint32_t>, PermittedSample> by_count;
  for (const PermittedSample& state : states) {
    const auto [place, is_new] = by_count.try_emplace({state.stencil, state.hits}, state);
    if (!is_new) place->second = merged(place->second, state);
  }
  std::vector<PermittedSample> result;
  for (const auto& [key, state] : by_count) result.push_back(state);
  return result;
}

void add(const PermittedSample& state, std::vector<PermittedSample>& states) {
  if (std::ranges::find(states, state) == states.end()) states.push_back(state);
}

// If depths are compared unconverted, it matters which of two neighbouring values was stored for a
// depth: each has a state of its own.
bool has_either_depth(const PermittedNumbers::Depth& stored, const PermittedNumbers::Depth& depth,
                      const OutputRules& by) {
  return by.freedom.depth_test == OutcomeScope::permitted &&
         by.choice.depth == DepthTestMethod::unconverted && stored.reported &&
         stored.reported == depth.reported && stored.permitted.low != stored.permitted.high;
}

void add_tested(const PermittedSample& state, const PermittedFragment& fragment,
                const FragmentOperations& operations, const OutputRules& by,
                std::vector<PermittedSample>& next) {
  const auto visit = [&](PermittedSample reached, FragmentOutcome outcome) {
    if (outcome == FragmentOutcome::passed && has_either_depth(reached.depth, fragment.depth, by)) {
      const Interval either = reached.depth.permitted;
      reached.depth.permitted = reached.depth.exact = either.low;
      add(reached, next);
      reached.depth.permitted = reached.depth.exact = either.high;
    }
    add(reached, next);
  };
  for_each_outcome(fragment, operations, by, state, visit);
}

void add_after(const PermittedSample& state, const Arrival& arrival, const OutputRules& by,
               std::vector<PermittedSample>& next) {
  TestOutcomes kept{arrival.is_kept, !arrival.is_kept};
  const bool is_open = arrival.may_be_dropped || !arrival.is_kept;
  if (by.freedom.alpha == OutcomeScope::permitted)
    kept = {arrival.may_be_kept, arrival.may_be_dropped};
  if (by.freedom.alpha == OutcomeScope::any && is_open) kept = {true, true};
  if (kept.may_fail) add(state, next);
  if (!kept.may_pass) return;
  add_tested(state, arrival.values, *arrival.operations, by, next);
  if (by.freedom.facing == OutcomeScope::permitted && arrival.may_face_otherwise) {
    PermittedFragment turned = arrival.values;
    turned.front_facing = !turned.front_facing;
    add_tested(state, turned, *arrival.operations, by, next);
  }
}

}  // namespace

std::vector<PermittedSample> replayed(std::span<const Arrival> arrivals, const OutputRules& by) {
  std::vector<PermittedSample> states{cleared_sample<PermittedNumbers>(by.target)};
  std::vector<PermittedSample> next;
  for (const Arrival& arrival : arrivals) {
    next.clear();
    for (const PermittedSample& state : states) add_after(state, arrival, by, next);
    if (next.size() > kMostStates) next = merged(next);
    std::swap(states, next);
  }
  return states;
}

std::vector<PermittedSample> states_after(const PermittedSample& state, const Arrival& arrival,
                                          const OutputRules& by) {
  std::vector<PermittedSample> next;
  add_after(state, arrival, by, next);
  return next;
}

FragmentOutcome arrive(const Arrival& arrival, const OutputRules& by, ExactSample& sample) {
  if (!arrival.is_kept) return FragmentOutcome::dropped;
  const PermittedFragment& values = arrival.values;
  return apply({values.color.exact, values.depth.exact, values.front_facing, values.writes_depth},
               *arrival.operations, by, sample);
}

namespace {

bool permits(const Rgba8Range& permitted, const std::uint8_t* color) {
  for (std::size_t c = 0; c < 4; ++c)
    if (color[c] < permitted[c].low || color[c] > permitted[c].high) return false;
  return true;
}

// A permitted range of depths also contains numbers between the format's values.
bool permits(const PermittedNumbers::Depth& depth, double stored, DepthFormat format) {
  if (stored == depth.exact) return true;
  return is_depth_of(stored, format) && depth.permitted.contains(stored);
}

}  // namespace

bool agrees(const PermittedSample& state, const StoredSample& stored, DepthFormat format,
            ComparedPlanes planes) {
  if (planes.stencil && stored.stencil && *stored.stencil != state.stencil) return false;
  if (planes.hits && stored.hits && *stored.hits != state.hits) return false;
  if (planes.color && stored.color != nullptr && !permits(state.color.permitted, stored.color))
    return false;
  return !planes.depth || !stored.depth || permits(state.depth, *stored.depth, format);
}

bool any_agrees(std::span<const PermittedSample> states, const StoredSample& stored,
                DepthFormat format, ComparedPlanes planes) {
  return std::ranges::any_of(
      states, [&](const PermittedSample& state) { return agrees(state, stored, format, planes); });
}

bool has_color(const ExactSample& exact, const StoredSample& stored) {
  return stored.color == nullptr ||
         std::equal(exact.color.begin(), exact.color.end(), stored.color);
}

bool is_exact(const ExactSample& exact, const StoredSample& stored) {
  return has_color(exact, stored) && (!stored.depth || *stored.depth == exact.depth) &&
         (!stored.stencil || *stored.stencil == exact.stencil) &&
         (!stored.hits || *stored.hits == exact.hits);
}

// ---------------------------------------------------------------------------------------- arrivals

bool is_standard(const RuleChoices& choice) {
  const RuleChoices& standard = standard_choices();
  const OutputChoice &a = choice.output, &b = standard.output;
  return a.depth == b.depth && a.depth_mask == b.depth_mask && a.depth_bits == b.depth_bits &&
         a.stencil == b.stencil && a.blend.method == b.blend.method &&
         a.blend.rounding == b.blend.rounding && a.blend.mask == b.blend.mask &&
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
  arrival.values.color.exact = truth.exact;
  for (std::size_t c = 0; c < 4; ++c) arrival.values.color.permitted[c] = accepted(truth, c);
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
  PermittedNumbers::Depth& depth = arrival.values.depth;
  arrival.values.writes_depth =
      writes_depth(context_, fragment, sample, choice.triangles.multisample_switch);
  if (target.samples > 1 && !by_sample && !is_constant(context_.values_of(fragment).lawful.depth)) {
    set_depth_without_multisampling(arrival, tracked);
    return;
  }
  if (fragment.has_depth && !by_sample) {
    depth.reported = depth.exact = fragment.depth;
    depth.permitted = std::isnan(fragment.depth)
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
  depth.exact = middle(depth_exact(values.chosen, place));
  if (tracked == Tracked::permitted) depth.permitted = depth_permitted_at(values, place);
}

// The depth is that of the pixel's centre, or of the sample or another one (14.3.1, 17.3.10),
// wherever gl_FragCoord.z was evaluated.
void Arrivals::set_depth_without_multisampling(Arrival& arrival, Tracked tracked) const {
  const Fragment& fragment = *arrival.fragment;
  const PrimitiveValues& values = context_.values_of(fragment);
  const Point centre = pixel_centre(fragment.x, fragment.y);
  const bool is_reported = fragment.has_depth && !std::isnan(fragment.depth);
  PermittedNumbers::Depth& depth = arrival.values.depth;
  depth.exact = is_reported ? fragment.depth : middle(depth_exact(values.chosen, centre));
  if (tracked == Tracked::exact) return;
  depth.permitted = hull(depth.exact, depth_permitted_at(values, centre));
  for (const Point position : context_.sample_positions())
    depth.permitted = hull(
        depth.permitted, depth_permitted_at(values, place_in({fragment.x, fragment.y}, position)));
}

void Arrivals::set_facing(Arrival& arrival, const RuleChoices& choice) const {
  const ScenePrimitive& primitive = context_.primitive_of(*arrival.fragment);
  CoverageChoice coverage = context_.choices.of(primitive.kind);
  coverage.facing = choice.triangles.facing;
  const bool front_facing = is_front_facing(primitive, context_.scene.target, coverage);
  arrival.values.front_facing = front_facing;
  const FacingLatitude latitude = facing_of(*arrival.fragment);
  arrival.may_face_otherwise = front_facing ? latitude.may_face_back : latitude.may_face_front;
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
