// SPDX-License-Identifier: MIT
#include "reports/unexpected_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <ostream>
#include <span>
#include <tuple>
#include <utility>

#include "model/text.h"
#include "reports/explain_command.h"
#include "reports/text.h"
#include "results/worst_first.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

constexpr std::size_t kMaxListed = 10;

// The difference that an answer is told by: the worst, null where there is none.
const Disagreement* leading(const Result& result) {
  const std::vector<const Disagreement*> sorted = worst_first(result);
  return sorted.empty() ? nullptr : sorted.front();
}

std::string cause_of(const CaseResults& one, const Result& result, const Portrait& portrait,
                     std::span<const Cluster> clusters) {
  if (result.failure) return name_of(result.failure->kind);
  const Cluster* const cluster = told_by(one, result, portrait, clusters);
  return cluster != nullptr ? title_of(*cluster) : "";
}

int urgency_of(Verdict verdict) {
  if (verdict == Verdict::violation) return 0;
  if (verdict == Verdict::not_run) return 1;
  return 2 + static_cast<int>(Verdict::violation) - static_cast<int>(verdict);
}

bool comes_before(const UnexpectedGroup& a, const UnexpectedGroup& b) {
  const auto order = [](const UnexpectedGroup& group) {
    return std::tuple(urgency_of(group.verdict), -static_cast<long>(group.cases),
                      std::tie(group.cause, group.is_partly_known, group.renderer, group.standing));
  };
  return order(a) < order(b);
}

// Where to look, and what is there: a sentence.
std::string evidence_of(const CaseResults& one, const Result& result) {
  if (result.standing == Standing::flake) return result.standing_reason;
  if (const Disagreement* d = leading(result))
    return fmt::format("{}: {}", place_of(*d, one.samples.samples), d->explanation);
  return first_explanation(result, one.samples.samples);
}

std::string command_for(const CaseResults& one, const Result& result, const RendererInfo& renderer,
                        const std::string& policy) {
  ExplainCommand command{one.file, one.id, asked_as(renderer), policy, {}};
  if (const Disagreement* d = leading(result)) command.pixel = {d->x, d->y};
  return command_line(command);
}

void write_group(const UnexpectedGroup& group, const Results& results, const Painter& paint,
                 std::ostream& out) {
  const CaseResults one = results.cases[group.simplest];
  const Result& result = one.results[group.renderer];
  const RendererInfo info = group.renderer < results.renderers.size()
                                ? results.renderers[group.renderer]
                                : RendererInfo();
  out << fmt::format("  {}, {}: {}, {}\n", counted(group.cases, "case", "cases"),
                     one_line(info.name), paint(style_of(group.verdict), name_of(group.verdict)),
                     group.standing == Standing::flake ? "and then another answer"
                     : group.is_partly_known           ? "known in part"
                                                       : "not known");
  if (!group.cause.empty()) out << "    " << paint.bold(one_line(group.cause)) << '\n';
  constexpr std::size_t kMostBytes = 2000;
  const std::string evidence = one_line(shortened(evidence_of(one, result), kMostBytes));
  out << fmt::format("    {}{}{}\n", one_line(one.id), evidence.empty() ? "" : ": ", evidence);
  out << "    " << command_for(one, result, info, results.policy) << '\n';
}

bool is_counted(const ResultOutline& answer) {
  return is_unexpected(answer.standing);
}

}  // namespace

std::vector<UnexpectedGroup> unexpected_groups(const Results& results,
                                               const std::vector<std::vector<Cluster>>& clusters) {
  using Key = std::tuple<std::size_t, Standing, Verdict, bool, std::string>;
  std::map<Key, UnexpectedGroup> groups;
  std::map<Key, CaseSize> sizes;  // of the simplest
  std::vector<Portrait> portraits;
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    portraits.push_back(portrait_of(results, r));
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    if (std::ranges::none_of(results.cases.outline(i).answers, is_counted)) continue;
    const CaseResults one = results.cases[i];
    for (std::size_t r = 0; r < one.results.size(); ++r) {
      const Result& result = one.results[r];
      if (!is_counted(result)) continue;
      const bool partly = !result.faults.empty();
      const std::string cause =
          r < portraits.size() ? cause_of(one, result, portraits[r], clusters[r]) : "";
      const Key key(r, result.standing, result.verdict, partly, cause);
      UnexpectedGroup& group = groups[key];
      if (group.cases == 0) group = {r, result.standing, result.verdict, partly, cause, 0, i};
      ++group.cases;
      const auto [smallest, is_first] = sizes.try_emplace(key, one);
      if (is_first || !(CaseSize(one) < smallest->second)) continue;
      smallest->second = CaseSize(one);
      group.simplest = i;
    }
  }
  std::vector<UnexpectedGroup> sorted;
  for (auto& [key, group] : groups) sorted.push_back(std::move(group));
  std::ranges::sort(sorted, comes_before);
  return sorted;
}

void write_unexpected(const Results& results, const std::vector<std::vector<Cluster>>& clusters,
                      const Painter& paint, std::ostream& out) {
  const std::vector<UnexpectedGroup> groups = unexpected_groups(results, clusters);
  if (groups.empty()) return;
  out << '\n' << paint.bold("Unexpected, by cause:") << '\n';
  const std::size_t listed = std::min(kMaxListed, groups.size());
  for (std::size_t i = 0; i < listed; ++i) write_group(groups[i], results, paint, out);
  if (listed < groups.size())
    out << fmt::format("  and {}\n", counted(groups.size() - listed, "more cause", "more causes"));
}

}  // namespace edgecase
