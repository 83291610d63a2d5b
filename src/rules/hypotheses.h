// SPDX-License-Identifier: MIT
//
// Hypotheses: ways in which whole renderers that people wrote draw, tried before anything finer.
//
// Who cuts vertices to whole pixels differs on nearly every triangle, and each difference taken
// alone fits dozens of finer causes. A hypothesis is about all that an answer covers, or about the
// whole picture; the run tells the one that explains most answers (rules/portrait.h). A
// hypothesis is no excuse: verdicts do not depend on it.
#pragma once

#include <cstdint>
#include <string>

#include "rules/coverage/window.h"

namespace edgecase {

// The place of a pixel that is tested, or how far the whole drawing lies off.
enum class SampledPlace {
  centre,
  lower_left,
  upper_left,
  lower_right,
  upper_right,
  one_left,  // everything is drawn a pixel farther left; and so on
  one_right,
  one_below,
  one_above,
  one_left_below,
  one_right_above,
  one_left_above,
  one_right_below,
  shrunk,   // the viewport is mapped to one pixel less in width and height
  limited,  // the viewport is mapped to its part in the target
};

// How vertices are rounded before anything is decided.
enum class VertexGrid {
  as_chosen,           // as the policy has it
  reported,            // to the grid of the reported bits, to the nearest
  reported_truncated,  // the same, down
  whole_truncated,     // to whole pixels, down
  whole_rounded,       // to whole pixels, to the nearest
  halves_truncated,    // 1 bit
  halves_rounded,      //
  quarters_truncated,  // 2 bits
  quarters_rounded,    //
  eighths_truncated,   // 3 bits
  eighths_rounded,     //
};

// What is never drawn.
enum class LeftOut {
  nothing,
  clockwise,          // triangles that run clockwise in the window, y up
  counter_clockwise,  // the others
  later_draws,        // all draws but the first
  everything,
  small_ones,   // primitives below some size
  lowest_row,   // of each primitive
  highest_row,  // of each primitive
  first_row,    // of the target
  failing,      // fragments that fail a test are not told
};

// How an answer covers what it covers.
struct CoverageHypothesis {
  static constexpr int kPlaces = static_cast<int>(SampledPlace::limited) + 1;
  static constexpr int kGrids = static_cast<int>(VertexGrid::eighths_rounded) + 1;
  static constexpr int kLeftOuts = static_cast<int>(LeftOut::failing) + 1;
  static constexpr int kTies = 11;  // the policy's, then all_tie_rules()

  VertexGrid grid = VertexGrid::as_chosen;
  SampledPlace place = SampledPlace::centre;
  int ties = 0;  // 0: as the policy has them; else the tie rule of that number, from 1
  bool is_upside_down = false;
  LeftOut left_out = LeftOut::nothing;
  friend bool operator==(const CoverageHypothesis&, const CoverageHypothesis&) = default;

  // The number of parts that are not as they should be.
  int parts() const;
  std::uint16_t number() const;
  static CoverageHypothesis of(std::uint16_t number);
};

// The move of the drawing, in halves of a pixel, by which the pixels' centres come to lie where
// their samples are taken.
struct HalfPixels {
  int dx = 0;
  int dy = 0;
};
HalfPixels move_of(SampledPlace place);
// The rounding of a grid that is not as_chosen.
Snap snap_of(VertexGrid grid, int reported_bits);

// What becomes of the right colours, in each pixel of an answer that covers what it should.
enum class ColorHypothesis : std::uint16_t {
  red_and_blue_exchanged = 60000,
  alpha_first,  // the order is alpha, red, green, blue
  at_most_254,  // 255 is stored as 254
  alpha_always_255,
  alpha_always_0,
  all_black,
  inverted,
};

// "samples pixels at their lower left corner": what the renderer does wrong.
std::string meaning_of(const CoverageHypothesis& hypothesis);
std::string meaning_of(ColorHypothesis hypothesis);
// The same of a number of either.
std::string meaning_of_hypothesis(std::uint16_t number);
bool is_about_colors(std::uint16_t number);
// True if it differs from the policy in samples on edges only.
bool is_about_ties_alone(std::uint16_t number);
// False if the specification leaves all of it open: grids of enough bits, and orders of ties that
// keep shared edges whole.
bool is_fault(std::uint16_t number);

// Marks among the numbers of an answer (ResultOutline::hypotheses): it covers something else than
// it should; it covers what it should, and its colours are others; one alternative of the
// catalogue, which the specification forbids, explains all that it covers.
constexpr std::uint16_t kAskedOfCoverage = 65000;
constexpr std::uint16_t kAskedOfColors = 65001;
constexpr std::uint16_t kHasOneCause = 65002;

}  // namespace edgecase
