// SPDX-License-Identifier: MIT
//
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
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "casefile/policy_reader.h"
#include "model/policy.h"

namespace edgecase {

using LoadedGallery = Loaded<Gallery>;

// `known`: all permitted rules with their alternatives; empty: not checked.
LoadedGallery load_gallery(const std::filesystem::path& file, std::span<const KnownRule> known);

LoadedGallery load_gallery_text(const std::string& text, const std::filesystem::path& file,
                                std::span<const KnownRule> known);

// The text of cases/gallery.schema.json: the JSON schema of gallery files.
std::string gallery_schema();

}  // namespace edgecase
