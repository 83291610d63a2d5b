// SPDX-License-Identifier: MIT
#include "tools/edgecase/watched_files.h"

#include <system_error>
#include <variant>

#include "run/renderers.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

void add_below(const fs::path& folder, std::vector<fs::path>& files) {
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error))
    if (at->path().extension() == ".json") files.push_back(at->path());
}

}  // namespace

std::vector<fs::path> json_files(const std::vector<fs::path>& paths) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::path& path : paths)
    if (fs::is_directory(path, error))
      add_below(path, files);
    else
      files.push_back(path);
  return files;
}

std::vector<fs::path> program_files(const std::vector<std::string>& renderers,
                                    const std::map<std::string, std::string>& folders) {
  std::vector<fs::path> files;
  for (const std::string& renderer : renderers) {
    const auto folder = folders.find(renderer);
    const auto found =
        find_renderer(renderer, worker_directory(), folder == folders.end() ? "" : folder->second);
    const auto* spec = std::get_if<ProcessSpec>(&found);
    if (spec == nullptr || !split_name(renderer).address.starts_with("exec:")) continue;
    std::error_code error;
    for (const std::string& word : spec->command.argv)
      if (const fs::path path = fs::path(spec->command.folder) / word;
          fs::is_regular_file(path, error))
        files.push_back(path);
  }
  return files;
}

WrittenTimes::WrittenTimes(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    if (!error) times_.emplace(file, time);
  }
}

std::vector<fs::path> WrittenTimes::since(const WrittenTimes& earlier) const {
  std::vector<fs::path> changed;
  for (const auto& [file, time] : times_)
    if (const auto before = earlier.times_.find(file);
        before == earlier.times_.end() || before->second != time)
      changed.push_back(file);
  for (const auto& [file, time] : earlier.times_)
    if (!times_.contains(file)) changed.push_back(file);
  return changed;
}

}  // namespace edgecase
