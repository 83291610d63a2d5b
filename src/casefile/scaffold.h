// SPDX-License-Identifier: MIT
//
// Scaffolds of case files: from coordinates as people say them to a file that they then edit.
//
// Numerals stand in the file as they were given, "~0.99" too, since they tell where a number came
// from. Nothing is checked here but what would make no JSON: the loader is held against the text
// (casefile/loader.h), so that a faulty coordinate is told as in any other file.
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
  std::vector<std::vector<std::string>> vertices;  // numerals: x, y, and z, w where they are given
};

// Reads a primitive's name and its vertices, separated by spaces, the coordinates of each by
// commas. A sentence that says what is wrong otherwise.
std::variant<ScaffoldDraw, std::string> parse_scaffold_draw(std::string_view text);

struct Scaffold {
  CaseWords words;
  int width = 8;        // pixels
  int height = 8;       // pixels
  int samples = 1;      // per pixel
  std::string surface;  // empty: not said
  std::string depth;    // format of the depth buffer; empty: none
  std::vector<ScaffoldDraw> draws;
};

// The side of the smallest square target, a power of two of 8 pixels at least, that holds all
// vertices whose coordinates are numerals and not negative; 4096 where none does.
int least_target(const std::vector<ScaffoldDraw>& draws);

// The text of the file, laid out.
std::string scaffold_text(const Scaffold& scaffold);

// A case's text with an "expect" of one drawing, its rows given top row first; laid out. `text`
// must be that of a case without "expect".
std::string with_drawing(const std::string& text, const std::vector<std::string>& rows);

// A case's text without the colours of its target, draws and vertices, so that the loader chooses
// them (casefile/scene/scene_reader.h); laid out.
std::string without_colors(const std::string& text);

}  // namespace edgecase
