// SPDX-License-Identifier: MIT
#include "search/snap_limit.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "casefile/scene/viewport.h"
#include "rules/all_rules.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

// The grid that a snap rule of the cause names; null where it names none.
const Snap* named_in(const Cause& cause, RuleId rule) {
  const auto part = std::ranges::find(cause.parts, rule, &AlternativeId::rule);
  return part != cause.parts.end() ? find_snap(alternative_of(*part)->name) : nullptr;
}

// Are vertices snapped where the scene has them?
bool snaps_given_vertices(const Scene& scene) {
  return scene.supersampling.empty() && !has_clip_vertices(scene.draws);
}

}  // namespace

int least_fraction_bits(const Signature& signature, const Policy& policy, const Scene& scene) {
  if (!snaps_given_vertices(scene)) return 0;
  const Cause cause = parse_cause(signature.cause).value_or(Cause());
  const RuleChoices choices = resolve(policy, scene.target.surface);
  int least = 0;
  for (const PrimitiveKind kind :
       {PrimitiveKind::point, PrimitiveKind::line, PrimitiveKind::triangle}) {
    const Snap* other = named_in(cause, snap_rule_of(kind));
    if (other == nullptr) continue;
    // Where nothing is snapped by either, all bits count; a scene has no more of them.
    const int coarser = std::min(other->bits, choices.of(kind).snap.bits);
    least = std::max(least, std::min(coarser + 1, Fixed::kFractionBits));
  }
  return least;
}

}  // namespace edgecase
