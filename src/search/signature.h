// SPDX-License-Identifier: MIT
//
// Signature: what defines a find, so that two scenes can be said to show the same.
//
// For one scene it is what distinguishes clusters (results/clusters.h): the cause if there is one,
// and otherwise rule, kind and situation; always surface and legality. If a cause breaks a rule,
// rule and kind count as well: lines that leave a gap where they meet and lines that draw a pixel
// twice there are two finds, though one algorithm does both. A renderer that fails to answer is a
// find too, identified by its kind of failure.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "model/result.h"
#include "model/scene.h"
#include "results/results.h"

namespace edgecase {

struct Signature {
  std::string cause;    // "rule=alternative", several joined by " + "; empty: none found
  std::string rule;     // id; empty if the specification allows the cause
  std::string kind;     // "missing"; empty if the specification allows the cause
  std::string surface;  // "fbo", "window"
  Legality legality = Legality::illegal;
  std::string situation;  // as text; empty with a cause, and for values
  std::string attribute;  // of values within the permitted range: "color"; otherwise empty
  std::string failure;    // "crashed", "timed-out", "garbage"; then only the surface is set, too
  friend auto operator<=>(const Signature&, const Signature&) = default;
};

// All signatures of one renderer's judged result, without duplicates: first those that are not
// allowed and have no cause, then in the order of clusters_of. None if nothing differs, if the
// renderer does not support the scene, or if it could not be started.
std::vector<Signature> signatures_of(const Result& result, Surface surface);

// The same for the renderer at index `renderer`.
std::vector<Signature> signatures_of(const CaseResults& results, std::size_t renderer);

// The same for one disagreement, or for one attribute's values within the permitted range.
Signature signature_of(const Disagreement& disagreement, Surface surface);
Signature signature_of(const ValueAggregate& values, Surface surface);

// The disagreements of a result with a signature, in order; none for aggregated values and
// failures.
std::vector<const Disagreement*> disagreements_of(const Result& result, const Signature& signature);

// On one line: "line.diamond-exit extra, first pixel, not allowed, window"; "the renderer fails:
// crashed, fbo".
std::string title_of(const Signature& signature);

}  // namespace edgecase
