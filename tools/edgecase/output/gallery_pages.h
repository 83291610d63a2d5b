// SPDX-License-Identifier: MIT
//
// Makes a gallery's page: loads its cases and draws them, under the policy, exactly and by a
// renderer.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/case.h"
#include "model/policy.h"
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

// Reads all files; `suite` has the cases and policies. Prints an error and returns nothing if one
// is faulty.
std::optional<LoadedPictures> load_pictures(const std::filesystem::path& file,
                                            const std::filesystem::path& suite);

// `results`: of one renderer under policy `opengl`, for all cases of the gallery. The caller adds
// links.
GalleryPage gallery_page(const LoadedPictures& loaded, const Results& results);

}  // namespace edgecase
