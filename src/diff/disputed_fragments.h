// SPDX-License-Identifier: MIT
//
// Disputed fragments: what either side makes at the pixels at which they differ, for those who show
// it. Nothing is judged by them.
#pragma once

#include <cstddef>

#include "model/rendering.h"
#include "model/result.h"

namespace edgecase {

// A comparison in which both sides together have at most this many fragments tells them all.
constexpr std::size_t kMostOfSmall = 64;

// Fills the result's lists of fragments, in the order of passes and, within a pass, of renderings.
// Beyond kMostOfSmall they hold all fragments at the pixels of disagreements, and at the worst
// place of each aggregate whose values differ. Both renderings have the size that `result` is
// about.
void tell_fragments(const Rendering& exact, const Rendering& rendered, Result& result);

}  // namespace edgecase
