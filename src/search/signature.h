// SPDX-License-Identifier: MIT
//
// Signature: what a find is about, so that two scenes can be said to show the same.
//
// It is what clusters are told apart by (results/clusters.h), for one scene: the cause where there
// is one, and otherwise rule, kind and situation; surface and legality always. Where a cause breaks
// a rule, rule and kind count beside it: lines that leave a gap where they meet and lines that draw
// a pixel twice there are two finds, though one algorithm does both. A renderer that fails where it
// should answer is a find too, identified by how it fails.
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
  std::string rule;     // id; empty where there is a cause that the specification allows
  std::string kind;     // "missing"; empty where there is a cause that the specification allows
  std::string surface;  // "fbo", "window"
  Legality legality = Legality::illegal;
  std::string situation;  // in words; empty where there is a cause, and for values
  std::string attribute;  // of values inside what is permitted: "color"; empty otherwise
  std::string failure;    // "crashed", "timed-out", "garbage"; then all but the surface is empty
  friend auto operator<=>(const Signature&, const Signature&) = default;
};

// All that one renderer's judged result shows, each once: first what is not allowed and has no
// cause, then in the order of clusters_of. None where nothing differs, and where the renderer says
// that it does not do this, or could not be started.
std::vector<Signature> signatures_of(const Result& result, Surface surface);

// The same of the renderer at `renderer`.
std::vector<Signature> signatures_of(const CaseResults& results, std::size_t renderer);

// The same of one disagreement, or of one attribute's values inside what is permitted.
Signature signature_of(const Disagreement& disagreement, Surface surface);
Signature signature_of(const ValueAggregate& values, Surface surface);

// The disagreements of a result that have a signature, in their order; none of aggregated values
// and of failures.
std::vector<const Disagreement*> disagreements_of(const Result& result, const Signature& signature);

// On one line: "line.diamond-exit extra, first pixel, not allowed, window"; "the renderer fails:
// crashed, fbo".
std::string title_of(const Signature& signature);

}  // namespace edgecase
