// SPDX-License-Identifier: MIT
#include "run/selection.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "casefile/json/text.h"
#include "casefile/loader.h"
#include "model/text.h"
#include "model/threads.h"
#include "rules/all_rules.h"

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

bool matches_parts(const std::string& pattern, const Case& one) {
  for (std::size_t at = 0; at <= pattern.size();) {
    const std::size_t end = std::min(pattern.find(':', at), pattern.size());
    const std::string part = pattern.substr(at, end - at);
    if (std::ranges::none_of(one.parts, [&](const std::string& own) { return matches(part, own); }))
      return false;
    at = end + 1;
  }
  return true;
}

namespace {

bool matches_any(const std::vector<std::string>& globs, const std::string& id) {
  return std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) {
    return fnmatch(glob.c_str(), id.c_str(), 0) == 0;
  });
}

// A glob that matches a file's id means all its cases.
bool wanted_id(const Selection& selection, const std::string& file_id, const std::string& id) {
  const auto named_by = [&](const std::vector<std::string>& globs) {
    return matches_any(globs, file_id) || matches_any(globs, id);
  };
  if (!selection.filters.empty() && !named_by(selection.filters)) return false;
  return !named_by(selection.excludes);
}

// True if a glob can match an id that starts with `start`: some part of it matches the start.
bool may_match(const std::string& glob, const std::string& start) {
  for (std::size_t length = 1; length <= glob.size(); ++length)
    if (fnmatch(glob.substr(0, length).c_str(), start.c_str(), 0) == 0) return true;
  return false;
}

// True if the file or one of its cases is named.
bool may_be_named(const Selection& selection, const CaseFile& file) {
  if (!selection.only || selection.only->files.contains(file.file)) return true;
  const std::set<std::string>& ids = selection.only->ids;
  const auto swept = ids.lower_bound(file.id + ":");
  return ids.contains(file.id) || (swept != ids.end() && swept->starts_with(file.id + ":"));
}

bool is_named(const Selection& selection, const Case& one) {
  return !selection.only || selection.only->files.contains(one.file.generic_string()) ||
         selection.only->ids.contains(one.id);
}

// True if the selection may contain one of the file's cases.
bool may_be_wanted(const Selection& selection, const std::string& file_id) {
  if (matches_any(selection.excludes, file_id)) return false;
  return selection.filters.empty() || matches_any(selection.filters, file_id) ||
         std::any_of(selection.filters.begin(), selection.filters.end(),
                     [&](const std::string& glob) { return may_match(glob, file_id + ":"); });
}

void append(std::vector<Diagnostic>& from, std::vector<Diagnostic>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

bool wanted_tags(const Selection& selection, const Case& one) {
  return selection.tags.empty() ||
         std::any_of(one.tags.begin(), one.tags.end(), [&](const std::string& tag) {
           return std::find(selection.tags.begin(), selection.tags.end(), tag) !=
                  selection.tags.end();
         });
}

// Drops the cases of a file that are not meant, if only some are.
class PartsKeeper {
 public:
  void keep(const CaseFile& file, const PartPatterns& patterns, std::vector<Case>& cases) {
    std::set<std::string> kept;
    for (const PartPattern& pattern : patterns) {
      Word& word = words_[pattern.word];
      word.file = file.file;
      word.cases += cases.size();
      const std::string whole = file.id + ":" + pattern.parts;
      const bool is_id =
          std::ranges::any_of(cases, [&](const Case& one) { return one.id == whole; });
      for (const Case& one : cases) {
        if (is_id ? one.id != whole : !matches_parts(pattern.parts, one)) continue;
        kept.insert(one.id);
        word.matches = true;
      }
    }
    std::erase_if(cases, [&](const Case& one) { return !kept.contains(one.id); });
  }

  // The words that no case matches.
  void tell(std::vector<Diagnostic>& diagnostics) const {
    for (const auto& [text, word] : words_)
      if (!word.matches)
        diagnostics.push_back({text, 0, "", "there is no such case",
                               fmt::format("`edgecase run {} --list` prints the ids of {} that "
                                           "there are",
                                           word.file, word.cases)});
  }

 private:
  struct Word {
    std::string file;  // the last that it names
    std::size_t cases = 0;
    bool matches = false;
  };
  std::map<std::string, Word> words_;
};

std::vector<std::string> known_rule_ids() {
  std::vector<std::string> ids;
  for (const Rule& rule : all_rules()) ids.push_back(name_of(rule.id));
  return ids;
}

// Of the ids of all selected cases and of their files, by the files' ids.
std::string digest_of(const CaseStore& cases, const std::map<std::string, SharedText>& files) {
  Digest digest;
  for (std::size_t i = 0; i < cases.size(); ++i) digest.add(cases.id(i));
  for (const auto& [id, text] : files) digest.add(id).add(*text);
  return digest.text();
}

}  // namespace

Selection selection_of(std::span<const std::string> words, const std::filesystem::path& suite) {
  FoundWords found = find_words(words, suite);
  Selection selection;
  selection.paths = std::move(found.paths);
  selection.parts = std::move(found.parts);
  selection.diagnostics = std::move(found.diagnostics);
  return selection;
}

Suite load_suite(const Selection& selection) {
  const std::vector<std::string> rules = known_rule_ids();
  FoundCases found = find_cases(selection.paths);
  Suite suite;
  suite.diagnostics = selection.diagnostics;
  append(found.diagnostics, suite.diagnostics);
  PartsKeeper keeper;
  std::map<std::string, SharedText> files;  // with a selected case
  std::erase_if(found.cases, [&](const CaseFile& file) {
    return !may_be_wanted(selection, file.id) || !may_be_named(selection, file);
  });
  const auto load = [&](std::size_t i) {
    return load_cases(found.cases[i].file, found.cases[i].id, rules);
  };
  make_in_order(found.cases.size(), load, [&](std::size_t i, LoadedCases loaded) {
    const CaseFile& file = found.cases[i];
    append(loaded.diagnostics, suite.diagnostics);
    append(loaded.notes, suite.notes);
    if (const auto parts = selection.parts.find(file.file);
        parts != selection.parts.end() && !loaded.cases.empty())
      keeper.keep(file, parts->second, loaded.cases);
    for (Case& one : loaded.cases)
      if (wanted_id(selection, file.id, one.id) && wanted_tags(selection, one) &&
          is_named(selection, one)) {
        if (selection.shard.count > 1) files.try_emplace(file.id, one.source);
        suite.cases.push_back(std::move(one));
      }
  });
  const std::size_t in_files = suite.diagnostics.size() - selection.diagnostics.size();
  keeper.tell(suite.diagnostics);
  suite.is_misspelt = suite.cases.empty() && in_files == 0 && !suite.diagnostics.empty();
  suite.cases.sort_by_id();
  suite.cases.keep_sample(static_cast<std::size_t>(selection.sample.index),
                          static_cast<std::size_t>(selection.sample.count));
  if (selection.shard.count > 1)
    suite.share = {selection.shard.index, selection.shard.count, suite.cases.size(),
                   digest_of(suite.cases, files)};
  suite.cases.keep_share(static_cast<std::size_t>(selection.shard.index),
                         static_cast<std::size_t>(selection.shard.count));
  return suite;
}

}  // namespace edgecase
