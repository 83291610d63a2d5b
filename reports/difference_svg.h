// SPDX-License-Identifier: MIT
//
// One case as exact and as a renderer draws it, side by side, as an SVG picture for documents.
//
// Pixels are coloured by how many fragments they hold. A pixel that differs has a frame, solid
// where the specification forbids the difference and dashed where it allows it, and in the
// renderer's panel a sign: - missing, + extra, 2 drawn twice, a crossed = another value. What the
// rule looks at, such as a line's diamond, is drawn over both panels. The picture brings its own
// background: it reads the same on a light and on a dark page.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "model/figure.h"
#include "model/verdict.h"

namespace edgecase {

struct DifferencePicture {
  int width = 0;  // pixels
  int height = 0;
  std::string title;
  std::string renderer;         // the second panel's title
  std::vector<int> exact_hits;  // fragments per pixel, row by row from the bottom, width * height
  std::vector<int> rendered_hits;
  Figure figure;                            // the scene's outlines, drawn over both panels
  std::vector<Disagreement> disagreements;  // may be empty
  Verdict verdict = Verdict::agree;
};

// What a renderer drew: exact's fragments per pixel and the disagreements on coverage.
std::vector<int> rendered_hits(const std::vector<int>& exact_hits, int width,
                               const std::vector<Disagreement>& disagreements);

// The same picture gives the same bytes. The caller checks the stream's state afterwards.
void write_difference_svg(const DifferencePicture& picture, std::ostream& out);

}  // namespace edgecase
