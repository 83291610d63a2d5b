// SPDX-License-Identifier: MIT
//
// Oracles: the rules of coverage transcribed once more, from the specification's text and not from
// our code, slow and literal. They share nothing with src/ but the numbers they are asked about.
//
// The text's "e is chosen to be so small that..." is taken at its word: the sample, or the
// endpoints, really move, by e = 2^-16 in one direction and e^2 = 2^-32 in the other, and
// everything is computed in 128-bit integers in units of 2^-32. That is small enough for
// coordinates that are multiples of 1/8 and below 32: every function that a decision hangs on is
// then a multiple of 2^-7 at e = 0, its change with e is below 2^-8, and where it is zero at e = 0
// the e-term, at least 2^-19 unless it is zero too, is larger than any e^2-term, at most 2^-25.
#pragma once

#include <array>

#include "exact/fixed.h"

namespace edgecase::oracle {

// A position in eighths of a pixel.
struct Eighths {
  int x;
  int y;
};

// The direction of the sample's move, each component one of: 1 for e, 2 for e^2, negative for the
// other way.
struct Move {
  int x;
  int y;
};

// GL 4.6 core, 14.5.1: does the segment from a to b, both ends moved against `move`, intersect the
// open diamond round the centre of pixel (x, y), and not end in it?
bool line_produces(Eighths a, Eighths b, int x, int y, Move move);

// GL 4.6 core, 14.6.1: does the moved centre of pixel (x, y) lie inside the triangle? By
// barycentric coordinates: all three have the sign of the whole.
bool triangle_produces(const std::array<Eighths, 3>& triangle, int x, int y, Move move);

// GL 4.6 core, 14.4: does the moved centre of pixel (x, y) lie inside the unit square round p?
bool point_produces(Eighths p, int x, int y, Move move);

}  // namespace edgecase::oracle
