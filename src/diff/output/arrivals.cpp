// SPDX-License-Identifier: MIT
#include "diff/output/arrivals.h"

#include <cmath>

#include "diff/samples/sample_planes.h"
#include "diff/samples/switched_off.h"
#include "diff/values/pixel_truth.h"
#include "raster/primitives.h"

namespace edgecase {

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

std::vector<Arrival> Arrivals::at(std::span<const Fragment> at_pixel, int sample,
                                  const RuleChoices& choice) const {
  std::vector<Arrival> arrivals;
  for (const Fragment& fragment : at_pixel) {
    if (!covers_sample(context_, fragment, sample, choice.triangles.multisample_switch)) continue;
    Arrival arrival;
    arrival.fragment = &fragment;
    arrival.operations = &context_.primitive_of(fragment).state->operations;
    const PixelTruth truth = truth_of_fragment(context_, fragment);
    arrival.color = truth.exact;
    arrival.permitted_color = truth.permitted;
    if (context_.scene.target.depth != DepthFormat::none) set_depth(arrival, sample, choice);
    if (arrival.operations->stencil) set_facing(arrival, choice);
    if (is_thinned(context_, fragment)) set_kept(arrival, at_pixel, sample, choice);
    arrivals.push_back(arrival);
  }
  return arrivals;
}

// A sample of a multisampled draw has a depth of its own, that of the primitive at the sample.
void Arrivals::set_depth(Arrival& arrival, int sample, const RuleChoices& choice) const {
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
    set_depth_without_multisampling(arrival);
    return;
  }
  if (fragment.has_depth && !by_sample) {
    arrival.told_depth = fragment.depth;
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
  arrival.permitted_depth = depth_permitted_at(values, place);
}

// The depth is that of the pixel's centre, or of the sample or another one (14.3.1, 17.3.10),
// wherever gl_FragCoord.z was evaluated.
void Arrivals::set_depth_without_multisampling(Arrival& arrival) const {
  const Fragment& fragment = *arrival.fragment;
  const PrimitiveValues& values = context_.values_of(fragment);
  const Point centre = pixel_centre(fragment.x, fragment.y);
  const bool is_told = fragment.has_depth && !std::isnan(fragment.depth);
  arrival.depth = is_told ? fragment.depth : middle(depth_exact(values.chosen, centre));
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
