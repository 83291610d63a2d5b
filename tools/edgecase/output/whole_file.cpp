// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "tools/edgecase/file_safety.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

const char* remedy_of(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "make room there, or name a file elsewhere";
    case EROFS:
    case EACCES:
    case EPERM:
      return "name a file that may be written";
    case EISDIR:
      return "a folder has this name; name a file";
    default:
      return "name a file elsewhere";
  }
}

std::string fault_of(const fs::path& path, int error) {
  return fmt::format("cannot write {}: {}; {}", path.string(), std::strerror(error),
                     remedy_of(error));
}

// Returns 0, or the error.
int write_as_it_is(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  if (out) write(out);
  // Read at once, since later calls may change errno.
  const int error = out ? 0 : errno;
  out.close();
  if (out) return 0;
  return error != 0 ? error : errno != 0 ? errno : EIO;
}

// A new file beside another one, removed with this object unless it has replaced the other.
class Part {
 public:
  // Its name is short even if the other's is long.
  explicit Part(const fs::path& whole) {
    int descriptor = -1;
    for (int n = 0; descriptor < 0 && (n == 0 || errno == EEXIST); ++n) {
      path_ = whole.parent_path() / fmt::format(".edgecase-{}-{}.part", getpid(), n);
      descriptor = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    error_ = descriptor < 0 ? errno : 0;
    if (descriptor >= 0) close(descriptor);
  }
  ~Part() {
    if (error_ == 0) unlink(path_.c_str());
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  int error() const { return error_; }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  int error_ = 0;
};

int replace(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  const Part part(path);
  if (part.error() != 0) return part.error();
  struct stat before {};
  // What another user lets everybody do with a file of his does not hold for ours.
  if (stat(path.c_str(), &before) == 0 && before.st_uid == geteuid())
    chmod(part.path().c_str(), before.st_mode & 07777);
  if (const int error = write_as_it_is(part.path(), write)) return error;
  return std::rename(part.path().c_str(), path.c_str()) == 0 ? 0 : errno;
}

// True if the path is a file, or does not exist, and its folder allows another file beside it.
bool can_be_replaced(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return true;
  // A read-only file is left to write_as_it_is, which reports the error.
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  return fs::is_regular_file(status) && access(path.c_str(), W_OK) == 0 &&
         access(folder.c_str(), W_OK | X_OK) == 0;
}

}  // namespace

std::string fault_of_links(const fs::path& path) {
  const fs::path link = link_of_others(path);
  if (link.empty()) return "";
  return fmt::format("cannot write {}: the link {} belongs to another user; name where it leads",
                     path.string(), link.string());
}

std::string write_whole_file(const fs::path& path,
                             const std::function<void(std::ostream&)>& write) {
  if (std::string fault = fault_of_links(path); !fault.empty()) return fault;
  std::error_code error_code;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error_code);
  if (error_code && !fs::is_directory(path.parent_path()))
    return fault_of(path, error_code.value());
  fs::path file = fs::canonical(path, error_code);
  if (error_code) file = path;
  const int error = can_be_replaced(file) ? replace(file, write) : write_as_it_is(file, write);
  return error == 0 ? "" : fault_of(path, error);
}

}  // namespace edgecase
