// SPDX-License-Identifier: MIT
//
// One case as an SVG picture for documents, in three panes: exact, the difference, the renderer.
//
// Pixels are coloured by how many fragments they hold. A pixel that differs has a frame in every
// pane, solid if the specification forbids the difference and dashed if it allows it. The middle
// pane shows each frame's sign (- missing, + extra, 2 drawn twice, a crossed = another value) and
// the geometry that the rule tests, such as a line's diamond. All panes are cropped to the pixels
// that either side draws and a margin of one pixel. The picture has its own background, so that it
// suits light and dark pages.
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

// The renderer's fragments per pixel: exact's, corrected by the disagreements on coverage.
std::vector<int> rendered_hits(const std::vector<int>& exact_hits, int width,
                               const std::vector<Disagreement>& disagreements);

// The same picture gives the same bytes. The caller checks the stream's state afterwards.
void write_difference_svg(const DifferencePicture& picture, std::ostream& out);

// One pane alone, without text, small enough for a row of a table.
void write_pane_svg(const DifferencePicture& picture, Pane pane, std::ostream& out);

}  // namespace edgecase
