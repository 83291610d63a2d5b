// SPDX-License-Identifier: MIT
#include "run/merge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "run/judging.h"
#include "run/run_difference.h"

namespace edgecase {
namespace {

// Why parts cannot be merged; nothing where they can.
using Fault = std::optional<std::string>;

Fault compare_shares(const MergePart& a, const MergePart& b) {
  const auto& one = a.results.shard;
  const auto& other = b.results.shard;
  if (one.has_value() != other.has_value())
    return fmt::format("{} is a shard of a run, {} is none; merge one or the other",
                       one ? a.name : b.name, one ? b.name : a.name);
  if (!one) return std::nullopt;
  if (one->count != other->count)
    return fmt::format("{} is one of {} shards, {} one of {}; merge shards of one run", a.name,
                       one->count, b.name, other->count);
  if (one->selection != other->selection || one->cases != other->cases ||
      a.results.whole_suite != b.results.whole_suite)
    return fmt::format(
        "{} and {} are shards of different selections or suites: of {} cases, digest {}, and of {} "
        "cases, digest {}; run all shards with the same case files, paths and filters",
        a.name, b.name, one->cases, one->selection, other->cases, other->selection);
  return std::nullopt;
}

Fault find_twins(const std::vector<MergePart>& parts) {
  std::map<int, const MergePart*> shares;
  for (const MergePart& part : parts) {
    if (!part.results.shard) continue;
    const auto [found, is_new] = shares.emplace(part.results.shard->index, &part);
    if (!is_new)
      return fmt::format("{} and {} both hold shard {} of {}; name each shard once",
                         found->second->name, part.name, part.results.shard->index + 1,
                         part.results.shard->count);
  }
  return std::nullopt;
}

Fault find_conflicting_cases(const std::vector<MergePart>& parts) {
  std::map<std::string, const MergePart*> ids;
  std::map<std::string, std::pair<std::string, const MergePart*>> files;
  for (const MergePart& part : parts)
    for (const CaseResults& one : part.results.cases) {
      const auto [twin, is_new] = ids.emplace(one.id, &part);
      if (!is_new)
        return fmt::format("the case {} is in {} and in {}; merge runs of different cases", one.id,
                           twin->second->name, part.name);
      const auto [file, is_first] = files.emplace(one.file, std::pair{one.file_digest, &part});
      if (!is_first && file->second.first != one.file_digest)
        return fmt::format(
            "the case file {} is another in {} than in {}; run all shards with the "
            "same suite",
            one.file, file->second.second->name, part.name);
    }
  return std::nullopt;
}

// A share that has no case is not missed.
Fault find_missing_shares(const std::vector<MergePart>& parts) {
  const auto& share = parts.front().results.shard;
  if (!share) return std::nullopt;
  std::set<int> present;
  for (const MergePart& part : parts) present.insert(part.results.shard->index);
  std::vector<std::string> missing;
  for (int i = 0; i < share->count && static_cast<std::size_t>(i) < share->cases; ++i)
    if (!present.contains(i)) missing.push_back(fmt::format("{}/{}", i + 1, share->count));
  if (missing.empty()) return std::nullopt;
  return fmt::format(
      "shard{} {} {} missing; name the results of all, or merge what there is with --partial",
      missing.size() == 1 ? "" : "s", fmt::join(missing, ", "), missing.size() == 1 ? "is" : "are");
}

Fault find_fault(const std::vector<MergePart>& parts, bool partial) {
  for (const MergePart& part : parts) {
    if (const auto found = difference_of_runs(parts.front(), part))
      return found->what + "; " + found->remedy;
    if (Fault fault = compare_shares(parts.front(), part)) return fault;
  }
  if (Fault fault = find_twins(parts)) return fault;
  if (Fault fault = find_conflicting_cases(parts)) return fault;
  return partial ? std::nullopt : find_missing_shares(parts);
}

// Every shard loads all case files, and so finds all that is wrong with them.
void unite(const std::vector<Diagnostic>& from, std::vector<Diagnostic>& to) {
  const auto parts_of = [](const Diagnostic& d) {
    return std::tie(d.file, d.line, d.pointer, d.message, d.remedy);
  };
  for (const Diagnostic& diagnostic : from)
    if (std::ranges::none_of(
            to, [&](const Diagnostic& known) { return parts_of(known) == parts_of(diagnostic); }))
      to.push_back(diagnostic);
}

void add_part(Results part, Results& whole) {
  for (std::size_t r = 0; r < whole.renderers.size(); ++r)
    if (has_never_answered(whole.renderers[r])) whole.renderers[r] = std::move(part.renderers[r]);
  whole.cases.merge(std::move(part.cases));
  unite(part.diagnostics, whole.diagnostics);
  whole.interrupted = whole.interrupted || part.interrupted;
  whole.left_out += part.left_out;
}

}  // namespace

std::variant<Results, std::string> merge_results(std::vector<MergePart> parts, bool partial) {
  if (Fault fault = find_fault(parts, partial)) return std::move(*fault);
  Results whole = std::move(parts.front().results);
  for (std::size_t i = 1; i < parts.size(); ++i) add_part(std::move(parts[i].results), whole);
  if (whole.shard) {
    whole.left_out = whole.shard->cases - std::min(whole.shard->cases, whole.cases.size());
    whole.interrupted = whole.interrupted || whole.left_out > 0;
    whole.shard.reset();
  } else if (parts.size() > 1) {
    whole.whole_suite = false;
  }
  judge_all(whole);
  return whole;
}

}  // namespace edgecase
