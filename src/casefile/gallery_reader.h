// SPDX-License-Identifier: MIT
//
// Loads a gallery: which cases show a policy, and the words beside their pictures.
//
//   {"title": "My course", "about": "A rasterizer of half planes.", "policy": "mine",
//    "sources": ["https://example.org/"],
//    "choices": {"triangle.fill-rule": "Half planes hold their border."},
//    "not_shown": {"line.snap": "No line of the course ends between pixels."},
//    "pictures": [{"case": "triangles/ties/flat-top", "heading": "Edges through centres",
//                  "text": "Both rows are drawn.", "rules": {"triangle.fill-rule": "open"}}]}
//
// `title`, `policy` and `pictures` are required, and of a picture `case` and `heading`; "$schema"
// is allowed. A picture's `rules` are what it alone has otherwise than the policy. Faults are
// collected as for cases. What rules exist is the caller's knowledge; whether there are such cases
// and such a policy is not looked at.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "casefile/policy_reader.h"
#include "model/gallery.h"

namespace edgecase {

struct LoadedGallery {
  std::optional<Gallery> value;  // set exactly when there are no diagnostics
  std::vector<Diagnostic> diagnostics;
};

// `known`: every rule that may be named, with its alternatives; empty: not checked.
LoadedGallery load_gallery(const std::filesystem::path& file, std::span<const KnownRule> known);

LoadedGallery load_gallery_text(const std::string& text, const std::filesystem::path& file,
                                std::span<const KnownRule> known);

// The text of cases/gallery.schema.json: the JSON schema of gallery files.
std::string gallery_schema();

}  // namespace edgecase
