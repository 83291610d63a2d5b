// SPDX-License-Identifier: MIT
//
// Answers that are right but for their rows, which stand in the opposite order: rule window.origin.
//
// One answer alone cannot tell such a renderer from others. A scene may look the same upside down;
// ties may be decided the other way up, which is open; and a sample drawn one row off the middle of
// the target is mirrored there, too. So compare() notes what an answer by itself says, and judge()
// decides by what most of the run says, as it does of every other cause.
#pragma once

#include "diff/drawing_compare.h"
#include "model/rendering.h"
#include "model/result.h"

namespace edgecase {

// The primitive of the evidence that an answer is upside down: none, since it is about all of them.
inline constexpr int kWholeAnswer = -1;

// The same answer with its rows in the opposite order; samples keep their places within pixels.
Rendering turned_over(Rendering rendering);

// Do the fragments of one rendering lie where those of the other lie upside down? Both have one
// size, and fragments in order.
bool is_covered_upside_down(const Rendering& exact, const Rendering& rendered);

// Whether every snap makes something of a compared answer illegal, or something is in any case.
bool breaks_a_ruling(const Result& result);

// Notes that the compared answer is upside down: as evidence about kWholeAnswer, whose cause is
// window.origin. If the answer is legal as it stands, it has none: it does not speak for the cause.
void note_upside_down(Result& result);
bool is_noted_upside_down(const Result& result);

// Says of all that disagrees that it breaks window.origin, or what it breaks without that.
void tell_upside_down(Result& result);
void tell_upright(Result& result);

}  // namespace edgecase
