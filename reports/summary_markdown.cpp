// SPDX-License-Identifier: MIT
#include "reports/summary_markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "model/text.h"
#include "reports/explain_command.h"
#include "reports/markdown.h"
#include "reports/text.h"
#include "reports/unexpected_summary.h"
#include "results/clusters.h"
#include "results/worst_first.h"
#include "rules/renderer_claims.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostUnexpected = 50;
constexpr std::size_t kMostListed = 20;
constexpr std::size_t kMostClusters = 10;

// A heading, the head of a table or none, and at most `most` lines.
void add_list(const std::string& heading, const std::string& head,
              const std::vector<std::string>& lines, std::size_t most, MarkdownPage& page) {
  if (lines.empty()) return;
  page.add(fmt::format("\n## {}: {}\n\n{}", heading, lines.size(), head));
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) page.add(lines[i] + "\n");
  if (lines.size() > most) page.add(fmt::format("\nand {} more\n", lines.size() - most));
}

void add_table(const Results& results, MarkdownPage& page) {
  std::string head = "\n| renderer |";
  std::string rule = "|---|";
  for (const Verdict verdict : kWorstFirst) {
    head += fmt::format(" {} |", name_of(verdict));
    rule += "---:|";
  }
  page.add(head + " unexpected |\n" + rule + "---:|\n");
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    auto counts = count_verdicts(results, r);
    std::string row = fmt::format("| {} |", markdown_cell(results.renderers[r].name));
    for (const Verdict verdict : kWorstFirst) row += fmt::format(" {} |", counts[verdict]);
    const std::size_t unexpected = count_unexpected(results, r);
    const std::string mark = unexpected > 0 ? "**" : "";
    page.add(fmt::format("{} {}{}{} |\n", row, mark, unexpected, mark));
  }
}

std::vector<std::string> rows_of(const Results& results, const WantedAnswer& is_wanted) {
  std::vector<std::string> lines;
  for (const auto& [i, r] : worst_first(results, is_wanted)) {
    const CaseResults one = results.cases[i];
    const Result& result = one.results[r];
    lines.push_back(fmt::format("| {} | {} | {} | {} |", markdown_cell(one.id),
                                markdown_cell(results.renderers[r].name), headline(result),
                                markdown_cell(first_explanation(result, one.samples.samples))));
  }
  return lines;
}

void add_unexpected(const Results& results, MarkdownPage& page) {
  add_list(
      "Unexpected", "| case | renderer | verdict | why |\n|---|---|---|---|\n",
      rows_of(results, [](const ResultOutline& answer) { return is_unexpected(answer.standing); }),
      kMostUnexpected, page);
}

// Contested results, which are reported but not failures.
void add_contested(const Results& results, MarkdownPage& page) {
  add_list("Contested", "| case | renderer | verdict | why |\n|---|---|---|---|\n",
           rows_of(results,
                   [](const ResultOutline& answer) {
                     return answer.standing == Standing::tolerated && !answer.failure;
                   }),
           kMostListed, page);
}

void add_faults(const Results& results, MarkdownPage& page) {
  std::vector<std::string> files;
  for (const Diagnostic& diagnostic : results.diagnostics)
    files.push_back("- " + markdown_code(to_string(diagnostic)));
  std::vector<std::string> drawn;
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    const CaseOutline& one = results.cases.outline(i);
    if (one.expect_failures == 0) continue;
    for (const std::string& failure : results.cases[i].expect_failures)
      drawn.push_back(fmt::format("- {}: {}", markdown_code(one.id), markdown_code(failure)));
  }
  add_list("Case files that cannot be loaded", "", files, kMostListed, page);
  add_list("Hand-drawn expectations that the exact side does not meet", "", drawn, kMostListed,
           page);
}

// What renderers claim of themselves and the specification does not allow.
void add_refused_claims(const Results& results, MarkdownPage& page) {
  std::vector<std::string> lines;
  for (const RendererInfo& info : results.renderers)
    for (const std::string& claim : claims_of(info).refused)
      lines.push_back(fmt::format("- {}: {}", markdown_code(info.name), markdown_code(claim)));
  add_list("Claims that are not believed", "", lines, kMostListed, page);
}

// The known faults: those whose counts differ from their files, then all of them, folded.
void add_known(const Results& results, MarkdownPage& page) {
  std::vector<std::string> changed;
  std::vector<std::string> known;
  for (const FaultSeen& seen : results.faults) {
    (seen.state == FaultState::known ? known : changed)
        .push_back(fmt::format("| {} | {} | {} | {} |\n", markdown_cell(seen.id),
                               markdown_cell(seen.renderer), describe(seen),
                               markdown_cell(seen.reason)));
  }
  const std::string head = "| fault | renderer | cases | why |\n|---|---|---|---|\n";
  add_list("Known faults that are not as their files say", head, changed, kMostListed, page);
  add_list("Known faults", head, known, kMostListed, page);
}

std::string cluster_row(const Cluster& cluster, const RendererInfo& renderer,
                        const std::string& policy) {
  const ExplainCommand command{cluster.smallest_file, cluster.smallest_case, asked_as(renderer),
                               policy, std::pair(cluster.x, cluster.y)};
  return fmt::format("| {} | {} | {}{} | {} | {} |\n",
                     cluster.legality == Legality::legal     ? "yes"
                     : cluster.legality == Legality::illegal ? "**no**"
                                                             : "contested",
                     markdown_cell(title_of(cluster)), cluster.disagreements,
                     cluster.attribute.empty() ? "" : " values", cluster.cases,
                     markdown_cell(command_line(command)));
}

// Folded, since they include known and expected differences.
void add_clusters(const Results& results, std::size_t renderer, MarkdownPage& page) {
  const std::vector<Cluster> clusters = clusters_of(results, renderer);
  if (clusters.empty()) return;
  const RendererInfo& info = results.renderers[renderer];
  std::string text = fmt::format(
      "\n## What differs with {}\n\n<details><summary>{} kind{} of difference</summary>\n\n"
      "| allowed | what | differences | cases | explained by |\n|---|---|---:|---:|---|\n",
      markdown_code(info.name), clusters.size(), clusters.size() == 1 ? "" : "s");
  const std::size_t listed = std::min(kMostClusters, clusters.size());
  for (std::size_t i = 0; i < listed; ++i) text += cluster_row(clusters[i], info, results.policy);
  if (listed < clusters.size()) text += fmt::format("\nand {} more\n", clusters.size() - listed);
  page.add(text + "\n</details>\n");
}

}  // namespace

void write_markdown_summary(const Results& results, std::ostream& out) {
  MarkdownPage page(kMostOfSummary);
  page.add(fmt::format("# {}\n\n{}, policy {}\n", one_line(shortened(results.tool, 100)),
                       counted(results.cases.size(), "case", "cases"),
                       markdown_code(results.policy)));
  if (results.interrupted) page.add("\n**" + words_of_interruption(results) + "**\n");
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    if (drew_nothing(results, r))
      page.add("\n**Drew nothing:** " + markdown_code(words_of_idleness(results, r), 3000) + "\n");
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    for (const std::string& sentence : sentences_of(portrait_of(results, r)))
      page.add(fmt::format("\n{}: {}\n", markdown_code(results.renderers[r].name), sentence));
  add_table(results, page);
  add_unexpected(results, page);
  add_faults(results, page);
  add_refused_claims(results, page);
  add_known(results, page);
  add_contested(results, page);
  for (std::size_t r = 0; r < results.renderers.size(); ++r) add_clusters(results, r, page);
  out << page.text();
}

}  // namespace edgecase
