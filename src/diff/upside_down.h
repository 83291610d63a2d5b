// SPDX-License-Identifier: MIT
//
// Answers that are right except that their rows are in the opposite order: rule window.origin.
//
// One answer alone cannot identify such a renderer. A scene may look the same upside down; ties may
// be decided the other way up, which the specification leaves open; and a sample drawn one row off
// the middle of the target is mirrored there, too. So compare() notes the evidence of each answer,
// and judge() decides by the majority of the run, as for every other cause.
#pragma once

#include "diff/drawing_compare.h"
#include "model/rendering.h"
#include "model/result.h"

namespace edgecase {

// The primitive in evidence that an answer is upside down: no single one.
inline constexpr int kWholeAnswer = -1;

// The answer with its rows in the opposite order; samples keep their places within pixels.
Rendering turned_over(Rendering rendering);

// True if the fragments of one rendering lie where those of the other lie upside down. Both must
// have the same size and sorted fragments.
bool is_covered_upside_down(const Rendering& exact, const Rendering& rendered);

// True if something in a compared answer is illegal under every snap, or whatever the snap.
bool breaks_a_ruling(const Result& result);

// Notes that the compared answer is upside down, as evidence about kWholeAnswer with the cause
// window.origin. An answer that is legal as it stands gets no cause, since it does not speak for
// this one.
void note_upside_down(Result& result);
bool is_noted_upside_down(const Result& result);

// Reports every disagreement as breaking window.origin, or undoes that.
void report_upside_down(Result& result);
void report_upright(Result& result);

}  // namespace edgecase
