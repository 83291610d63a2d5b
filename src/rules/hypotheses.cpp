// SPDX-License-Identifier: MIT
#include "rules/hypotheses.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "rules/coverage/tie_rule.h"

namespace edgecase {
namespace {

constexpr int kPlaces = CoverageHypothesis::kPlaces;
constexpr int kGrids = CoverageHypothesis::kGrids;
constexpr int kLeftOuts = CoverageHypothesis::kLeftOuts;
constexpr int kTies = CoverageHypothesis::kTies;

// A move of the whole drawing by halves of a pixel, by which the pixels' centres come to lie where
// their samples are taken.
struct Move {
  SampledPlace place;
  int dx;
  int dy;
  const char* meaning;
};
constexpr std::array kMoves = {
    Move{SampledPlace::centre, 0, 0, ""},
    Move{SampledPlace::lower_left, 1, 1, "samples pixels at their lower left corner"},
    Move{SampledPlace::upper_left, 1, -1, "samples pixels at their upper left corner"},
    Move{SampledPlace::lower_right, -1, 1, "samples pixels at their lower right corner"},
    Move{SampledPlace::upper_right, -1, -1, "samples pixels at their upper right corner"},
    Move{SampledPlace::one_left, -2, 0, "draws everything a pixel too far left"},
    Move{SampledPlace::one_right, 2, 0, "draws everything a pixel too far right"},
    Move{SampledPlace::one_below, 0, -2, "draws everything a pixel too low"},
    Move{SampledPlace::one_above, 0, 2, "draws everything a pixel too high"},
    Move{SampledPlace::one_left_below, -2, -2, "draws everything a pixel too far left and too low"},
    Move{SampledPlace::one_right_above, 2, 2,
         "draws everything a pixel too far right and too high"},
    Move{SampledPlace::one_left_above, -2, 2, "draws everything a pixel too far left and too high"},
    Move{SampledPlace::one_right_below, 2, -2,
         "draws everything a pixel too far right and too low"},
    Move{SampledPlace::shrunk, 0, 0, "maps the viewport to one pixel less in width and height"},
    Move{SampledPlace::limited, 0, 0, "limits the viewport to the target"},
};
static_assert(kMoves.size() == kPlaces);

struct Grid {
  VertexGrid grid;
  int bits;  // -1: the reported ones
  Snap::Rounding rounding;
  const char* meaning;
};
constexpr std::array kGridRows = {
    Grid{VertexGrid::as_chosen, 0, {}, ""},
    Grid{VertexGrid::reported, -1, Snap::Rounding::half_up,
         "rounds vertices to the grid that it reports"},
    Grid{VertexGrid::reported_truncated, -1, Snap::Rounding::truncate,
         "cuts vertices to the grid that it reports"},
    Grid{VertexGrid::whole_truncated, 0, Snap::Rounding::truncate, "cuts vertices to whole pixels"},
    Grid{VertexGrid::whole_rounded, 0, Snap::Rounding::half_up, "rounds vertices to whole pixels"},
    Grid{VertexGrid::halves_truncated, 1, Snap::Rounding::truncate,
         "cuts vertices to halves of a pixel"},
    Grid{VertexGrid::halves_rounded, 1, Snap::Rounding::half_up,
         "rounds vertices to halves of a pixel"},
    Grid{VertexGrid::quarters_truncated, 2, Snap::Rounding::truncate,
         "cuts vertices to quarters of a pixel"},
    Grid{VertexGrid::quarters_rounded, 2, Snap::Rounding::half_up,
         "rounds vertices to quarters of a pixel"},
    Grid{VertexGrid::eighths_truncated, 3, Snap::Rounding::truncate,
         "cuts vertices to eighths of a pixel"},
    Grid{VertexGrid::eighths_rounded, 3, Snap::Rounding::half_up,
         "rounds vertices to eighths of a pixel"},
};
static_assert(kGridRows.size() == kGrids);

struct LeftOutRow {
  LeftOut left_out;
  const char* meaning;
};
constexpr std::array kLeftOutRows = {
    LeftOutRow{LeftOut::nothing, ""},
    LeftOutRow{LeftOut::clockwise, "draws no triangle that runs clockwise"},
    LeftOutRow{LeftOut::counter_clockwise, "draws no triangle that runs counter-clockwise"},
    LeftOutRow{LeftOut::later_draws, "draws nothing after a scene's first draw"},
    LeftOutRow{LeftOut::everything, "draws nothing"},
    LeftOutRow{LeftOut::small_ones, "draws no primitive below a size"},
    LeftOutRow{LeftOut::lowest_row, "loses the lowest row of each primitive"},
    LeftOutRow{LeftOut::highest_row, "loses the highest row of each primitive"},
    LeftOutRow{LeftOut::first_row, "loses the lowest row of the target"},
    LeftOutRow{LeftOut::failing, "does not tell the fragments that fail a depth or stencil test"},
};
static_assert(kLeftOutRows.size() == kLeftOuts);

template <class Row, std::size_t N, class Value>
const char* meaning_in(const std::array<Row, N>& rows, Value value) {
  return rows[static_cast<std::size_t>(value)].meaning;
}

bool is_fault_of_grid(VertexGrid grid) {
  return grid > VertexGrid::reported_truncated;
}

TieRule::Kind kind_of_ties(int ties) {
  return ties == 0 ? TieRule::Kind::perturbed
                   : all_tie_rules()[static_cast<std::size_t>(ties - 1)].kind;
}

bool is_fault_of_ties(int ties) {
  return kind_of_ties(ties) != TieRule::Kind::perturbed;
}

std::string meaning_of_ties(int ties) {
  switch (kind_of_ties(ties)) {
    case TieRule::Kind::perturbed:
      return "";
    case TieRule::Kind::closed:
      return "draws samples on every edge";
    case TieRule::Kind::open:
      return "draws no sample on an edge";
  }
  return "";
}

}  // namespace

HalfPixels move_of(SampledPlace place) {
  const Move& move = kMoves[static_cast<std::size_t>(place)];
  return {move.dx, move.dy};
}

Snap snap_of(VertexGrid grid, int reported_bits) {
  const Grid& row = kGridRows[static_cast<std::size_t>(grid)];
  return {row.bits < 0 ? reported_bits : row.bits, row.rounding};
}

int CoverageHypothesis::parts() const {
  return int{grid != VertexGrid::as_chosen} + int{place != SampledPlace::centre} + int{ties != 0} +
         int{is_upside_down} + int{left_out != LeftOut::nothing};
}

std::uint16_t CoverageHypothesis::number() const {
  int number = static_cast<int>(left_out);
  number = 2 * number + int{is_upside_down};
  number = kGrids * number + static_cast<int>(grid);
  number = kPlaces * number + static_cast<int>(place);
  number = kTies * number + ties;
  return static_cast<std::uint16_t>(number);
}
static_assert(kLeftOuts * 2 * kGrids * kPlaces * kTies <
              static_cast<int>(ColorHypothesis::red_and_blue_exchanged));

CoverageHypothesis CoverageHypothesis::of(std::uint16_t number) {
  int rest = number;
  const auto take = [&rest](int count) { return std::exchange(rest, rest / count) % count; };
  CoverageHypothesis hypothesis;
  hypothesis.ties = take(kTies);
  hypothesis.place = static_cast<SampledPlace>(take(kPlaces));
  hypothesis.grid = static_cast<VertexGrid>(take(kGrids));
  hypothesis.is_upside_down = take(2) == 1;
  hypothesis.left_out = static_cast<LeftOut>(std::min(rest, kLeftOuts - 1));
  return hypothesis;
}

std::string meaning_of(const CoverageHypothesis& hypothesis) {
  std::vector<std::string> parts;
  for (const std::string& part :
       {std::string(is_fault_of_grid(hypothesis.grid) ? meaning_in(kGridRows, hypothesis.grid)
                                                      : ""),
        std::string(meaning_in(kMoves, hypothesis.place)), meaning_of_ties(hypothesis.ties),
        std::string(meaning_in(kLeftOutRows, hypothesis.left_out)),
        std::string(hypothesis.is_upside_down ? "draws its pictures upside down" : "")})
    if (!part.empty()) parts.push_back(part);
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

std::string meaning_of(ColorHypothesis hypothesis) {
  switch (hypothesis) {
    case ColorHypothesis::red_and_blue_exchanged:
      return "exchanges red and blue";
    case ColorHypothesis::alpha_first:
      return "stores alpha before red, green and blue";
    case ColorHypothesis::at_most_254:
      return "stores 254 for 255";
    case ColorHypothesis::alpha_always_255:
      return "stores an alpha of 255 everywhere";
    case ColorHypothesis::alpha_always_0:
      return "stores an alpha of 0 everywhere";
    case ColorHypothesis::all_black:
      return "shows black for every colour";
    case ColorHypothesis::inverted:
      return "inverts its colours";
  }
  return "";
}

bool is_about_colors(std::uint16_t number) {
  return number >= static_cast<std::uint16_t>(ColorHypothesis::red_and_blue_exchanged);
}

bool is_about_ties_alone(std::uint16_t number) {
  if (is_about_colors(number)) return false;
  const CoverageHypothesis hypothesis = CoverageHypothesis::of(number);
  return hypothesis.ties != 0 && hypothesis.parts() == 1;
}

bool is_fault(std::uint16_t number) {
  if (is_about_colors(number)) return true;
  const CoverageHypothesis hypothesis = CoverageHypothesis::of(number);
  return is_fault_of_grid(hypothesis.grid) || is_fault_of_ties(hypothesis.ties) ||
         hypothesis.place != SampledPlace::centre || hypothesis.is_upside_down ||
         hypothesis.left_out != LeftOut::nothing;
}

std::string meaning_of_hypothesis(std::uint16_t number) {
  return is_about_colors(number) ? meaning_of(static_cast<ColorHypothesis>(number))
                                 : meaning_of(CoverageHypothesis::of(number));
}

}  // namespace edgecase
