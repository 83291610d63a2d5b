// SPDX-License-Identifier: MIT
//
// Sweeps: edges that pass over a pixel in steps of 1/256, to find where its samples lie.
//
// Each scene has one triangle with a vertical or a horizontal edge, on its left, right, lower or
// upper side, that crosses the whole pixel. A sample that an edge at one place covers and an edge
// at the next does not lies between the two, where the edges are after they were snapped.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "profile/observation.h"
#include "profile/samples/sample_profile.h"
#include "rules/coverage/snap.h"

namespace edgecase {

constexpr int kSweepSteps = 256;  // per pixel

// The number of scenes of a sweep.
constexpr std::size_t kSweepScenes = 4 * (kSweepSteps + 1);

// Of a target with so many samples.
std::vector<Scene> sweep_scenes(int samples);

// What the sweeps, observed in order, say. `snap`: how vertices are snapped.
MeasuredPositions measured_positions(std::span<const Observation> sweeps, Snap snap);

}  // namespace edgecase
