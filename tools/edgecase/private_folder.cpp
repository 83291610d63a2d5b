// SPDX-License-Identifier: MIT
#include "tools/edgecase/private_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "processes/shader_cache.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

// Makes a folder unless it is there. Returns why it cannot be believed: others than this user may
// do what `shut_out` names, or it is theirs, or a link. Empty: it can.
std::string fault_of_folder(const fs::path& folder, mode_t shut_out) {
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
    return fmt::format(
        "cannot make the folder {}: {}; name another folder for caches in "
        "XDG_CACHE_HOME",
        folder.string(), std::generic_category().message(errno));
  struct stat status {};
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
    return fmt::format("{} is no folder; remove it", folder.string());
  if (status.st_uid != geteuid())
    return fmt::format(
        "the folder {} belongs to another user; remove it, or name another folder "
        "for caches in XDG_CACHE_HOME",
        folder.string());
  if ((status.st_mode & shut_out) != 0)
    return fmt::format("others than you may use the folder {}; shut them out: chmod go-rwx {}",
                       folder.string(), folder.string());
  return "";
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t wrote = write(file, text.data(), text.size());
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(wrote));
  }
  return true;
}

}  // namespace

std::variant<fs::path, std::string> private_folder(const std::string& name) {
  const auto caches = folder_for_caches();
  if (!caches)
    return std::string(
        "there is no folder for caches; name one in XDG_CACHE_HOME, by its absolute path");
  std::error_code error;
  fs::create_directories(*caches, error);
  // Mesa's folders are there, too: it lets others read them.
  const fs::path ours = *caches / "edgecase";
  if (std::string fault = fault_of_folder(ours, S_IWGRP | S_IWOTH); !fault.empty()) return fault;
  fs::path folder = ours / name;
  if (std::string fault = fault_of_folder(folder, S_IRWXG | S_IRWXO); !fault.empty()) return fault;
  return folder;
}

std::optional<std::string> read_private_file(const fs::path& path, std::size_t most) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (file.number() < 0 || fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode) ||
      status.st_uid != geteuid() || (status.st_mode & (S_IRWXG | S_IRWXO)) != 0 ||
      static_cast<std::uintmax_t>(status.st_size) > most)
    return std::nullopt;
  std::string text(static_cast<std::size_t>(status.st_size), '\0');
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t count = read(file.number(), text.data() + at, text.size() - at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    at += static_cast<std::size_t>(count);
  }
  return text;
}

bool write_private_file(const fs::path& path, const std::string& text, Existing existing) {
  std::string part = path.string() + ".XXXXXX";
  const Descriptor file(mkostemp(part.data(), O_CLOEXEC));  // of mode 0600
  if (file.number() < 0) return false;
  const bool wrote = write_all(file.number(), text) &&
                     (existing == Existing::replaced ? rename(part.c_str(), path.c_str())
                                                     : link(part.c_str(), path.c_str())) == 0;
  if (!wrote || existing == Existing::kept) unlink(part.c_str());
  return wrote;
}

}  // namespace edgecase
