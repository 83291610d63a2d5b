// SPDX-License-Identifier: MIT
#include "run/selection.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "casefile/json/text.h"
#include "casefile/loader.h"
#include "model/text.h"
#include "rules/all_rules.h"

namespace edgecase {
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

// Can a glob match an id that starts with `start`? Some part of it then matches the start.
bool may_match(const std::string& glob, const std::string& start) {
  for (std::size_t length = 1; length <= glob.size(); ++length)
    if (fnmatch(glob.substr(0, length).c_str(), start.c_str(), 0) == 0) return true;
  return false;
}

// Is one of the file's cases named, or the file itself?
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

// Can one of a file's cases be asked for?
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

// Keeps, of files of which not all cases are meant, those that are.
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

// Ids, and texts of files, each of which stands with all of its cases.
std::string digest_of(const CaseStore& cases) {
  Digest digest;
  std::optional<SharedText> text;
  for (const Case& one : cases) {
    digest.add(one.id);
    if (text != one.source) digest.add(*one.source);
    text = one.source;
  }
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
  for (const CaseFile& file : found.cases) {
    if (!may_be_wanted(selection, file.id) || !may_be_named(selection, file)) continue;
    LoadedCases loaded = load_cases(file.file, file.id, rules);
    append(loaded.diagnostics, suite.diagnostics);
    append(loaded.notes, suite.notes);
    if (const auto parts = selection.parts.find(file.file);
        parts != selection.parts.end() && !loaded.cases.empty())
      keeper.keep(file, parts->second, loaded.cases);
    for (Case& one : loaded.cases)
      if (wanted_id(selection, file.id, one.id) && wanted_tags(selection, one) &&
          is_named(selection, one))
        suite.cases.push_back(std::move(one));
  }
  const std::size_t in_files = suite.diagnostics.size() - selection.diagnostics.size();
  keeper.tell(suite.diagnostics);
  suite.is_misspelt = suite.cases.empty() && in_files == 0 && !suite.diagnostics.empty();
  suite.cases.sort_by_id();
  if (selection.shard.count > 1)
    suite.share = {selection.shard.index, selection.shard.count, suite.cases.size(),
                   digest_of(suite.cases)};
  // Round robin, so that shards are of one size and each sees every folder.
  suite.cases.keep_share(static_cast<std::size_t>(selection.shard.index),
                         static_cast<std::size_t>(selection.shard.count));
  return suite;
}

}  // namespace edgecase
