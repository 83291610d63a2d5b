// SPDX-License-Identifier: MIT
//
// Locks on folders, so that only one command at a time writes its reports there and all files of a
// folder belong to one run: a page and the scripts beside it, results and their reports.
//
// The lock is the kernel's, on the folder itself: it leaves no file and ends with the process. If a
// file system has no locks, or another command holds one for more than a minute, files are written
// anyway; each of them is complete (output/whole_file.h).
#pragma once

#include <filesystem>
#include <set>
#include <vector>

namespace edgecase {

class FolderLock {
 public:
  // Creates missing folders and waits for the locks, with a message on standard error.
  explicit FolderLock(const std::set<std::filesystem::path>& folders);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::vector<int> descriptors_;
};

}  // namespace edgecase
