// SPDX-License-Identifier: MIT
#include "casefile/loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <system_error>

#include "casefile/json/text.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

bool is_case_file(const fs::path& file) {
  return file.extension() == ".json" && file.stem().extension() != ".schema";
}

bool is_skipped(const fs::path& folder) {
  const std::string name = folder.filename().string();
  for (const char* other : {"known", "policies", "profiles", "galleries"})
    if (name == other) return true;
  return name.starts_with('.');
}

// `folder` or the nearest folder above it that is named "cases"; otherwise `folder`.
fs::path root_of(const fs::path& folder) {
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path())
    if (at.filename() == "cases") return at;
  return folder;
}

fs::path normal(const fs::path& path) {
  std::error_code error;
  fs::path result = fs::absolute(path, error).lexically_normal();
  // Both "folder/" and "folder/." end in an empty name.
  if (!result.has_filename()) result = result.parent_path();
  return result;
}

bool lies_in(const fs::path& folder, const fs::path& file) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

class Finder {
 public:
  void add_path(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
      add_folder(path, root_of(normal(path)));
    } else if (fs::exists(path, error)) {
      add_file(path, root_of(normal(path).parent_path()));
    } else {
      diagnose(path, "there is no such file or folder", "check the path's spelling");
    }
  }

  FoundCases take();

 private:
  void add_folder(const fs::path& folder, const fs::path& root);
  void add_file(const fs::path& file, const fs::path& root);
  void diagnose(const fs::path& path, std::string message, std::string remedy) {
    found_.diagnostics.push_back(
        {path.generic_string(), 0, "", std::move(message), std::move(remedy)});
  }

  FoundCases found_;
  std::set<std::string> seen_;
};

void Finder::add_folder(const fs::path& folder, const fs::path& root) {
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  const fs::recursive_directory_iterator end;
  while (!error && entry != end) {
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      if (is_skipped(entry->path())) entry.disable_recursion_pending();
    } else if (is_case_file(entry->path())) {
      add_file(entry->path(), root);
    }
    entry.increment(error);
  }
  if (error)
    diagnose(folder, "the folder cannot be read: " + error.message(), "check its permissions");
}

void Finder::add_file(const fs::path& file, const fs::path& root) {
  const fs::path absolute = normal(file);
  if (!seen_.insert(absolute.string()).second) return;
  if (leads_out_of_suite(file)) return diagnose(file, kLeadsOut, kLeadsOutRemedy);
  const std::string id = absolute.lexically_relative(root).replace_extension().generic_string();
  if (find_invalid_utf8(id)) {
    diagnose(clean_line(file.generic_string()), "the file's name is not UTF-8", "rename the file");
    return;
  }
  if (id.find(':') != std::string::npos) {
    diagnose(file, "the file's name holds ':', which in ids starts an axis of a sweep",
             "rename the file");
    return;
  }
  found_.cases.push_back({file.string(), id});
}

FoundCases Finder::take() {
  auto& cases = found_.cases;
  std::stable_sort(cases.begin(), cases.end(),
                   [](const CaseFile& a, const CaseFile& b) { return a.id < b.id; });
  const auto twin = [](const CaseFile& a, const CaseFile& b) { return a.id == b.id; };
  for (auto at = std::adjacent_find(cases.begin(), cases.end(), twin); at != cases.end();
       at = std::adjacent_find(at, cases.end(), twin)) {
    const auto other = std::next(at);
    diagnose(other->file,
             fmt::format("its id {} is also that of {}", quote(other->id),
                         fs::path(at->file).generic_string()),
             "give a folder that holds both, or run them one after the other");
    cases.erase(other);
  }
  return std::move(found_);
}

}  // namespace

bool leads_out_of_suite(const fs::path& file) {
  std::error_code error;
  const fs::path named = normal(file);
  const fs::path root = root_of(named.parent_path());
  const fs::path real = fs::canonical(named, error);
  if (error || lies_in(fs::weakly_canonical(root, error), real)) return false;
  // The same file of another checkout.
  const std::string tail = "/" + (root.filename() / named.lexically_relative(root)).string();
  return root.filename() != "cases" || !real.string().ends_with(tail);
}

FoundCases find_cases(std::span<const fs::path> paths) {
  Finder finder;
  for (const fs::path& path : paths) finder.add_path(path);
  return finder.take();
}

}  // namespace edgecase
