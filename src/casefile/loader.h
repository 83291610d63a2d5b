// SPDX-License-Identifier: MIT
//
// Loads a case file: JSON to Cases whose Scenes are complete, or all that is wrong with the file.
//
// A file stands for one case, or, with "sweep" and "variants", for several: all
// combinations of the sweep, and all images of each.
//
// Defaults: state is flat interpolation with the last vertex provoking; the target has one sample,
// format rgba8 and is a framebuffer object; the viewport is chosen so that OpenGL receives exact
// coordinates (casefile/scene/viewport.h); colours that the file leaves open are salted by the
// case's id, so that no two cases share their right answer (salted_clear and salted_primitive
// of casefile/scene/scene_reader.h).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/case.h"

namespace edgecase {

struct LoadedCases {
  std::vector<Case> cases;              // empty exactly when there are diagnostics
  std::vector<Diagnostic> diagnostics;  // all faults of the file, in the order of their lines
  std::vector<Diagnostic> notes;        // no faults: which numbers "~" numerals were taken as
};

// Reads and checks a file. `id` is the file's id (see casefile/suite.h), with which those of its
// cases begin. `known_rules`: ids that
// "rules" may name; empty: any. Never throws for what the file holds.
LoadedCases load_cases(const std::filesystem::path& file, const std::string& id,
                       std::span<const std::string> known_rules = {});

// The same for a text; `file` names it in messages, and its folder is where coverage files lie.
LoadedCases load_cases_text(const std::string& text, const std::filesystem::path& file,
                            const std::string& id, std::span<const std::string> known_rules = {});

}  // namespace edgecase
