// SPDX-License-Identifier: MIT
//
// A gallery page: one policy, its choices, and pictures drawn under it beside OpenGL's.
//
// One static HTML file without a script that loads and sends nothing: its Content-Security-Policy
// allows only its own style. Pictures are SVG, which prints and stays sharp at any size. Every text
// is escaped. Reports know no rules and compare nothing: the caller supplies texts and pixels.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "model/figure.h"
#include "model/verdict.h"

namespace edgecase {

// Row by row from the bottom; both empty: there is no picture.
struct GalleryImage {
  std::vector<std::uint8_t> pixels;  // RGBA8; alpha is not shown
  std::vector<int> hits;             // how often a pixel is drawn; empty: not known
};

struct GalleryEntry {
  std::string case_id;
  std::string heading;
  std::string text;    // what to look at
  std::string origin;  // the case's own title
  // "rule=alternative" for each deviation of this picture from the policy.
  std::vector<std::string> otherwise;
  int width = 0;  // of all three, pixels
  int height = 0;
  Figure figure;  // outlines of the case's primitives
  GalleryImage policy;
  GalleryImage opengl;                 // exact, as the specification has it
  GalleryImage rendered;               // by the renderer
  Verdict verdict = Verdict::not_run;  // on what was rendered
  std::string failure;                 // why it was not
  // Rules which, set back to OpenGL's choice, make the picture OpenGL's (PolicyContrast).
  std::vector<std::string> alone;
  std::vector<std::string> together;
};

struct GalleryChoice {
  std::string rule;
  std::string title;   // of the rule
  std::string why;     // the gallery's words; may be empty
  std::string chosen;  // alternative, and what it means
  std::string meaning;
  std::string standard;  // OpenGL's, if it is another one
  std::string standard_meaning;
  std::string openness;   // of the choice under OpenGL: "open", "mandated", "illegal"
  std::string not_shown;  // why no picture shows it; may be empty
};

struct GalleryLink {
  std::string title;
  std::string file;  // beside this one; empty: this one
};

struct GalleryPage {
  std::string tool;
  std::string title;
  std::string about;
  std::string policy;    // name
  std::string renderer;  // "egl:llvmpipe (llvmpipe, LLVM 15)"
  std::vector<std::string> sources;
  std::vector<GalleryLink> links;  // to the galleries that are written together
  std::vector<GalleryChoice> choices;
  std::vector<GalleryEntry> entries;
};

// Pixels of two images that differ.
struct GalleryDifference {
  std::vector<bool> colored;   // in colour, by more than 1 of 255; a flag for each pixel
  std::vector<bool> slightly;  // in colour, by no more than that
  std::vector<bool> counted;   // only in the number of times they are drawn
  std::size_t colors = 0;      // set flags of the first two
  std::size_t counts = 0;      // set flags of the third
  int largest = 0;             // of a component's code, 0 to 255
};

// Images of one size; counts are compared where both have them.
GalleryDifference difference_of(const GalleryImage& a, const GalleryImage& b);

// One or two sentences: how the policy's picture differs from OpenGL's, and by which rules.
std::string describe_contrast(const GalleryEntry& entry);

// Writes the page in UTF-8; the same page gives the same bytes. The caller checks the stream's
// state afterwards.
void write_gallery(const GalleryPage& page, std::ostream& out);

}  // namespace edgecase
