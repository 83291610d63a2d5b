// SPDX-License-Identifier: MIT
#include "reports/comparison_markdown.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "model/counted.h"
#include "reports/markdown.h"
#include "reports/text.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostListed = 20;

// What a change means, as a heading says it.
const char* words_of(ChangeKind change) {
  switch (change) {
    case ChangeKind::new_disagreement:
      return "new disagreements";
    case ChangeKind::worse:
      return "worse";
    case ChangeKind::not_run:
      return "not run any more";
    case ChangeKind::changed:
      return "changed";
    case ChangeKind::appeared:
      return "cases that appeared";
    case ChangeKind::disappeared:
      return "cases that disappeared";
    case ChangeKind::runs:
      return "run now";
    case ChangeKind::better:
      return "better";
    case ChangeKind::fixed:
      return "fixed";
  }
  return "?";
}

std::string words_of(const std::optional<Judgement>& answer) {
  if (!answer) return "-";
  const std::string verdict = name_of(answer->verdict);
  return answer->fingerprint.empty() ? verdict : verdict + " " + markdown_code(answer->fingerprint);
}

void write_facts(const std::vector<FactChange>& facts, std::ostream& out) {
  if (facts.empty()) return;
  out << "\n| differs | old | new |\n|---|---|---|\n";
  for (const FactChange& fact : facts)
    fmt::print(out, "| {} | {} | {} |\n", one_line(fact.what), markdown_cell(fact.before),
               markdown_cell(fact.after));
}

void write_more(std::size_t all, const char* one, const char* several, std::ostream& out) {
  if (all > kMostListed) fmt::print(out, "\nand {}\n", counted(all - kMostListed, one, several));
}

void write_clusters(const RendererComparison& renderer, ChangeKind change, std::ostream& out) {
  std::size_t count = 0;
  for (const ChangeCluster& cluster : renderer.clusters) {
    if (cluster.change != change) continue;
    if (count == 0)
      out << "\n| rule | cause | cases | differences | first case |\n|---|---|---|---|---|\n";
    if (++count > kMostListed) continue;
    fmt::print(out, "| {} | {} | {} | {} | {} |\n", markdown_cell(cluster.rule),
               markdown_cell(cluster.cause), cluster.cases, cluster.disagreements,
               markdown_cell(cluster.first_case));
  }
  write_more(count, "more rule and cause", "more rules and causes", out);
}

void write_cases(const RendererComparison& renderer, ChangeKind change, std::ostream& out) {
  std::size_t count = 0;
  out << '\n';
  for (const CaseChange& one : renderer.cases) {
    if (one.change != change || ++count > kMostListed) continue;
    fmt::print(out, "- {}: {} -> {}\n", markdown_code(one.id), words_of(one.before),
               words_of(one.after));
  }
  write_more(count, "more case", "more cases", out);
}

void write_renderer(const RendererComparison& renderer, std::ostream& out) {
  fmt::print(out, "\n## {}\n",
             renderer.before == renderer.after
                 ? markdown_code(renderer.before)
                 : markdown_code(renderer.before) + " -> " + markdown_code(renderer.after));
  write_facts(renderer.facts, out);
  fmt::print(out, "\n{} of {} {}.\n", renderer.same,
             counted(renderer.same + renderer.cases.size(), "case", "cases"),
             renderer.same == 1 ? "is as it was" : "are as they were");
  for (const ChangeKind change : kAllChanges) {
    const auto found = renderer.counts.find(change);
    if (found == renderer.counts.end()) continue;
    fmt::print(out, "\n### {}: {}\n", found->second, words_of(change));
    write_clusters(renderer, change, out);
    write_cases(renderer, change, out);
  }
}

}  // namespace

void write_comparison(const Comparison& comparison, std::ostream& out) {
  out << "# Comparison of results\n";
  write_facts(comparison.facts, out);
  for (const RendererComparison& renderer : comparison.renderers) write_renderer(renderer, out);
  for (const std::string& name : comparison.only_before)
    fmt::print(out, "\nOnly the old results have {}.\n", markdown_code(name));
  for (const std::string& name : comparison.only_after)
    fmt::print(out, "\nOnly the new results have {}.\n", markdown_code(name));
}

}  // namespace edgecase
