// SPDX-License-Identifier: MIT
//
// Snap limit: how fine the coordinates of a scene must be at least for a find to show at all.
//
// A grid of b bits leaves a coordinate of at most b fraction bits where it is. So where the cause
// of a find is another snapping than the policy's, the two treat coarser scenes alike: nothing is
// explained there by that cause, and no such scene can show the find. No search is needed to know.
// Vertices are all that snap rules snap: the corners of wide lines, of points and of multisampled
// lines are made of snapped vertices, and those that implementations round have rules of their own.
#pragma once

#include "model/policy.h"
#include "model/scene.h"
#include "search/signature.h"

namespace edgecase {

// Fraction bits, 0 to 16; 0 where nothing is known: the cause does not speak of snapping, or what
// is snapped is other than the vertices that are given: clip coordinates, and passes that are
// shifted.
int least_fraction_bits(const Signature& signature, const Policy& policy, const Scene& scene);

}  // namespace edgecase
