// SPDX-License-Identifier: MIT
//
// Coverage: which pixels of targets with one sample a renderer draws.
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

// Probes with their observations: observations[i] is of probes[i].scene.
template <class Probe>
struct Seen {
  std::span<const Probe> probes;
  std::span<const Observation> observations;
};

// Who owns each part of a diamond at the start and at the end of lines, by direction.
std::vector<OwnershipTable> diamond_tables(const Seen<DiamondProbe>& seen);
// The share of probes in which the choice and the renderer agree on the probed pixel.
Trait diamond_trait(const Seen<DiamondProbe>& seen, const CoverageChoice& lines);

// Who owns samples exactly on each side and corner of triangles.
std::vector<OwnershipTable> edge_tables(const Seen<EdgeProbe>& seen);
Trait edge_trait(const Seen<EdgeProbe>& seen, const CoverageChoice& triangles);

// Whether joints of lines that continue in one direction satisfy ruling 14, and whether turning
// joints are drawn as the choice draws their segments.
std::vector<Trait> joint_traits(const Seen<JointProbe>& seen, const CoverageChoice& lines);

// Holes and double hits on edges that two triangles share (ruling 5, with the bits of ruling 4).
Trait shared_edge_trait(std::span<const Observation* const> observations, int bits);

// Whether primitives that extend beyond the viewport are drawn as in one that contains them.
std::vector<Trait> clip_traits(const Seen<ClipProbe>& seen, std::span<const Observation> unclipped);

// Which vertex gives flat primitives their colour. renderings[i] is of scenes[i], a provoking
// probe; nothing if the renderer does not draw it.
Trait provoking_trait(std::span<const Scene> scenes,
                      std::span<const std::optional<Rendering>> renderings);

extern const Subject kCoverageSubject;

}  // namespace edgecase
