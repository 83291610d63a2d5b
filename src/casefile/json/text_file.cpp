// SPDX-License-Identifier: MIT
#include "casefile/json/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

#include "casefile/json/text.h"

namespace edgecase {

TextFile read_text_file(const std::filesystem::path& file, std::size_t limit) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    return {{}, "there is no such file", "check the path's spelling"};
  if (!std::filesystem::is_regular_file(status))
    return {{}, "this is no regular file", "name a regular file"};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {{}, "the file cannot be opened", "check its permissions"};
  // Reading one byte more than allowed detects a file that is too large, even while it grows. Most
  // files are much smaller, and memory for the largest would cost more than reading them.
  std::string text;
  std::array<char, 1 << 14> chunk;
  while (stream && text.size() <= limit) {
    stream.read(chunk.data(),
                static_cast<std::streamsize>(std::min(chunk.size(), limit + 1 - text.size())));
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return {{}, "the file cannot be read", "check the disk and its permissions"};
  if (text.size() > limit)
    return {{}, fmt::format("larger than {} bytes", limit), "make the file smaller"};
  return {std::move(text), "", ""};
}

namespace {

namespace fs = std::filesystem;

fs::path suite_of(const fs::path& folder) {
  for (fs::path at = folder; at != at.root_path() && !at.empty(); at = at.parent_path())
    if (at.filename() == "cases") return at;
  return folder;
}

}  // namespace

std::optional<fs::path> find_in_suite(const fs::path& case_file, const Place& place,
                                      std::string_view kind, Findings& findings) {
  const fs::path relative(place.node->text);
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(case_file, error), error).parent_path();
  const fs::path root = suite_of(folder);
  const fs::path file = fs::weakly_canonical(folder / relative, error);
  const auto end = std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first;
  if (!error && !relative.empty() && relative.is_relative() && end == root.end()) return file;
  findings.add(place, fmt::format("{} leaves the folder of the cases", quote(place.node->text)),
               fmt::format("name {} of the suite, by its path from the case file", kind));
  return std::nullopt;
}

}  // namespace edgecase
