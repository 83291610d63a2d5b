// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <map>
#include <thread>
#include <utility>

#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kPatience{60};
constexpr std::chrono::milliseconds kNap{20};

void wait_for_turn(int descriptor, const fs::path& folder) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  bool is_told = false;
  while (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || errno == EINTR)) {
    if (std::chrono::steady_clock::now() >= deadline) {
      print_error(
          fmt::format("another command has been writing into {} for a minute; reports there may be "
                      "of both: name another folder",
                      folder.string()));
      return;
    }
    if (!is_told)
      print_error(fmt::format("another command writes into {}; waiting", folder.string()));
    is_told = true;
    std::this_thread::sleep_for(kNap);
  }
}

}  // namespace

FolderLock::FolderLock(const std::set<fs::path>& folders) {
  // Each folder once, whatever its names, in the same order for every command, so that two never
  // wait for each other.
  std::map<std::pair<dev_t, ino_t>, std::pair<int, fs::path>> opened;
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) continue;
    descriptors_.push_back(descriptor);
    struct stat told {};
    if (fstat(descriptor, &told) == 0)
      opened.try_emplace({told.st_dev, told.st_ino}, descriptor, folder);
  }
  for (const auto& [identity, entry] : opened) wait_for_turn(entry.first, entry.second);
}

FolderLock::~FolderLock() {
  for (const int descriptor : descriptors_) close(descriptor);
}

}  // namespace edgecase
