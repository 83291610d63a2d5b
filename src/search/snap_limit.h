// SPDX-License-Identifier: MIT
//
// Snap limit: how fine the coordinates of a scene must be at least for a find to show at all.
//
// A grid of b bits leaves a coordinate of at most b fraction bits where it is. So where the cause
// of a find is another snapping than the policy's, the two treat coarser scenes alike: nothing is
// explained there by that cause, and no such scene can show the find. No search is needed to know.
// Of primitives that get corners of their own, wide lines and all on multisampled targets, the
// corners are snapped as well, wherever the vertices lie: of them nothing is said.
#pragma once

#include "model/policy.h"
#include "model/scene.h"
#include "search/signature.h"

namespace edgecase {

// Fraction bits, 0 to 16; 0 where nothing is known: the cause does not speak of snapping, or what
// is snapped is more than the vertices (see above), or other than they are given: clip coordinates,
// and passes that are shifted.
int least_fraction_bits(const Signature& signature, const Policy& policy, const Scene& scene);

}  // namespace edgecase
