// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/distinct_files.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <map>

#include "tools/edgecase/options.h"
#include "tools/edgecase/watched_files.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

// The same text for two paths of one file; empty for what is neither a file, nor a folder, nor
// missing.
std::string identity_of(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) == 0) {
    if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) return "";
    return fmt::format("{}:{}", status.st_dev, status.st_ino);
  }
  std::error_code error;
  const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
  return (real.has_filename() ? real : real.parent_path()).string();
}

}  // namespace

bool are_distinct(const std::vector<WrittenFile>& outputs, const std::vector<fs::path>& inputs) {
  std::map<std::string, const WrittenFile*> written;
  for (const WrittenFile& output : outputs) {
    if (output.path.empty() || output.path == "-") continue;
    const std::string identity = identity_of(output.path);
    if (identity.empty()) continue;
    const auto [twin, is_new] = written.emplace(identity, &output);
    if (is_new) continue;
    print_error(
        fmt::format("{} and {} are to write the same file, {}; name another for one of them",
                    twin->second->option, output.option, output.path));
    return false;
  }
  if (written.empty()) return true;
  for (const fs::path& input : json_files(inputs)) {
    const auto found = written.find(identity_of(input));
    if (found == written.end()) continue;
    print_error(fmt::format("{} would replace {}, which this command reads; name another file",
                            found->second->option, input.string()));
    return false;
  }
  return true;
}

}  // namespace edgecase
