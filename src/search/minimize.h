// SPDX-License-Identifier: MIT
//
// Minimize: from a scene with a find to the smallest scene that shows the same.
//
// Delta debugging: what is simpler is asked, one step at a time, and kept where the signature of
// the find is still among what it shows. Steps make fewer primitives, default state, smaller
// targets, rounder and smaller coordinates; they are repeated until none helps. What "simpler"
// means is one order on scenes (search/scene_size.h) that every accepted step descends in, so that
// the result is never worse than the input and the search ends. Scenes of a few points whose
// coordinates stay finer than 1/16 are searched for among their neighbours on coarser grids.
//
// The same scene, signature and renderer give the same result. Nothing is learnt from how the
// renderer failed on what was not kept.
#pragma once

#include <cstddef>

#include "model/result.h"
#include "model/scene.h"
#include "search/signature.h"
#include "search/trial.h"

namespace edgecase {

struct MinimizeOptions {
  std::size_t max_asks = 20'000;  // scenes that the renderer is asked, at least 1
};

enum class MinimizeEnd {
  finished,        // no step helps any more
  exhausted,       // max_asks scenes were asked
  stopped,         // the trial was stopped
  not_reproduced,  // the scene does not show the signature; `scene` is the input
};

struct Minimized {
  Scene scene;
  Result result;  // of that scene, judged as the trial does
  MinimizeEnd end = MinimizeEnd::finished;
  std::size_t asks = 0;   // scenes asked for it
  int fraction_bits = 0;  // least found: fraction_bits_of the scene
  int least_bits = 0;     // none like it shows the find with fewer (least_fraction_bits)
};

// Every scene that is kept can be written as a case file (casefile/case_writer.h), unless the input
// cannot. Where the trial is stopped, the best scene so far.
Minimized minimize(const Scene& scene, const Signature& signature, Trial& trial,
                   const MinimizeOptions& options);

}  // namespace edgecase
