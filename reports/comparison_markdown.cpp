// SPDX-License-Identifier: MIT
#include "reports/comparison_markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "model/text.h"
#include "reports/markdown.h"
#include "reports/text.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostListed = 10;
constexpr std::size_t kMostBytes = 64'000;  // GitHub takes comments of 65,536

std::string describe(const std::optional<Judgement>& answer) {
  if (!answer) return "-";
  const std::string verdict = name_of(answer->verdict);
  return answer->fingerprint.empty() ? verdict : verdict + " " + markdown_code(answer->fingerprint);
}

void write_facts(const std::vector<FactChange>& facts, MarkdownPage& page) {
  if (facts.empty()) return;
  page.add("\n| differs | old | new |\n|---|---|---|\n");
  for (const FactChange& fact : facts)
    page.add(fmt::format("| {} | {} | {} |\n", one_line(fact.what), markdown_cell(fact.before),
                         markdown_cell(fact.after)));
}

std::string more_of(std::size_t all, const char* one, const char* several) {
  return all > kMostListed ? fmt::format("\nand {}\n", counted(all - kMostListed, one, several))
                           : "";
}

void write_clusters(const RendererComparison& renderer, ChangeKind change, MarkdownPage& page) {
  std::size_t count = 0;
  for (const ChangeCluster& cluster : renderer.clusters) {
    if (cluster.change != change) continue;
    if (count == 0)
      page.add("\n| rule | cause | cases | differences | first case |\n|---|---|---:|---:|---|\n");
    if (++count > kMostListed) continue;
    page.add(fmt::format("| {} | {} | {} | {} | {} |\n", markdown_cell(cluster.rule),
                         markdown_cell(cluster.cause), cluster.cases, cluster.disagreements,
                         markdown_cell(cluster.first_case)));
  }
  page.add(more_of(count, "more rule and cause", "more rules and causes"));
}

void write_cases(const RendererComparison& renderer, ChangeKind change, MarkdownPage& page) {
  std::size_t count = 0;
  std::string lines = "\n<details><summary>Cases</summary>\n\n";
  for (const CaseChange& one : renderer.cases) {
    if (one.change != change || ++count > kMostListed) continue;
    lines += fmt::format("- {}: {} -> {}\n", markdown_code(one.id), describe(one.before),
                         describe(one.after));
  }
  page.add(lines + more_of(count, "more case", "more cases") + "\n</details>\n");
}

void write_renderer(const RendererComparison& renderer, MarkdownPage& page) {
  page.add(fmt::format(
      "\n## {}\n", renderer.before == renderer.after
                       ? markdown_code(renderer.before)
                       : markdown_code(renderer.before) + " -> " + markdown_code(renderer.after)));
  write_facts(renderer.facts, page);
  page.add(fmt::format("\n{} of {} {}.\n", renderer.same,
                       counted(renderer.same + renderer.cases.size(), "case", "cases"),
                       renderer.same == 1 ? "is as it was" : "are as they were"));
  for (const ChangeKind change : values_of<ChangeKind>()) {
    const auto found = renderer.counts.find(change);
    if (found == renderer.counts.end()) continue;
    page.add(fmt::format("\n### {}: {}\n", found->second, describe(change)));
    write_clusters(renderer, change, page);
    write_cases(renderer, change, page);
  }
}

}  // namespace

std::string comparison_markdown(const Comparison& comparison) {
  MarkdownPage page(kMostBytes);
  page.add("# Comparison of results\n");
  write_facts(comparison.facts, page);
  for (const RendererComparison& renderer : comparison.renderers) write_renderer(renderer, page);
  for (const std::string& name : comparison.only_before)
    page.add(fmt::format("\nOnly the old results have {}.\n", markdown_code(name)));
  for (const std::string& name : comparison.only_after)
    page.add(fmt::format("\nOnly the new results have {}.\n", markdown_code(name)));
  return page.text();
}

}  // namespace edgecase
