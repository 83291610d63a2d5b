// SPDX-License-Identifier: MIT
//
// Folders into which one command at a time writes its reports, so that those in one folder are all
// of one run: a page and the scripts beside it, results and what was made of them.
//
// The lock is the kernel's, on the folder itself: no file is left behind, and it ends with the
// process. Where a file system knows no locks, and where another command keeps one for longer than
// a minute, files are written all the same: each is whole (output/whole_file.h).
#pragma once

#include <filesystem>
#include <set>
#include <vector>

namespace edgecase {

class FolderLock {
 public:
  // Makes the folders that are missing and waits for its turn, saying so on standard error.
  explicit FolderLock(const std::set<std::filesystem::path>& folders);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::vector<int> descriptors_;
};

}  // namespace edgecase
