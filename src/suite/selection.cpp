// SPDX-License-Identifier: MIT
#include "suite/selection.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "casefile/json/text.h"
#include "casefile/loader.h"
#include "model/text.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSuffix = ".json";

bool matches(const std::string& glob, const std::string& text) {
  return fnmatch(glob.c_str(), text.c_str(), 0) == 0;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

// A word before and behind its first colon.
struct Word {
  std::string whole;
  std::string name;
  std::string parts;
  bool has_parts = false;

  explicit Word(const std::string& text) : whole(text), name(text.substr(0, text.find(':'))) {
    has_parts = name.size() < text.size();
    if (has_parts) parts = text.substr(name.size() + 1);
  }
};

class WordFinder {
 public:
  explicit WordFinder(const fs::path& suite) : suite_(suite.lexically_normal()) {
    if (!suite_.has_filename()) suite_ = suite_.parent_path();  // "cases/"
  }

  void add(const std::string& text) {
    if (exists(text)) {
      add_path(text);
      return;
    }
    const Word word(text);
    if (add_file(word) || add_ids(word)) return;
    diagnose(word);
  }

  FoundWords take();

 private:
  void add_path(const fs::path& path) {
    found_.paths.push_back(path);
    whole_.push_back(path.lexically_normal());
  }
  void add_cases(const fs::path& path, const Word& word) {
    const fs::path file = path.lexically_normal();
    if (!word.has_parts) {
      add_path(file);
      return;
    }
    found_.paths.push_back(file);
    found_.parts[file].push_back({word.parts, clean_line(word.whole)});
  }
  bool add_file(const Word& word);
  bool add_ids(const Word& word);
  void diagnose(const Word& word);
  const std::vector<CaseFile>& files();
  // The word's name as an id: without the suite's folder in front and the suffix behind.
  std::string id_of(const Word& word) const;
  bool is_path(const Word& word) const;
  std::string nearest_to(const Word& word);

  fs::path suite_;
  std::optional<std::vector<CaseFile>> files_;  // of the suite, once they are looked for
  std::vector<fs::path> whole_;                 // of which all cases are meant
  FoundWords found_;
};

// "a.json:dx=1", or a path without its suffix.
bool WordFinder::add_file(const Word& word) {
  for (const std::string& path : {word.name, word.name + std::string(kSuffix)}) {
    if (path.empty() || !exists(path) || is_folder(path)) continue;
    add_cases(path, word);
    return true;
  }
  return false;
}

bool WordFinder::add_ids(const Word& word) {
  const std::string id = id_of(word);
  if (id.empty()) return false;
  const fs::path folder = suite_ / id;
  if (!word.has_parts && fs::path(id).is_relative() && is_folder(folder)) {
    add_path(folder);
    return true;
  }
  bool any = false;
  for (const CaseFile& one : files()) {
    if (!matches(id, one.id)) continue;
    add_cases(one.file, word);
    any = true;
  }
  return any;
}

const std::vector<CaseFile>& WordFinder::files() {
  if (!files_) files_ = find_cases(std::array{suite_}).cases;
  return *files_;
}

std::string WordFinder::id_of(const Word& word) const {
  std::string id = word.name;
  const std::string folder = suite_.generic_string() + "/";
  if (id.starts_with(folder)) id.erase(0, folder.size());
  if (id.ends_with(kSuffix)) id.erase(id.size() - kSuffix.size());
  while (id.ends_with('/')) id.pop_back();
  return id;
}

// True if the word is a path and not an id.
bool WordFinder::is_path(const Word& word) const {
  return word.name.ends_with(kSuffix) || word.name.starts_with('.') || word.name.starts_with('/') ||
         word.name.starts_with(suite_.generic_string() + "/");
}

// The id that was probably meant: one with the same last name, or with nearly the same letters.
std::string WordFinder::nearest_to(const Word& word) {
  const std::string id = id_of(word);
  std::set<std::string> folders;
  for (const CaseFile& one : files()) {
    if (!id.empty() && one.id.ends_with("/" + id)) return one.id;
    for (auto end = one.id.find('/'); end != std::string::npos; end = one.id.find('/', end + 1))
      folders.insert(one.id.substr(0, end));
  }
  for (const std::string& folder : folders)
    if (!id.empty() && folder.ends_with("/" + id)) return folder;
  std::vector<std::string> ids(folders.begin(), folders.end());
  for (const CaseFile& one : files()) ids.push_back(one.id);
  return nearest_name(id, ids);
}

void WordFinder::diagnose(const Word& word) {
  const std::string nearest = nearest_to(word);
  const bool path = is_path(word);
  std::string remedy =
      path ? "check the path's spelling" : "`edgecase run --list` prints the ids of all cases";
  if (!nearest.empty()) {
    const fs::path named = suite_ / nearest;
    const std::string suffix = is_folder(named) ? "" : std::string(kSuffix);
    remedy = fmt::format("did you mean {}?", path ? named.generic_string() + suffix : nearest);
  }
  found_.diagnostics.push_back(
      {clean_line(word.whole), 0, "",
       path ? "there is no such file or folder" : "there is no such file, folder or case",
       std::move(remedy)});
}

FoundWords WordFinder::take() {
  // Files that are also named as a whole, or lie in a named folder, have no parts.
  std::erase_if(found_.parts, [&](const auto& entry) {
    const fs::path file = entry.first.lexically_normal();
    return std::ranges::any_of(whole_, [&](const fs::path& whole) {
      const auto end = std::mismatch(whole.begin(), whole.end(), file.begin(), file.end()).first;
      return end == whole.end() || (end != whole.end() && end->empty());
    });
  });
  return std::move(found_);
}

}  // namespace

FoundWords find_words(std::span<const std::string> words, const fs::path& suite) {
  WordFinder finder(suite);
  for (const std::string& word : words) finder.add(word);
  return finder.take();
}

bool matches_parts(const std::string& pattern, const std::vector<std::string>& parts) {
  for (std::size_t at = 0; at <= pattern.size();) {
    const std::size_t end = std::min(pattern.find(':', at), pattern.size());
    const std::string part = pattern.substr(at, end - at);
    if (std::ranges::none_of(parts, [&](const std::string& own) { return matches(part, own); }))
      return false;
    at = end + 1;
  }
  return true;
}

Selection selection_of(std::span<const std::string> words, const std::filesystem::path& suite) {
  FoundWords found = find_words(words, suite);
  Selection selection;
  selection.paths = std::move(found.paths);
  selection.parts = std::move(found.parts);
  selection.diagnostics = std::move(found.diagnostics);
  return selection;
}

}  // namespace edgecase
