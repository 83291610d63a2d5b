// SPDX-License-Identifier: MIT
//
// Loads a case file: JSON to a Case whose Scene is complete, or all that is wrong with the file.
//
// Defaults: state is flat interpolation with the last vertex provoking; the target has one sample,
// format rgba8 and is a framebuffer object; the viewport is chosen so that OpenGL receives exact
// coordinates (casefile/viewport.h); colours that the file leaves open are salted by the case's id,
// so that no two cases share their right answer (casefile/salted_colors.h).
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/case.h"

namespace edgecase {

struct LoadedCase {
  std::optional<Case> value;            // set exactly when there are no diagnostics
  std::vector<Diagnostic> diagnostics;  // all faults of the file, in the order of their lines
  std::vector<Diagnostic> notes;        // no faults: which numbers "~" numerals were taken as
};

// Reads and checks a file. `id` is the case's id (see casefile/suite.h). `known_rules`: ids that
// "rules" may name; empty: any. Never throws for what the file holds.
LoadedCase load_case(const std::filesystem::path& file, const std::string& id,
                     std::span<const std::string> known_rules = {});

// The same for a text; `file` names it in messages, and its folder is where coverage files lie.
LoadedCase load_case_text(const std::string& text, const std::filesystem::path& file,
                          const std::string& id, std::span<const std::string> known_rules = {});

}  // namespace edgecase
