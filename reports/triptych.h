// SPDX-License-Identifier: MIT
//
// One answer as three pictures side by side: exact, the difference, and what was rendered.
//
// The middle one is a pale print of exact with every pixel on which the two differ in a colour:
// blue missing, orange extra, violet duplicate, green value, and pale green where stored bytes
// differ within what is permitted. Where pixels are shown small, each has a halo, so that a single
// one is seen. Alpha is left out of the outer pictures and not of the difference.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "results/results.h"

namespace edgecase {

struct Triptych {
  int width = 0;  // pixels, of the three and what parts them
  int height = 0;
  std::vector<std::uint8_t> rgba;  // row by row from the bottom, opaque
  // By which to enlarge it, 1 to 16: a picture then has some 320 pixels along its longer side, and
  // its pixels at least 2 where it has no more than 1,024.
  int scale = 1;
};

// Nothing where there is nothing to see: the renderer did not answer with a picture of the case's
// size, or neither the picture nor a disagreement tells it from exact.
std::optional<Triptych> triptych_of(const CaseResults& one, const Result& result);

}  // namespace edgecase
