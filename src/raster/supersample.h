// SPDX-License-Identifier: MIT
//
// The exact rasterizer's supersampled path: each pass drawn by itself, then the weighted mean of
// what they show.
//
//   pass_of -> rasterize -> the last fragment of each pixel -> exact mean -> nearest double
//
// Under another choice of supersample.accumulation the last two steps are that one's.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "model/policy.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "rules/samples/accumulation.h"

namespace edgecase {

// Draws one pass: a scene that is not supersampled.
using DrawPass = Rendering (*)(const Scene& scene, const Policy& policy,
                               const SamplePositions& reported);

// The rendering of a supersampled scene under a policy: passes, accumulated image, pixels.
Rendering draw_passes(const Scene& scene, const Policy& policy, DrawPass draw);

// What passes show, whoever drew them: one for each of the scene's, fragments sorted, all with a
// colour. Calls `visit` for each number of the accumulated image, in its order, with a value for
// each pass.
void for_each_shown(const Scene& scene, std::span<const Rendering> passes,
                    const std::function<void(std::span<const double>)>& visit);

// Rendering::accumulated of such passes.
std::vector<double> accumulated_image(const Scene& scene, std::span<const Rendering> passes,
                                      Accumulation choice = Accumulation::exact_mean);

}  // namespace edgecase
