// SPDX-License-Identifier: MIT
//
// Reads objects whose keys are rules: choices of alternatives, and explanations of rules.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "casefile/json/fields.h"
#include "model/case.h"
#include "model/policy.h"

namespace edgecase {

// Returns true if a member's key is the id of a rule, and of a known one unless `known` is empty;
// otherwise adds a finding.
bool check_rule_id(const Place& place, std::span<const KnownRule> known, Findings& findings);

// {"RULE": "ALTERNATIVE", ...}. `known`: all permitted rules with their alternatives; empty: not
// checked.
Choices read_choices(const Place& place, std::span<const KnownRule> known, Findings& findings);

// Loads a policy file: alternatives of rules, in general and per kind of surface.
//
//   {"name": "mine", "latitude": "none", "rules": {"triangle.fill-rule": "left-bottom"},
//    "surfaces": {"fbo": {"line.snap": "none"}}}
//
// `name` is required; latitude is "opengl" by default; "$schema" and "why" (a string for people)
// are allowed too. Faults are collected as for cases. The caller provides the known rules and
// alternatives.
using LoadedPolicy = Loaded<Policy>;

// `known`: all permitted rules with their alternatives; empty: not checked.
LoadedPolicy load_policy(const std::filesystem::path& file, std::span<const KnownRule> known);

LoadedPolicy load_policy_text(const std::string& text, const std::filesystem::path& file,
                              std::span<const KnownRule> known);

// The text of cases/policy.schema.json, by which editors help and check: the rules of `known` that
// have alternatives, each with their names.
std::string policy_schema(std::span<const KnownRule> known);

// Loads a gallery: the cases that present a policy, and the text beside their pictures.
//
//   {"title": "My course", "about": "A rasterizer of half planes.", "policy": "mine",
//    "sources": ["https://example.org/"],
//    "choices": {"triangle.fill-rule": "Half planes hold their border."},
//    "not_shown": {"line.snap": "No line of the course ends between pixels."},
//    "pictures": [{"case": "triangles/ties/flat-top", "heading": "Edges through centres",
//                  "text": "Both rows are drawn.", "rules": {"triangle.fill-rule": "open"}}]}
//
// `title`, `policy` and `pictures` are required, and so are `case` and `heading` of a picture;
// "$schema" is allowed. A picture's `rules` are its own deviations from the policy. Faults are
// collected as for cases. The caller provides the known rules; whether cases and policy exist is
// not checked.

using LoadedGallery = Loaded<Gallery>;

// `known`: all permitted rules with their alternatives; empty: not checked.
LoadedGallery load_gallery(const std::filesystem::path& file, std::span<const KnownRule> known);

LoadedGallery load_gallery_text(const std::string& text, const std::filesystem::path& file,
                                std::span<const KnownRule> known);

// The text of cases/gallery.schema.json: the JSON schema of gallery files.
std::string gallery_schema();

}  // namespace edgecase
