// SPDX-License-Identifier: MIT
//
// Scaffolds of case files: from coordinates, as people write them, to a file that they then edit.
//
// Numerals are written as given, including "~0.99", since they show where a number came from. Only
// what would not be JSON is checked here: the loader then reads the text (casefile/loader.h), so
// that a faulty coordinate is reported as in any other file.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "casefile/case_writer.h"

namespace edgecase {

// One draw: "lines 0.5,0.5 6,1+1/2".
struct ScaffoldDraw {
  std::string primitive;
  std::vector<std::vector<std::string>> vertices;  // numerals: x, y, and optionally z, w
};

// Parses a primitive's name and its vertices, separated by spaces, with commas between coordinates.
// On failure, a sentence with the fault.
std::variant<ScaffoldDraw, std::string> parse_scaffold_draw(std::string_view text);

struct Scaffold {
  CaseWords words;
  int width = 8;        // pixels
  int height = 8;       // pixels
  int samples = 1;      // per pixel
  std::string surface;  // empty: not given
  std::string depth;    // of the depth buffer; empty: none
  std::vector<ScaffoldDraw> draws;
};

// The side of the smallest square target, a power of two and at least 8 pixels, with all vertices
// whose coordinates are nonnegative numerals; 4096 if none is large enough.
int least_target(const std::vector<ScaffoldDraw>& draws);

// The text of the file, laid out.
std::string scaffold_text(const Scaffold& scaffold);

// The text of a case with an "expect" of one drawing, laid out; rows are given top row first.
// `text` must be that of a case without "expect".
std::string with_drawing(const std::string& text, const std::vector<std::string>& rows);

// The text of a case without the colours of its target, draws and vertices, laid out, so that the
// loader chooses them (casefile/scene/scene_reader.h).
std::string without_colors(const std::string& text);

}  // namespace edgecase
