// SPDX-License-Identifier: MIT
//
// The files that a run depends on, watched until somebody saves one: `edgecase run --watch`.
//
// Their times are read again and again, which works on every file system, network and container.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace edgecase {

// These files, and the files NAME.json below these folders.
std::vector<std::filesystem::path> json_files(const std::vector<std::filesystem::path>& paths);

// The words of the commands of exec: renderers that are files: programs, and scripts that they run.
// What those read beyond that is not known.
std::vector<std::filesystem::path> program_files(const std::vector<std::string>& renderers,
                                                 const std::map<std::string, std::string>& folders);

// When each file was last written; those that are not there are absent.
class WrittenTimes {
 public:
  explicit WrittenTimes(const std::vector<std::filesystem::path>& files);

  // Files that are new, gone, or written since `earlier`, in their order.
  std::vector<std::filesystem::path> since(const WrittenTimes& earlier) const;

 private:
  std::map<std::filesystem::path, std::filesystem::file_time_type> times_;
};

}  // namespace edgecase
