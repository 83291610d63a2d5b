// SPDX-License-Identifier: MIT
//
// Minimize: from a scene with a find to the smallest scene that shows the same.
//
// Delta debugging: simpler scenes are tried, one step at a time, and kept if the find's signature
// is still among what they show. Steps lead to fewer primitives, default state, smaller targets,
// and rounder and smaller coordinates; they are repeated until none helps. "Simpler" is one order
// on scenes (search/scene_size.h) in which every accepted step descends, so the result is never
// worse than the input and the search ends. Scenes of a few points whose coordinates stay finer
// than 1/16 are searched for among their neighbours on coarser grids.
//
// Equal scenes, signatures and renderers give equal results. How the renderer failed on rejected
// scenes does not matter.
#pragma once

#include <array>
#include <cstddef>

#include "model/names.h"
#include "model/result.h"
#include "model/scene.h"
#include "search/trial.h"

namespace edgecase {

struct MinimizeOptions {
  std::size_t max_asks = 20'000;  // limit of rendered scenes, at least 1
};

enum class MinimizeEnd {
  finished,        // no step helps any more
  exhausted,       // max_asks scenes were rendered
  stopped,         // the trial was stopped
  not_reproduced,  // the scene does not show the signature; `scene` is the input
};
template <>
inline constexpr auto kNames<MinimizeEnd> =
    std::to_array<Named<MinimizeEnd>>({{MinimizeEnd::finished, "finished"},
                                       {MinimizeEnd::exhausted, "exhausted"},
                                       {MinimizeEnd::stopped, "stopped"},
                                       {MinimizeEnd::not_reproduced, "not-reproduced"}});

struct Minimized {
  Scene scene;
  Result result;  // of that scene, judged by the trial
  MinimizeEnd end = MinimizeEnd::finished;
  std::size_t asks = 0;   // scenes rendered for it
  int fraction_bits = 0;  // least found: fraction_bits_of the scene
  int least_bits = 0;     // no such scene shows the find with fewer (least_fraction_bits)
};

// Every scene that is kept can be written as a case file (casefile/case_writer.h), unless the input
// cannot. If the trial is stopped, the result is the best scene so far.
Minimized minimize(const Scene& scene, const Signature& signature, Trial& trial,
                   const MinimizeOptions& options);

}  // namespace edgecase
