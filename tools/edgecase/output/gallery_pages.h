// SPDX-License-Identifier: MIT
//
// From a gallery to its page: cases loaded and drawn, under the policy, exactly and by a renderer.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/case.h"
#include "model/gallery.h"
#include "reports/gallery.h"
#include "results/results.h"

namespace edgecase {

// A gallery's file, its policy and the cases of its pictures, each once.
struct LoadedPictures {
  std::string name;  // of the file, without suffix
  Gallery gallery;
  Policy policy;
  std::vector<Case> cases;  // sorted by id
};

// Reads it all; `suite` holds cases and policies. Prints what is wrong and returns nothing.
std::optional<LoadedPictures> load_pictures(const std::filesystem::path& file,
                                            const std::filesystem::path& suite);

// `results`: of one renderer under policy `opengl`, of all the gallery's cases. Links are left to
// the caller.
GalleryPage gallery_page(const LoadedPictures& loaded, const Results& results);

}  // namespace edgecase
