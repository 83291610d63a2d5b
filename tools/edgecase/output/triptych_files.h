// SPDX-License-Identifier: MIT
//
// The folder of triptychs (reports/triptych.h): one PNG file per renderer and case that differs.
#pragma once

#include <filesystem>
#include <string>

#include "results/results.h"

namespace edgecase {

// The path of an id's triptych in its renderer's folder: the id with "@" for ":", and ".png".
// Characters that are not allowed, or would lead out of the folder, are replaced by "-", and a
// digest of the id is added, so that two ids never share a file.
std::filesystem::path triptych_path(const std::string& id);

// Writes triptychs into `folder` as RENDERER/CASE.png, and prints their number to standard error.
// If one cannot be written, prints an error, stops and returns false.
bool write_triptychs(const Results& results, const std::filesystem::path& folder);

}  // namespace edgecase
