// SPDX-License-Identifier: MIT
#include "search/minimize.h"

#include <algorithm>
#include <utility>

#include "search/coordinate_steps.h"
#include "search/grid_search.h"
#include "search/scene_size.h"
#include "search/scene_steps.h"
#include "search/settings.h"
#include "search/shrinking.h"

namespace edgecase {
namespace {

// The number of distant scenes to try once all else is stuck.
constexpr std::size_t kMostAfar = 4000;

bool simplify_settings(Shrinking& shrinking) {
  bool any = false;
  while (shrinking.offer_first_of(simpler_settings(shrinking.scene()))) any = true;
  return any;
}

// One round of all steps except the searches, those that remove most first.
bool take_steps(Shrinking& shrinking) {
  bool any = false;
  for (const auto step : {keep_only_finds, leave_out_draws, separate_primitives,
                          leave_out_primitives, join_draws, simplify_settings, crop_target,
                          move_to_origin, round_all, round_each, round_depths, align, draw_in})
    any = step(shrinking) || any;
  return any;
}

// Whether coordinates are as coarse as people like, or as coarse as possible.
bool is_readable(const Shrinking& shrinking) {
  return fraction_bits_of(shrinking.scene()) <= std::max(kReadableBits, shrinking.least_bits());
}

void shrink(Shrinking& shrinking) {
  bool searched_afar = false;
  while (true) {
    if (take_steps(shrinking)) continue;
    if (is_readable(shrinking)) return;
    if (search_neighbours(shrinking)) continue;
    if (is_readable(shrinking) || searched_afar) return;
    searched_afar = true;
    if (!search_afar(shrinking, kMostAfar)) return;
  }
}

}  // namespace

Minimized minimize(const Scene& scene, const Signature& signature, Trial& trial,
                   const MinimizeOptions& options) {
  const std::size_t before = trial.asked();
  Minimized minimized;
  minimized.scene = scene;
  try {
    TrialAnswer first = trial.ask(scene);
    const bool shown = std::ranges::find(first.signatures, signature) != first.signatures.end();
    minimized.result = first.result;
    minimized.end = shown ? MinimizeEnd::finished : MinimizeEnd::not_reproduced;
    if (shown) {
      Shrinking shrinking(scene, std::move(first.result), signature, trial,
                          std::max<std::size_t>(options.max_asks, 1) - 1);
      try {
        shrink(shrinking);
      } catch (const AsksExhausted&) {
        minimized.end = MinimizeEnd::exhausted;
      } catch (const SearchStopped&) {
        minimized.end = MinimizeEnd::stopped;
      }
      minimized.scene = shrinking.scene();
      minimized.least_bits = shrinking.least_bits();
      minimized.result = shrinking.result();
    }
  } catch (const SearchStopped&) {
    minimized.end = MinimizeEnd::stopped;
  }
  minimized.asks = trial.asked() - before;
  minimized.fraction_bits = fraction_bits_of(minimized.scene);
  return minimized;
}

}  // namespace edgecase
