// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/threads.h"
#include "casefile/loader.h"
#include "model/text.h"
#include "rules/all_rules.h"
#include "suite/selection.h"
#include "suite/sharding.h"

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

bool is_named(const Selection& selection, const CaseFile& file, const std::string& id) {
  return !selection.only || selection.only->files.contains(file.file) ||
         selection.only->ids.contains(id);
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

bool wanted_tags(const Selection& selection, const std::vector<std::string>& tags) {
  return selection.tags.empty() || std::ranges::find_first_of(tags, selection.tags) != tags.end();
}

// Drops what the selection does not ask for from lists of a file's cases: Case or CaseName.
class Chooser {
 public:
  explicit Chooser(const Selection& selection) : selection_(selection) {}

  template <class Named>
  void keep_wanted(const CaseFile& file, std::vector<Named>& cases) {
    if (const auto parts = selection_.parts.find(file.file);
        parts != selection_.parts.end() && !cases.empty())
      keep_parts(file, parts->second, cases);
    std::erase_if(cases, [&](const Named& one) {
      return !wanted_id(selection_, file.id, one.id) || !is_named(selection_, file, one.id);
    });
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

  template <class Named>
  void keep_parts(const CaseFile& file, const PartPatterns& patterns, std::vector<Named>& cases) {
    std::set<std::string> kept;
    for (const PartPattern& pattern : patterns) {
      Word& word = words_[pattern.word];
      word.file = file.file;
      word.cases += cases.size();
      const std::string whole = file.id + ":" + pattern.parts;
      const bool is_id =
          std::ranges::any_of(cases, [&](const Named& one) { return one.id == whole; });
      for (const Named& one : cases) {
        if (is_id ? one.id != whole : !matches_parts(pattern.parts, one.parts)) continue;
        kept.insert(one.id);
        word.matches = true;
      }
    }
    std::erase_if(cases, [&](const Named& one) { return !kept.contains(one.id); });
  }

  const Selection& selection_;
  std::map<std::string, Word> words_;
};

std::vector<std::string> known_rule_ids() {
  std::vector<std::string> ids;
  for (const Rule& rule : all_rules()) ids.push_back(name_of(rule.id));
  return ids;
}

template <class List>
void keep_sample(const Shard& sample, List& list) {
  std::size_t at = 0;
  std::erase_if(list, [&](const auto&) {
    return at++ % static_cast<std::size_t>(sample.count) != static_cast<std::size_t>(sample.index);
  });
}

// Which cases a shard has. The files are outlined alone, so that each shard reads no more cases
// than it has.
class ShardPlan {
 public:
  ShardPlan(const Selection& selection, const std::vector<CaseFile>& files, Chooser& chooser,
            std::span<const std::string> rules)
      : selection_(selection) {
    std::map<std::string, SharedText> texts;  // of files with a selected case, by id
    const auto outline = [&](std::size_t i) {
      return outline_cases(files[i].file, files[i].id, rules);
    };
    make_in_order(files.size(), outline, [&](std::size_t i, std::optional<FileOutline> outlined) {
      if (!outlined) {
        files_.insert(i);
        return;
      }
      chooser.keep_wanted(files[i], outlined->names);
      if (outlined->names.empty() || !wanted_tags(selection, outlined->first.tags)) return;
      texts.emplace(files[i].id, outlined->first.source);
      const double cost = cost_of(outlined->first.scene);
      for (CaseName& name : outlined->names) planned_.push_back({std::move(name.id), cost, i});
    });
    std::ranges::sort(planned_, {}, &Planned::id);
    keep_sample(selection.sample, planned_);
    share_ = {selection.shard.index, selection.shard.count, planned_.size(), digest_with(texts)};
    choose();
  }

  const ShareOfRun& share() const { return share_; }
  // True of those with a case of the shard, and of those whose faults are to be told.
  bool has_file(std::size_t file) const { return files_.contains(file); }
  bool has(const std::string& id) const { return ids_.contains(id); }
  std::size_t size() const { return ids_.size(); }

 private:
  struct Planned {
    std::string id;
    double cost = 0;
    std::size_t file = 0;
  };

  // Of the ids of all selected cases and of their files' texts.
  std::string digest_with(const std::map<std::string, SharedText>& texts) const {
    Digest digest;
    for (const Planned& one : planned_) digest.add(one.id);
    for (const auto& [id, text] : texts) digest.add(id).add(*text);
    return digest.text();
  }

  void choose() {
    std::vector<double> costs;
    for (const Planned& one : planned_) costs.push_back(one.cost);
    const Shard& shard = selection_.shard;
    std::vector<std::size_t> first = first_of_shards(costs, static_cast<std::size_t>(shard.count));
    first.push_back(planned_.size());
    const auto index = static_cast<std::size_t>(shard.index);
    for (std::size_t i = first[index]; i < first[index + 1]; ++i) {
      ids_.insert(planned_[i].id);
      files_.insert(planned_[i].file);
    }
  }

  const Selection& selection_;
  std::vector<Planned> planned_;
  ShareOfRun share_;
  std::set<std::size_t> files_;
  std::set<std::string> ids_;
};

}  // namespace

Suite load_suite(const Selection& selection) {
  const std::vector<std::string> rules = known_rule_ids();
  FoundCases found = find_cases(selection.paths);
  Suite suite;
  suite.diagnostics = selection.diagnostics;
  append(found.diagnostics, suite.diagnostics);
  Chooser chooser(selection);
  std::erase_if(found.cases, [&](const CaseFile& file) {
    return !may_be_wanted(selection, file.id) || !may_be_named(selection, file);
  });
  std::optional<ShardPlan> plan;
  if (selection.shard.count > 1) {
    plan.emplace(selection, found.cases, chooser, rules);
    suite.share = plan->share();
    std::size_t at = 0;
    std::erase_if(found.cases, [&](const CaseFile&) { return !plan->has_file(at++); });
  }
  const auto load = [&](std::size_t i) {
    return load_cases(found.cases[i].file, found.cases[i].id, rules);
  };
  make_in_order(found.cases.size(), load, [&](std::size_t i, LoadedCases loaded) {
    append(loaded.diagnostics, suite.diagnostics);
    append(loaded.notes, suite.notes);
    if (plan)
      std::erase_if(loaded.cases, [&](const Case& one) { return !plan->has(one.id); });
    else
      chooser.keep_wanted(found.cases[i], loaded.cases);
    for (Case& one : loaded.cases)
      if (wanted_tags(selection, one.tags)) suite.cases.push_back(std::move(one));
  });
  const std::size_t in_files = suite.diagnostics.size() - selection.diagnostics.size();
  chooser.tell(suite.diagnostics);
  suite.is_misspelt = suite.cases.empty() && in_files == 0 && !suite.diagnostics.empty();
  suite.cases.sort_by_id();
  if (plan)
    suite.share->faulty = plan->size() - suite.cases.size();
  else
    suite.cases.keep_sample(static_cast<std::size_t>(selection.sample.index),
                            static_cast<std::size_t>(selection.sample.count));
  return suite;
}

}  // namespace edgecase
