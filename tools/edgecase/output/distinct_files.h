// SPDX-License-Identifier: MIT
//
// What a command is to write must be neither what it reads nor what it writes elsewhere: nobody
// means that, and a case file that a report replaced is gone.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace edgecase {

struct WrittenFile {
  std::string option;  // by which it is named: "--json"
  std::string path;    // empty or "-": no file
};

// True if all files are distinct, through links and whether they exist or not. Otherwise prints an
// error that names both. Inputs: files, and folders with all of their JSON files. What is no
// regular file is as good for two as for one: /dev/null.
bool are_distinct(const std::vector<WrittenFile>& outputs,
                  const std::vector<std::filesystem::path>& inputs);

}  // namespace edgecase
