// SPDX-License-Identifier: MIT
#include "diff/values/sample_writers.h"

#include <algorithm>
#include <bit>

#include "diff/values/pixel_truth.h"
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

}  // namespace edgecase
