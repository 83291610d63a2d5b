// SPDX-License-Identifier: MIT
//
// Probe traits: what each family of probes says of a renderer whose choice has been inferred.
#pragma once

#include <span>
#include <vector>

#include "profile/observation.h"
#include "profile/probes/probe_scenes.h"
#include "profile/profile.h"
#include "rules/choices.h"

namespace edgecase {

// Probes with what was observed of each: observations[i] is of probes[i].scene.
template <class Probe>
struct Seen {
  std::span<const Probe> probes;
  std::span<const Observation> observations;
};

// Who owns each part of a diamond at the start and at the end of lines, by direction.
std::vector<OwnershipTable> diamond_tables(const Seen<DiamondProbe>& seen);
// In how many probes the choice draws the probed pixel, or leaves it out, as the renderer does.
Trait diamond_trait(const Seen<DiamondProbe>& seen, const CoverageChoice& lines);

// Who owns samples exactly on each side and corner of triangles.
std::vector<OwnershipTable> edge_tables(const Seen<EdgeProbe>& seen);
Trait edge_trait(const Seen<EdgeProbe>& seen, const CoverageChoice& triangles);

// Joints of lines that go on in one direction: do they hold ruling 14? And joints that turn: are
// they drawn as the choice draws their segments?
std::vector<Trait> joint_traits(const Seen<JointProbe>& seen, const CoverageChoice& lines);

// Holes and double hits on edges that two triangles share (ruling 5, at the bits of ruling 4).
Trait shared_edge_trait(std::span<const Observation> observations, int bits);

// Primitives that reach beyond the viewport: are they drawn as in a viewport that holds them?
std::vector<Trait> clip_traits(const Seen<ClipProbe>& seen, std::span<const Observation> unclipped);

// Which vertex gives flat primitives their colour, whole renderings of the provoking probes given.
Trait provoking_trait(std::span<const Scene> scenes, std::span<const Outcome> outcomes);

}  // namespace edgecase
