// SPDX-License-Identifier: MIT
//
// Writes a scene as a case file that the loader reads back to exactly the same scene.
//
// The inverse of casefile/loader.h for one case, without sweeps, variants and drawn expectations,
// which are for authors to write. Defaults are omitted, except colours: the loader derives
// unspecified ones from the case's id, so the clear colour and every vertex's colour are written.
#pragma once

#include <string>
#include <vector>

#include "casefile/json/json_layout.h"
#include "model/case.h"

namespace edgecase {

// The texts beside the scene. Empty ones are omitted; `title` and `rules` are required.
struct CaseWords {
  std::string schema;  // relative path from the file to case.schema.json
  std::string title;
  std::string why;
  std::vector<std::string> rules;  // ids
  std::string spec;
  std::string origin;  // a link
  std::vector<std::string> tags;
  bool invariant = false;  // see Case
};

struct CaseText {
  std::string text;  // ends with a line break; empty exactly if there are diagnostics
  // What a case file cannot express or the loader refuses: more than 16 samples, several on a
  // window or with textures, uses of samples if the target has one, a test or clear value without
  // its buffer, factors of a blending that ignores them, a vertex outside the viewport or too fine
  // for it, clip coordinates outside the clip volume, a clear colour outside [0, 1], coloured
  // vertices of a textured draw, a mip chain that no file can describe, a texture with more texels
  // than a file may have, malformed texts. Lines and pointers refer to the text that would have
  // been written.
  std::vector<Diagnostic> diagnostics;
};

// Equal scenes and words give equal texts on every machine. Coordinates are exact: decimals up to
// four fraction bits ("10.5"), strings beyond ("10+3/256"); w and clip coordinates have all their
// digits. Results of transforms and meshes are written as they are. The text has been read back: a
// text that is returned means `scene`.
CaseText case_text(const Scene& scene, const CaseWords& words);

// The textual members of a case file: its name, its purpose, and its subject.

// Adds the member unless its text is empty.
void add_word(const char* name, const std::string& word, Pieces& members);

// The members of all texts that are not empty, in the order of case files.
Pieces word_pieces(const CaseWords& words);

}  // namespace edgecase
