// SPDX-License-Identifier: MIT
#include "diff/textures/level_ramp.h"

#include "diff/coverage/legality.h"
#include "diff/textures/texture_lookups.h"
#include "diff/values/value_diff.h"
#include "rules/choices.h"

namespace edgecase {

std::vector<Result::LevelPoint> level_ramp(const Scene& scene, const ResolvedPolicy& policy,
                                           const Rendering& rendered, const RendererFacts& facts) {
  const RuleChoices& choices = policy.on(scene.target.surface);
  const std::vector<ScenePrimitive> primitives = primitives_of(scene);
  ValueContext context(scene, primitives, choices, latitude_bits(facts.reported_subpixel_bits),
                       policy.latitude());
  context.follow_limits(facts.lookups);
  const Rendering not_drawn;  // a row is soon looked up
  TextureLookups lookups(context, not_drawn, rendered);
  std::vector<Result::LevelPoint> ramp;
  // Fragments come row by row.
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
