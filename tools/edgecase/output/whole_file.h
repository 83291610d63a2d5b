// SPDX-License-Identifier: MIT
//
// Files that are whole at any time: what is written goes into a file beside the one that is meant,
// and takes its name when it is finished. Who reads meanwhile, or after the command was killed or
// the disk was full, finds what was there before; of two commands that write one file, one wins.
//
// Devices and pipes are written to as they are, and so are files in folders that take no new ones.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace edgecase {

// Writes a file, its folder made if need be, through symbolic links and with the permissions that
// it had. Why it cannot be written, and what to do; empty when it is written.
std::string write_whole_file(const std::filesystem::path& path,
                             const std::function<void(std::ostream&)>& write);

}  // namespace edgecase
