// SPDX-License-Identifier: MIT
//
// Whether git tracks a file, read from the index of its checkout (gitformat-index). The program git
// is not asked: the configuration of a foreign checkout can make it start others.
#pragma once

#include <filesystem>

namespace edgecase {

// True if the nearest checkout above the file tracks it, or if that cannot be told: its index
// cannot be read, or keeps names as differences (version 4, and split indices).
bool may_be_tracked(const std::filesystem::path& file);

}  // namespace edgecase
