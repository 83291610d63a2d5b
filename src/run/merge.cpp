// SPDX-License-Identifier: MIT
#include "run/merge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "model/text.h"
#include "run/judging.h"

namespace edgecase {
namespace {

using Difference = std::optional<RunDifference>;

std::string describe(const Results& results) {
  return fmt::format("policy {}{}", results.policy,
                     results.latitude == Latitude::none ? " without latitude" : "");
}

std::string renderer_names(const Results& results) {
  std::vector<std::string> names;
  for (const RendererInfo& info : results.renderers) names.push_back(info.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

// The renderer's own statements, without the traits that judging sets.
auto claims_of(const RendererInfo& info) {
  auto traits = info.traits;
  std::erase_if(traits, [](const auto& trait) { return is_of_judging(trait.first); });
  return std::tuple(info.vendor, info.version, info.device, info.subpixel_bits, std::move(traits));
}

std::string describe(const RendererInfo& info) {
  std::string text = fmt::format("{}, version {}, vendor {}, {} subpixel bits", info.device,
                                 info.version, info.vendor, info.subpixel_bits);
  for (const auto& [name, value] : info.traits)
    if (!is_of_judging(name)) text += fmt::format(", {}: {}", name, value);
  return text;
}

Difference difference_of_renderers(const MergePart& a, const MergePart& b) {
  if (renderer_names(a.results) != renderer_names(b.results))
    return RunDifference{fmt::format("{} holds results of {}, {} of {}", a.name,
                                     renderer_names(a.results), b.name, renderer_names(b.results)),
                         "merge shards of one run"};
  for (std::size_t r = 0; r < a.results.renderers.size(); ++r) {
    const RendererInfo& one = a.results.renderers[r];
    const RendererInfo& other = b.results.renderers[r];
    if (has_never_answered(one) || has_never_answered(other) || claims_of(one) == claims_of(other))
      continue;
    return RunDifference{
        fmt::format("the renderer {} is not the same: in {} it is {}; in {} it is {}", one.name,
                    a.name, describe(one), b.name, describe(other)),
        "run all shards against one version"};
  }
  return std::nullopt;
}

}  // namespace

bool has_never_answered(const RendererInfo& renderer) {
  return renderer.device.empty();
}

Difference difference_of_runs(const MergePart& a, const MergePart& b) {
  if (a.results.tool != b.results.tool)
    return RunDifference{fmt::format("{} was written by {}, {} by {}", a.name, a.results.tool,
                                     b.name, b.results.tool),
                         "run all shards with one version"};
  if (describe(a.results) != describe(b.results))
    return RunDifference{fmt::format("{} was judged by {}, {} by {}", a.name, describe(a.results),
                                     b.name, describe(b.results)),
                         "run all shards with one policy"};
  // The profile of a renderer that never answered is unknown, and not in the digest.
  const bool know_the_same = std::ranges::equal(a.results.renderers, b.results.renderers, {},
                                                has_never_answered, has_never_answered);
  if (know_the_same && a.results.policy_digest != b.results.policy_digest)
    return RunDifference{
        fmt::format("{} and {} were judged by policies or profiles that differ, though their names "
                    "do not",
                    a.name, b.name),
        "run all shards with the same files"};
  return difference_of_renderers(a, b);
}

namespace {

// The reason why parts cannot be merged; nothing if they can.
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

// A share without cases is not missing.
Fault find_missing_shares(const std::vector<MergePart>& parts) {
  const auto& share = parts.front().results.shard;
  if (!share) return std::nullopt;
  std::set<int> present;
  for (const MergePart& part : parts) present.insert(part.results.shard->index);
  constexpr std::size_t kMostNamed = 20;
  std::size_t count = 0;
  std::vector<std::string> missing;
  for (int i = 0; i < share->count && static_cast<std::size_t>(i) < share->cases; ++i)
    if (!present.contains(i) && ++count <= kMostNamed)
      missing.push_back(fmt::format("{}/{}", i + 1, share->count));
  if (count == 0) return std::nullopt;
  if (count > kMostNamed) missing.push_back(fmt::format("and {} more", count - kMostNamed));
  return fmt::format(
      "shard{} {} {} missing; name the results of all, or merge what there is with --partial",
      count == 1 ? "" : "s", fmt::join(missing, ", "), count == 1 ? "is" : "are");
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

// Shards with cases of one file have the same diagnostics of it.
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
  for (std::size_t r = 0; r < whole.renderers.size(); ++r) {
    if (!has_never_answered(whole.renderers[r])) continue;
    if (!has_never_answered(part.renderers[r])) whole.policy_digest = part.policy_digest;
    whole.renderers[r] = std::move(part.renderers[r]);
  }
  whole.cases.merge(std::move(part.cases));
  unite(part.diagnostics, whole.diagnostics);
  whole.interrupted = whole.interrupted || part.interrupted;
  whole.left_out += part.left_out;
  if (whole.shard) whole.shard->faulty += part.shard->faulty;
}

}  // namespace

std::variant<Results, std::string> merge_results(std::vector<MergePart> parts, bool partial) {
  if (Fault fault = find_fault(parts, partial)) return std::move(*fault);
  Results whole = std::move(parts.front().results);
  for (std::size_t i = 1; i < parts.size(); ++i) add_part(std::move(parts[i].results), whole);
  if (whole.shard) {
    const std::size_t accounted = whole.cases.size() + whole.shard->faulty;
    whole.left_out = whole.shard->cases - std::min(whole.shard->cases, accounted);
    whole.interrupted = whole.interrupted || whole.left_out > 0;
    whole.shard.reset();
  } else if (parts.size() > 1) {
    whole.whole_suite = false;
  }
  judge_all(whole);
  return whole;
}

namespace {

bool could_be_had(const CaseOutline& one) {
  return std::ranges::none_of(one.answers, [](const ResultOutline& answer) {
    return answer.failure && answer.failure->kind == FailureKind::unavailable;
  });
}

// True if the case may depend on further files: it has the key of a mesh or of an image.
bool may_need_more_files(const std::string& source) {
  return source.find("\"mesh\"") != std::string::npos ||
         source.find("\"file\"") != std::string::npos;
}

bool is_still_right(const CaseResults& earlier, const Case& now) {
  return earlier.file_digest == digest_of_text(*now.source) && !may_need_more_files(*now.source);
}

// Refuses cases that would be lost. Ids of files that are gone or have changed may be dropped.
std::variant<Resumption, std::string> checked(Resumption resumed, const std::string& name,
                                              const CaseList& earlier,
                                              const std::map<std::string, std::size_t>& left) {
  std::set<std::string> changed;
  for (const Diagnostic& diagnostic : resumed.rest.diagnostics) changed.insert(diagnostic.file);
  for (const Case& one : resumed.rest.cases) changed.insert(one.file.generic_string());
  for (const auto& [id, index] : left) {
    const std::string file = earlier[index].file;
    std::error_code error;
    if (!changed.contains(file) && std::filesystem::exists(file, error))
      return fmt::format(
          "{} holds the case {}, which is not selected now and would be lost; name the paths and "
          "filters of that run, or run without --resume",
          name, id);
  }
  return resumed;
}

}  // namespace

std::variant<Resumption, std::string> resume(const Suite& suite, MergePart earlier) {
  const CaseList cases = std::exchange(earlier.results.cases, {});
  std::map<std::string, std::size_t> known;  // index by id
  for (const CaseOutline& one : cases.outlines()) known.emplace(one.id, known.size());
  Resumption resumed;
  Results& held = resumed.held = std::move(earlier.results);
  held.diagnostics.clear();
  held.faults.clear();
  held.shard.reset();
  held.interrupted = false;
  held.left_out = 0;
  resumed.rest.diagnostics = suite.diagnostics;
  for (const Case& now : suite.cases) {
    const auto found = known.find(now.id);
    bool is_kept = false;
    if (found != known.end() && could_be_had(cases.outline(found->second))) {
      CaseResults one = cases[found->second];
      is_kept = is_still_right(one, now);
      one.file = now.file.generic_string();
      if (is_kept) held.cases.push_back(one);
    }
    if (!is_kept) resumed.rest.cases.push_back(now);
    if (found != known.end()) known.erase(found);
  }
  return checked(std::move(resumed), earlier.name, cases, known);
}

}  // namespace edgecase
