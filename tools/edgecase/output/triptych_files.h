// SPDX-License-Identifier: MIT
//
// The folder of triptychs (reports/triptych.h): one PNG file per renderer and case that differs.
#pragma once

#include <filesystem>
#include <string>

#include "results/results.h"

namespace edgecase {

// Where the triptych of an id lies in its renderer's folder: the id with "@" for ":", and ".png".
// What no file can be called, or what would lead out of the folder, is replaced by "-" and a digest
// of the id, so that two ids never share a file.
std::filesystem::path triptych_path(const std::string& id);

// Writes them into `folder`, RENDERER/CASE.png, and says on standard error how many. False when one
// cannot be written: the error is printed, and no other is tried.
bool write_triptychs(const Results& results, const std::filesystem::path& folder);

}  // namespace edgecase
