// SPDX-License-Identifier: MIT
#include "diff/values/equal_values.h"

#include <algorithm>

#include "model/fragments.h"

namespace edgecase {
namespace {

bool are_equal(const Fragment& a, const Fragment& b) {
  return cover_alike(a, b) && have_equal_values(a, b) && a.has_depth == b.has_depth &&
         a.has_color == b.has_color && a.detail < 0 && b.detail < 0;
}

bool has_offset(const Draw& draw) {
  return draw.polygon_offset.has_value();
}

}  // namespace

bool has_exact_values(const Scene& scene, const ResolvedPolicy& policy, const Rendering& exact,
                      const Rendering& rendered) {
  const bool is_plain = scene.target.samples == 1 && scene.supersampling.empty() &&
                        scene.textures.empty() && !has_fragment_operations(scene) &&
                        std::ranges::none_of(scene.draws, &has_offset);
  return is_plain && policy.is_standard() && exact.pixels == rendered.pixels &&
         std::ranges::equal(exact.depths, rendered.depths, {}, bits_of, bits_of) &&
         std::ranges::equal(exact.fragments, rendered.fragments, are_equal);
}

}  // namespace edgecase
