// SPDX-License-Identifier: MIT
//
// Probes of a renderer: small scenes that measure its capabilities, whatever it claims.
//
// Sub-pixel bits are measured with a nearly horizontal edge across a row of pixels 256 wide. One
// end is fixed 1/16 pixel below the row's centres; the other climbs from the centre line to 1/16
// above it in steps of 2^-12. If a renderer snaps vertices to a grid of 2^-b, the end jumps 2^(b-4)
// times on the way, however it rounds, and each jump moves the column where the edge passes the
// centres. So the number of different renderings gives b.
#pragma once

#include <chrono>
#include <string>

#include "model/renderer.h"

namespace edgecase {

// Widths of lines and sizes of points are measured at powers of two, up to the largest that scenes
// may ask for.
constexpr int kMostThickness = 64;

struct ProbeResult {
  std::string problem;                       // why the renderer is unavailable; empty: it answers
  std::chrono::milliseconds first_answer{};  // from the start to the first rendering
  std::size_t points = 0;                    // fragments of the probe that draws one point
  std::size_t lines = 0;
  std::size_t triangles = 0;
  bool smooth = false;           // colours are interpolated
  bool fragment_colors = false;  // fragments come with colours and depth
  bool hits_agree = false;       // hit counts are reported, and equal the captured fragments
  bool window = false;           // draws to window surfaces, too
  int line_width = 0;            // widest line that was drawn so, pixels; 0: none
  int point_size = 0;            // largest point, likewise
  int subpixel_bits = 0;         // measured; 0: the probe failed
  bool more_bits = false;        // there may be more than the probe resolves
};

// Draws the probes. For `first_answer` the renderer must not have been used before.
ProbeResult probe(Renderer& renderer);

}  // namespace edgecase
