// SPDX-License-Identifier: MIT
#include "diff/textures/untold_colors.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "rules/textures/level_of_detail.h"
#include "rules/textures/texel_filter.h"

namespace edgecase {
namespace {

using Reach = TextureLookups::Reach;
using Bounds = std::array<Interval, 4>;

Bounds hull_of(const Boxes& boxes) {
  Bounds bounds;
  std::ranges::copy(boxes.front(), bounds.begin());
  for (const Box& box : boxes)
    for (std::size_t c = 0; c < bounds.size(); ++c) bounds[c] = hull(bounds[c], box[c]);
  return bounds;
}

Bounds hull_of(Bounds bounds, const Bounds& others) {
  for (std::size_t c = 0; c < bounds.size(); ++c) bounds[c] = hull(bounds[c], others[c]);
  return bounds;
}

}  // namespace

bool has_untold_colors(const ValueContext& context, const Rendering& rendered) {
  return std::ranges::any_of(rendered.fragments, [&](const Fragment& fragment) {
    return !fragment.has_color && context.primitive_of(fragment).state->texture;
  });
}

PixelTruth UntoldColors::of(const Fragment& fragment) {
  if (!known_.empty() &&
      (known_.front().first->x != fragment.x || known_.front().first->y != fragment.y))
    known_.clear();
  const auto found =
      std::ranges::find(known_, &fragment, [](const auto& one) { return one.first; });
  if (found != known_.end()) return found->second;
  known_.emplace_back(&fragment, looked_up(fragment));
  return known_.back().second;
}

PixelTruth UntoldColors::looked_up(const Fragment& fragment) {
  PixelTruth truth;
  truth.exact = lookups_.exact(fragment).color;
  truth.permitted = hull_of(lookups_.permitted_colors(fragment));
  for (std::size_t c = 0; c < truth.exact.size(); ++c)
    truth.permitted[c] = holding(truth.permitted[c], truth.exact[c]);
  for (const auto& [reach, ruling] :
       {std::pair(Reach::coarse, kRulingOnPrecision), std::pair(Reach::coarse_srgb, kRulingOnSrgb)})
    truth.contested.push_back(
        {RuleId::texture_filter, ruling,
         hull_of(truth.permitted, hull_of(lookups_.permitted_colors(fragment, reach)))});
  lookups_.forget(fragment);
  return truth;
}

}  // namespace edgecase
