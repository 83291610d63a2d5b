// SPDX-License-Identifier: MIT
//
// Made-up results for tests of the reports: every verdict, standing, kind of disagreement and
// failure, values, evidence, broken files, and texts that try to leave the place they are put in.
// The pictures look like those of a run (lines with diamonds, triangles with a shared edge, smooth
// colours), the numbers in them are not.
#pragma once

#include <string>
#include <vector>

#include "reports/html.h"
#include "results/results.h"

namespace edgecase::sample {

// Markup, a script's end, quotes, a right-to-left override, a control character, broken UTF-8.
extern const std::string kHostile;

// Four renderers, about 60 cases, sorted by id.
Results results();
ReportTexts texts();

// Those of the cases that have levels of detail along a row of pixels.
std::vector<CaseResults> ramp_cases();

// With four samples a pixel: a renderer that agrees, one that lacks sample 0 of pixel (3, 3) and
// resolves it wrongly, one with samples elsewhere, and one that tells neither positions nor hits.
CaseResults multisampled_case();

// One disagreement at (x, y) without figure.
Disagreement disagreement(int x, int y, DisagreementKind kind, bool legal);

}  // namespace edgecase::sample
