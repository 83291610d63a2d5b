// SPDX-License-Identifier: MIT
//
// Coverage: which pixels of targets of one sample a renderer draws.
//
//   random scenes and probes -> inferred choice -> how it draws each family of probes
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "profile/coverage/probes.h"
#include "profile/evidence/findings.h"
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
Trait shared_edge_trait(std::span<const Observation* const> observations, int bits);

// Primitives that reach beyond the viewport: are they drawn as in a viewport that holds them?
std::vector<Trait> clip_traits(const Seen<ClipProbe>& seen, std::span<const Observation> unclipped);

// Which vertex gives flat primitives their colour. renderings[i] is of scenes[i], a provoking
// probe; none where the renderer does not draw it.
Trait provoking_trait(std::span<const Scene> scenes,
                      std::span<const std::optional<Rendering>> renderings);

extern const Subject kCoverageSubject;

}  // namespace edgecase
