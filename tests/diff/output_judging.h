// SPDX-License-Identifier: MIT
//
// Judging renderings of scenes with fragment operations.
#pragma once

#include <set>
#include <string>

#include "model/policy.h"
#include "model/rendering.h"
#include "model/result.h"
#include "model/scene.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {

// A random scene with operations, culling and polygon offsets.
Scene random_output_scene(RandomScenes& random, int size = 10);
// The same, multisampled, of triangles.
Scene random_multisampled_output_scene(RandomScenes& random);

Policy policy_of(const std::string& rule, const std::string& alternative);

// Held against exact under a policy, and judged alone.
Result judge_output(const Scene& scene, const Policy& policy, const Rendering& rendered,
                    Latitude latitude = Latitude::opengl, int subpixel_bits = 8);

std::set<std::string> causes_in(const Result& result);  // of all disagreements
std::set<std::string> rules_in(const Result& result);
// Of the aggregates.
std::set<std::string> aggregate_causes_in(const Result& result);

// All that was found, for messages.
std::string told(const Result& result);

}  // namespace edgecase
