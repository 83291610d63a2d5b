// SPDX-License-Identifier: MIT
#include "tools/edgecase/git_index.h"

#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "casefile/json/text.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kWorktree = "gitdir: ";

// What the folder's .git is, or names: that of a worktree or of a submodule is a file.
fs::path git_folder_of(const fs::path& folder) {
  fs::path git = folder / ".git";
  std::error_code error;
  if (fs::is_directory(git, error)) return git;
  if (!fs::is_regular_file(git, error)) return {};
  std::ifstream file(git);
  std::string line;
  if (!std::getline(file, line) || !line.starts_with(kWorktree)) return {};
  return folder / line.substr(kWorktree.size());
}

// Whether the index has an entry of this name. Every name ends with a zero byte. What precedes it
// is two bytes of flags, whose last one is the low byte of the name's length or, of an extended
// entry, of flags that are 0; so a longer path with this end is another one unless it is 256 bytes
// longer.
bool names(std::string_view index, const std::string& name) {
  const std::string entry = name + '\0';
  const char length = static_cast<char>(name.size() & 0xff);
  for (std::size_t at = index.find(entry); at != std::string_view::npos;
       at = index.find(entry, at + 1))
    if (at > 0 && (name.size() >= 0xfff || index[at - 1] == length || index[at - 1] == '\0'))
      return true;
  return false;
}

bool is_in_index(const fs::path& git, const std::string& name) {
  std::error_code error;
  const fs::path path = git / "index";
  if (!fs::exists(path, error)) return static_cast<bool>(error);
  constexpr std::size_t kMost = std::size_t{1} << 28;  // bytes: of some million files
  const TextFile file = read_text_file(path, kMost);
  if (!file.text) return true;
  const std::string& index = *file.text;
  constexpr std::string_view kHead("DIRC\0\0\0", 7);
  constexpr std::size_t kEntries = 12;
  if (index.size() < kEntries || !index.starts_with(kHead) || index[7] < 2 || index[7] > 3)
    return true;
  for (const auto& entry : fs::directory_iterator(git, error))
    if (entry.path().filename().string().starts_with("sharedindex.")) return true;
  return static_cast<bool>(error) || names(index, name);
}

}  // namespace

bool may_be_tracked(const fs::path& file) {
  std::error_code error;
  const fs::path path = fs::canonical(file, error);
  if (error) return true;
  for (fs::path folder = path.parent_path();; folder = folder.parent_path()) {
    if (fs::exists(folder / ".git", error) || error) {
      const fs::path git = git_folder_of(folder);
      return error || git.empty() || is_in_index(git, path.lexically_relative(folder).string());
    }
    if (folder == folder.parent_path()) return false;
  }
}

}  // namespace edgecase
