// SPDX-License-Identifier: MIT
//
// Files that are complete at any time: a file is written under another name beside the intended
// one, and renamed when it is finished.
//
// A reader meanwhile, or after a crash or with a full disk, finds the earlier file; of two commands
// that write one file, one wins. Devices, pipes, and files in folders that allow no new files are
// written directly.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace edgecase {

// Writes a file through symbolic links of this user and the superuser, keeps its permissions, and
// creates its folder if necessary. Returns the reason for failing and the remedy; empty on success.
std::string write_whole_file(const std::filesystem::path& path,
                             const std::function<void(std::ostream&)>& write);

// Why a file is not written because of a link on the way to it; empty: it may be.
std::string fault_of_links(const std::filesystem::path& path);

}  // namespace edgecase
