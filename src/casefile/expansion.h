// SPDX-License-Identifier: MIT
//
// From one file to its cases: every combination of its sweep, and every image of each.
//
// Each combination is put into the tree of the file and read by the ordinary reader, so that an
// expanded case gets every check that a written one gets; images are made of what was read.
//
// Ids: PATH for a file without sweep and variants. Otherwise PATH, then ":AXIS=VALUE" for every
// axis in the order of the file, then ":reverse", ":winding", ":octant=1" to ":octant=7" or
// ":translate=3,2" for an image. Colours that the file leaves open are salted by that id.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "casefile/fields.h"
#include "model/case.h"

namespace edgecase {

// A file's cases times its bytes: what a hostile sweep may cost.
constexpr std::size_t kMaxExpandedBytes = std::size_t{64} << 20;

struct CaseOrigin {
  std::filesystem::path file;
  std::string id;  // of the file: path without suffix
  std::string_view text;
  std::span<const std::string> known_rules;
};

// All cases of a file: combinations in the order of the sweep, the last axis running fastest, each
// followed by its images. A fault that not every combination has names the axes' values; the same
// fault of several is told once. Incomplete when there are findings.
std::vector<Case> expand_cases(const JsonNode& root, const CaseOrigin& origin, Findings& findings);

}  // namespace edgecase
