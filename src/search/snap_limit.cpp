// SPDX-License-Identifier: MIT
#include "search/snap_limit.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "casefile/scene/viewport.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

constexpr std::string_view kBetweenCauses = " + ";

// The grid that a snap rule of the cause names; null where it names none.
const Snap* named_in(std::string_view cause, std::string_view rule) {
  while (!cause.empty()) {
    const std::size_t end = cause.find(kBetweenCauses);
    const std::string_view one = cause.substr(0, end);
    if (one.starts_with(rule) && one.substr(rule.size()).starts_with('='))
      return find_snap(one.substr(rule.size() + 1));
    cause = end == cause.npos ? "" : cause.substr(end + kBetweenCauses.size());
  }
  return nullptr;
}

// Are vertices snapped where the scene has them?
bool snaps_given_vertices(const Scene& scene) {
  return scene.supersampling.empty() && !has_clip_vertices(scene.draws);
}

}  // namespace

int least_fraction_bits(const Signature& signature, const Policy& policy, const Scene& scene) {
  if (!snaps_given_vertices(scene)) return 0;
  const RuleChoices choices = resolve(policy, scene.target.surface);
  int least = 0;
  for (const PrimitiveKind kind :
       {PrimitiveKind::point, PrimitiveKind::line, PrimitiveKind::triangle}) {
    const Snap* other = named_in(signature.cause, snap_rule_of(kind));
    if (other == nullptr) continue;
    // Where nothing is snapped by either, all bits count; a scene has no more of them.
    const int coarser = std::min(other->bits, choices.of(kind).snap.bits);
    least = std::max(least, std::min(coarser + 1, Fixed::kFractionBits));
  }
  return least;
}

}  // namespace edgecase
