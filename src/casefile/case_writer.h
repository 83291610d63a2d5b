// SPDX-License-Identifier: MIT
//
// Writes a scene as a case file that the loader reads back to the very same scene.
//
// The inverse of casefile/loader.h for one case: no sweep, no variants, no drawn expectation, since
// those are an author's. Defaults are left out, except colours: the loader salts those that a file
// leaves open by the case's id, so the clear colour and every vertex's colour are written.
#pragma once

#include <string>
#include <vector>

#include "casefile/json/json_layout.h"
#include "model/case.h"

namespace edgecase {

// The words round the scene. Empty ones are left out; `title` and `rules` are required.
struct CaseWords {
  std::string schema;  // relative path from the file to case.schema.json
  std::string title;
  std::string why;
  std::vector<std::string> rules;  // ids
  std::string spec;
  std::string origin;  // a link
  std::vector<std::string> tags;
};

struct CaseText {
  std::string text;  // ends with a line break; empty exactly when there are diagnostics
  // What a case file cannot say, or the loader refuses: more than 16 samples, several on a window
  // or with textures, a use of samples where the target has one, a test or a clear value without
  // its buffer, factors of a blending that takes none, a vertex outside the viewport or
  // too fine for it, clip coordinates outside the clip volume, a clear colour outside [0, 1],
  // colours of a textured draw's vertices that are not white, a mip chain that no file describes, a
  // texture with more texels than a file may hold, words against the format. Lines and pointers are
  // those of the text that would have been.
  std::vector<Diagnostic> diagnostics;
};

// The same scene and words give the same text, on every machine. Coordinates are exact: decimals up
// to four fraction bits ("10.5"), strings beyond ("10+3/256"); w and clip coordinates with all of
// their digits. What a transform or a mesh made is written as it came out. The text has been read
// back: a text that is returned means `scene`.
CaseText case_text(const Scene& scene, const CaseWords& words);

// The members of a case file that are words, as they are written: what it is called, why it is
// there, and what it is about.

// Adds the member, unless the word is empty.
void add_word(const char* name, const std::string& word, Pieces& members);

// Those of all words that there are, in the order of case files.
Pieces word_pieces(const CaseWords& words);

}  // namespace edgecase
