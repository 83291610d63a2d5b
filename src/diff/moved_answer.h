// SPDX-License-Identifier: MIT
//
// Answers that lie one pixel off: all fragments of them, and all the same way.
//
// A renderer that has its picture one column to the right breaks most rulings on coverage, and now
// and then one of its primitives is drawn as some alternative would have drawn it. None of these is
// a cause: the next primitive refutes it. One answer alone cannot tell such a renderer from one
// that draws a single point beside its place. So compare() notes what an answer by itself says, and
// judge() decides by what most of the run says: where most answers that break a ruling are moved,
// what is illegal in these has no cause.
#pragma once

#include "model/rendering.h"
#include "model/result.h"

namespace edgecase {

// The primitive of the evidence that an answer is moved: none, since it is about all of them.
inline constexpr int kMovedAnswer = -2;

// Do all fragments of one rendering lie where those of the other do, moved by one pixel along x, y
// or both? What lies at the border, where one of both is not seen, is left out; something must be
// left. Both have one size, and fragments in order.
bool is_covered_moved(const Rendering& exact, const Rendering& rendered);

// Notes that the compared answer is moved.
void note_moved(Result& result);
bool is_noted_moved(const Result& result);

}  // namespace edgecase
