// SPDX-License-Identifier: MIT
#include "diff/display_data.h"

#include "diff/coverage/legality.h"
#include "diff/textures/texture_lookups.h"
#include "diff/values/value_diff.h"

namespace edgecase {
namespace {

std::size_t count_fragments(const Rendering& rendering) {
  std::size_t count = rendering.fragments.size();
  for (const Rendering& pass : rendering.passes) count += pass.fragments.size();
  return count;
}

// By pixel: true if something differs there.
std::vector<bool> disputed_pixels(const Rendering& exact, const Result& result) {
  std::vector<bool> disputed(static_cast<std::size_t>(exact.width) *
                             static_cast<std::size_t>(exact.height));
  for (const Disagreement& d : result.disagreements) disputed[exact.pixel_index(d.x, d.y)] = true;
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty())
      disputed[exact.pixel_index(values.worst.x, values.worst.y)] = true;
  return disputed;
}

std::vector<Result::ReportedFragment> fragments_at(const std::vector<bool>& pixels,
                                                   const Rendering& rendering) {
  std::vector<Result::ReportedFragment> reported;
  const auto add = [&](const Rendering& one, int pass) {
    for (const Fragment& fragment : one.fragments) {
      if (!pixels[rendering.pixel_index(fragment.x, fragment.y)]) continue;
      reported.push_back({fragment, pass});
      reported.back().fragment.detail = -1;
    }
  };
  add(rendering, -1);
  for (std::size_t i = 0; i < rendering.passes.size(); ++i)
    add(rendering.passes[i], static_cast<int>(i));
  reported.shrink_to_fit();
  return reported;
}

}  // namespace

void report_fragments(const Rendering& exact, const Rendering& rendered, Result& result) {
  if (result.disagreements.empty() && result.values.empty()) return;
  std::vector<bool> pixels = disputed_pixels(exact, result);
  if (count_fragments(exact) + count_fragments(rendered) <= kMostOfSmall)
    pixels.assign(pixels.size(), true);
  result.exact_fragments = fragments_at(pixels, exact);
  result.rendered_fragments = fragments_at(pixels, rendered);
}

std::vector<Result::LevelPoint> level_ramp(const Scene& scene, const ResolvedPolicy& policy,
                                           const Rendering& rendered, const RendererFacts& facts) {
  const RuleChoices& choices = policy.on(scene.target.surface);
  const std::vector<ScenePrimitive> primitives = primitives_of(scene);
  ValueContext context(scene, primitives, choices, latitude_bits(facts.reported_subpixel_bits),
                       policy.latitude());
  context.follow_limits(facts.lookups);
  const Rendering not_drawn;  // empty: looking up one row is cheap
  TextureLookups lookups(context, not_drawn, rendered);
  std::vector<Result::LevelPoint> ramp;
  // Fragments are sorted by row.
  for (const Fragment& f : rendered.fragments) {
    if (!ramp.empty() && f.y != ramp.front().y) break;
    if (!context.primitive_of(f).state->texture) continue;
    const FragmentDetail* detail = lookups.detail_of(f);
    if (detail == nullptr || !detail->level_of_detail) continue;
    const Interval band = lookups.permitted_lambda(f);
    ramp.push_back({f.x, f.y, lookups.exact(f).level_of_detail[1], band.low, band.high,
                    (*detail->level_of_detail)[1]});
  }
  return ramp;
}

}  // namespace edgecase
