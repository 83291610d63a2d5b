// SPDX-License-Identifier: MIT
#include "diff/values/ignored_multisample.h"

#include <algorithm>
#include <bit>

#include "diff/values/sample_writers.h"
#include "rules/all_rules.h"

namespace edgecase {
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
