// SPDX-License-Identifier: MIT
//
// One case as an SVG picture for documents, in three panes: exact, the difference, the renderer.
//
// Pixels are coloured by how many fragments they hold. A pixel that differs has a frame in every
// pane, solid where the specification forbids the difference and dashed where it allows it. The
// middle pane shows each frame's sign (- missing, + extra, 2 drawn twice, a crossed = another
// value) and what the rule looks at, such as a line's diamond. All panes are cropped to the pixels
// that either side draws and one more all round. The picture brings its own background: it reads
// the same on a light and on a dark page.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "model/figure.h"
#include "model/verdict.h"

namespace edgecase {

enum class Pane { exact, difference, renderer };

// "exact", "difference" or "renderer", the names that `edgecase draw --pane` takes; else none.
std::optional<Pane> pane_named(const std::string& name);

struct DifferencePicture {
  int width = 0;  // pixels
  int height = 0;
  std::string title;
  std::string renderer;         // the third pane's title
  std::vector<int> exact_hits;  // fragments per pixel, row by row from the bottom, width * height
  std::vector<int> rendered_hits;
  Figure figure;                            // the scene's outlines, drawn over all panes
  std::vector<Disagreement> disagreements;  // may be empty
  Verdict verdict = Verdict::agree;
};

// What a renderer drew: exact's fragments per pixel and the disagreements on coverage.
std::vector<int> rendered_hits(const std::vector<int>& exact_hits, int width,
                               const std::vector<Disagreement>& disagreements);

// The same picture gives the same bytes. The caller checks the stream's state afterwards.
void write_difference_svg(const DifferencePicture& picture, std::ostream& out);

// One pane alone, without a word: small enough to stand in a line of a table.
void write_pane_svg(const DifferencePicture& picture, Pane pane, std::ostream& out);

}  // namespace edgecase
