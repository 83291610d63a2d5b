// SPDX-License-Identifier: MIT
#include "casefile/suite_path.h"

#include <fmt/format.h>

#include <algorithm>

#include "casefile/text.h"

namespace edgecase {
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
