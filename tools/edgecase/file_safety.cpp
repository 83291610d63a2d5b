// SPDX-License-Identifier: MIT
#include "tools/edgecase/file_safety.h"

#include <fmt/format.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <deque>
#include <functional>
#include <string_view>

namespace edgecase {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel has it

// A file, folder or link on the way to a file.
struct Step {
  fs::path path;
  struct stat status {};
  fs::path folder;
  struct stat folder_status {};
  bool is_last = false;  // the file, or a link that stands for it
};

// Looks up a path as the kernel does (path_resolution(7)), and visits each existing step.
std::optional<fs::path> walk(const fs::path& path, const std::function<void(const Step&)>& visit) {
  std::error_code error;
  const fs::path whole = fs::current_path(error) / path;
  std::deque<fs::path> rest(whole.begin(), whole.end());
  fs::path at = "/";
  int links = 0;
  while (!rest.empty()) {
    const fs::path name = rest.front();
    rest.pop_front();
    if (name.is_absolute()) at = "/";
    if (name == "..") at = at.parent_path();
    if (name.empty() || name == "." || name == ".." || name.is_absolute()) continue;
    Step step{at / name, {}, at, {}, rest.empty()};
    stat(at.c_str(), &step.folder_status);
    if (lstat(step.path.c_str(), &step.status) == 0) visit(step);
    at = step.path;
    if (!S_ISLNK(step.status.st_mode)) continue;
    if (++links > kMostLinks) return std::nullopt;
    const fs::path target = fs::read_symlink(step.path, error);
    rest.insert(rest.begin(), target.begin(), target.end());
    at = step.folder;
  }
  return at;
}

std::string name_of_user(uid_t user) {
  const passwd* const entry = getpwuid(user);
  return entry == nullptr ? fmt::format("number {}", user) : entry->pw_name;
}

bool is_ours(uid_t user) {
  return user == geteuid() || user == 0;
}

// Whether the group of a file of this mode is its owner alone.
bool is_private_group(const fs::path& path, const struct stat& status) {
  // A list may let anybody write, of which the mode's bits of the group tell only that.
  if (lgetxattr(path.c_str(), "system.posix_acl_access", nullptr, 0) > 0) return false;
  const std::string owner = name_of_user(status.st_uid);
  const group* const entry = getgrgid(status.st_gid);
  if (entry == nullptr || owner != entry->gr_name) return false;
  for (char** member = entry->gr_mem; *member != nullptr; ++member)
    if (owner != *member) return false;
  return true;
}

bool may_others_write(const fs::path& path, const struct stat& status) {
  if ((status.st_mode & S_IWOTH) != 0) return true;
  return (status.st_mode & S_IWGRP) != 0 && !is_private_group(path, status);
}

std::string fault_of(const fs::path& path, const struct stat& status, bool may_be_sticky) {
  if (!is_ours(status.st_uid))
    return fmt::format("{} belongs to the user {}", path.string(), name_of_user(status.st_uid));
  const bool is_kept = may_be_sticky && (status.st_mode & S_ISVTX) != 0;
  if (S_ISLNK(status.st_mode) || is_kept || !may_others_write(path, status)) return "";
  return fmt::format("others may write {} {}",
                     S_ISDIR(status.st_mode) ? "into the folder" : "the file", path.string());
}

}  // namespace

std::string how_others_can_write(const fs::path& file) {
  std::string fault;
  const auto end = walk(file, [&](const Step& step) {
    if (fault.empty()) fault = fault_of(step.folder, step.folder_status, !step.is_last);
    if (fault.empty() && (step.is_last || S_ISLNK(step.status.st_mode)))
      fault = fault_of(step.path, step.status, false);
  });
  return end ? fault : fmt::format("links of {} lead in a circle", file.string());
}

fs::path link_of_others(const fs::path& file) {
  fs::path found;
  walk(file, [&](const Step& step) {
    if (found.empty() && S_ISLNK(step.status.st_mode) && !is_ours(step.status.st_uid))
      found = step.path;
  });
  return found;
}

std::optional<fs::path> without_links(const fs::path& path) {
  return walk(path, [](const Step&) {});
}

}  // namespace edgecase
