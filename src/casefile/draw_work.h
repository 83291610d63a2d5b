// SPDX-License-Identifier: MIT
//
// What drawing a scene may cost, told before anything is drawn: a case file of a few lines can ask
// for more fragments than any machine holds.
#pragma once

#include <cstdint>

#include "casefile/fields.h"
#include "model/scene.h"

namespace edgecase {

// Samples that the primitives of a case may cover, counted as often as they are: two screens of
// 2048 by 2048 pixels. Exact takes some 200 bytes and 2 microseconds for each.
constexpr std::uint64_t kMaxDrawnSamples = std::uint64_t{1} << 23;

// An upper bound of that number: what lies in the target and the scissor box, of each triangle half
// the box around it and its border, of each line a band, of each point a square; over all passes of
// a supersampled scene. Vertices must have been placed. A triangle that is clipped counts as the
// box round it, and as all that can be drawn to where it reaches behind the eye, as a clipped line
// does.
std::uint64_t most_drawn_samples(const Scene& scene);

// Refuses a scene of which that is more than kMaxDrawnSamples. `draws`: where the file has them.
void check_draw_work(const Scene& scene, const Place& draws, Findings& findings);

}  // namespace edgecase
