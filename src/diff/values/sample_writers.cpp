// SPDX-License-Identifier: MIT
#include "diff/values/sample_writers.h"

#include <algorithm>
#include <bit>

#include "diff/values/pixel_values.h"
#include "raster/samples.h"
#include "rules/all_rules.h"

namespace edgecase {

bool covers_sample(const ValueContext& context, const Fragment& fragment, int sample) {
  const Draw& draw = *context.primitive_of(fragment).state;
  if (!is_multisampled(draw, context.scene.target)) return true;
  return (fragment.coverage >> sample & 1) != 0;
}

std::vector<const Fragment*> last_writers(const ValueContext& context,
                                          std::span<const Fragment> at_pixel, int sample) {
  std::vector<const Fragment*> writers;
  for (std::size_t i = at_pixel.size(); i-- > 0;) {
    const Fragment& fragment = at_pixel[i];
    if (!covers_sample(context, fragment, sample)) continue;
    writers.push_back(&fragment);
    const Draw& draw = *context.primitive_of(fragment).state;
    const bool may_not_write =
        is_multisampled(draw, context.scene.target) && draw.multisampling.alpha_to_coverage;
    if (!may_not_write) return writers;
  }
  writers.push_back(nullptr);
  return writers;
}

// ------------------------------------------------------------------------------- alpha to coverage

std::vector<const Fragment*> left_by_alpha(const ValueContext& context,
                                           std::span<const Fragment* const> writers) {
  const int samples = context.scene.target.samples;
  std::vector<const Fragment*> left;
  for (const Fragment* writer : writers) {
    const SampleCounts counts =
        writer != nullptr ? written_samples(context, *writer) : SampleCounts{samples, samples};
    if (counts.most > 0) left.push_back(writer);
    if (counts.least == samples) break;
  }
  return left;
}

bool is_thinned(const ValueContext& context, const Fragment& fragment) {
  const Draw& draw = *context.primitive_of(fragment).state;
  return is_multisampled(draw, context.scene.target) && draw.multisampling.alpha_to_coverage;
}

std::uint32_t kept_by_alpha(const ValueContext& context, const Fragment& fragment,
                            std::span<const Fragment> at_pixel, AlphaToCoverage choice) {
  const int samples = context.scene.target.samples;
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  if (!heeds_others(primitive.state->multisampling, samples,
                    {context.choices.samples.rate, choice}))
    return alpha_mask(fragment.color[3], samples, choice);
  // Invocations that did not run, or that cover nothing, report no alpha.
  std::vector<double> alphas =
      alphas_of_samples(primitive, context.values_of(fragment).chosen, {fragment.x, fragment.y},
                        context.sample_positions(), context.choices.values.locations);
  for (const Fragment& reported : at_pixel)
    if (reported.primitive == fragment.primitive && reported.has_color && reported.coverage != 0)
      alphas[static_cast<std::size_t>(std::countr_zero(reported.coverage))] = reported.color[3];
  return mask_by_others(alphas);
}

SampleCounts written_samples(const ValueContext& context, const Fragment& fragment) {
  const int samples = context.scene.target.samples;
  if (!is_thinned(context, fragment)) return {samples, samples};
  const Interval alpha = fragment.has_color ? Interval(fragment.color[3]) : Interval::everything();
  return alpha_permitted(with_fade(context, fragment, alpha), samples);
}

// -------------------------------------------------------------------------- without GL_MULTISAMPLE

namespace {

bool is_switched_off(const ValueContext& context, const Fragment& fragment) {
  return context.scene.target.samples > 1 &&
         !context.primitive_of(fragment).state->multisampling.enabled;
}

std::optional<Invocation> invocation_if_ignored(const ValueContext& context,
                                                const Fragment& fragment) {
  if (!is_switched_off(context, fragment) || fragment.coverage == 0) return std::nullopt;
  Multisampling use = context.primitive_of(fragment).state->multisampling;
  use.enabled = true;
  const bool per_sample =
      std::has_single_bit(fragment.coverage) &&
      runs_per_sample(use, context.scene.target.samples, context.choices.samples.rate);
  return Invocation{context.primitive_of(fragment).kind, fragment.coverage, per_sample};
}

}  // namespace

Cause cause_of(MultisampleSwitch choice) {
  return alternative_id(RuleId::sample_enable, name_of(choice));
}

std::vector<MultisampleSwitch> switches_beside(const ValueContext& context,
                                               std::span<const Fragment> fragments) {
  if (std::ranges::none_of(fragments,
                           [&](const Fragment& f) { return is_switched_off(context, f); }))
    return {};
  std::vector<MultisampleSwitch> switches;
  for (const MultisampleSwitch choice : values_of<MultisampleSwitch>())
    if (choice != context.choices.triangles.multisample_switch) switches.push_back(choice);
  return switches;
}

bool covers_sample(const ValueContext& context, const Fragment& fragment, int sample,
                   MultisampleSwitch choice) {
  if (is_switched_off(context, fragment) &&
      unsampled(context.primitive_of(fragment).kind, choice) == Unsampled::by_each_sample)
    return (fragment.coverage >> sample & 1) != 0;
  return covers_sample(context, fragment, sample);
}

std::vector<const Fragment*> last_writers(const ValueContext& context,
                                          std::span<const Fragment> at_pixel, int sample,
                                          MultisampleSwitch choice) {
  std::vector<const Fragment*> writers;
  for (std::size_t i = at_pixel.size(); i-- > 0;) {
    const Fragment& fragment = at_pixel[i];
    if (!covers_sample(context, fragment, sample, choice)) continue;
    writers.push_back(&fragment);
    if (is_switched_off(context, fragment) ||
        !context.primitive_of(fragment).state->multisampling.alpha_to_coverage)
      return writers;
  }
  writers.push_back(nullptr);
  return writers;
}

bool writes_depth(const ValueContext& context, const Fragment& fragment, int sample,
                  MultisampleSwitch choice) {
  return sample == 0 || choice != MultisampleSwitch::depth_of_first ||
         !is_switched_off(context, fragment);
}

std::optional<Point> coordinates_if_ignored(const ValueContext& context, const Fragment& fragment) {
  const auto invocation = invocation_if_ignored(context, fragment);
  if (!invocation) return std::nullopt;
  return place_in({fragment.x, fragment.y},
                  coordinates_location(*invocation, context.sample_positions()));
}

std::optional<Point> depth_place_if_ignored(const ValueContext& context, const Fragment& fragment,
                                            const LocationChoice& choice) {
  const auto invocation = invocation_if_ignored(context, fragment);
  if (!invocation) return std::nullopt;
  return place_in({fragment.x, fragment.y},
                  fragment_depth_location(*invocation, context.sample_positions(), choice));
}

}  // namespace edgecase
