// SPDX-License-Identifier: MIT
//
// Every disagreement of a run as comma-separated values (RFC 4180), for spreadsheets and scripts.
//
// One row per disagreement, by case, then by renderer, then as results have them; the first row
// names the columns:
//
//   case         id
//   renderer     as the command line names it
//   verdict      of the renderer's answer to the case as a whole
//   standing     of the same: expected, known, unexpected, tolerated or flake
//   x, y         pixel column and row, y up
//   sample       index of a sample or pass; -1: the pixel, or the image, as a whole
//   primitive    index in drawing order; -1: the pixel as a whole
//   kind         missing, extra, duplicate or value
//   rule         id
//   legality     legal, contested or illegal
//   ruling       number of the ruling by which that was decided; 0: none
//   cause        the alternatives that reproduce it; empty: none found
//   situation    where on the primitive it lies, in words; may be empty
//   exact        hits, or components of a value, separated by spaces, all digits that they have
//   rendered     the same of the renderer
//   explanation  a sentence
//   file         path of the case file, as given
//
// Of a gross fault those that are only counted (Result::counted) have a row for each of their
// classes, at the first pixel and with their number as the explanation.
//
// Values that differ within what is permitted are no disagreements; the results file counts them.
#pragma once

#include <iosfwd>

#include "results/results.h"

namespace edgecase {

// Writes the rows in UTF-8 one by one, each ended by CR LF; texts are xml_text(), so that a line
// feed inside quotes is the only control character. The caller checks the stream's state
// afterwards.
void write_disagreements_csv(const Results& results, std::ostream& out);

}  // namespace edgecase
