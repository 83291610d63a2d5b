// SPDX-License-Identifier: MIT
#include "reports/cluster_summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

#include "model/text.h"
#include "reports/explain_command.h"
#include "reports/text.h"

namespace edgecase {
namespace {

constexpr std::size_t kMaxListed = 5;  // of a renderer's clusters of one legality

fmt::text_style style_of(Legality legality) {
  return style_of(verdict_of(legality, false, Latitude::opengl));
}

std::string counts_of(const Cluster& cluster) {
  return fmt::format("{}{} in {} case{}", cluster.disagreements,
                     cluster.attribute.empty() ? "" : " values", cluster.cases,
                     cluster.cases == 1 ? "" : "s");
}

std::string command_for(const Cluster& cluster, const RendererInfo& renderer,
                        const std::string& policy) {
  return command_line(ExplainCommand{cluster.smallest_file, cluster.smallest_case,
                                     asked_as(renderer), policy, std::pair(cluster.x, cluster.y)});
}

// Legal clusters with a cause need no look at their smallest case.
bool needs_a_look(const Cluster& cluster) {
  return cluster.legality != Legality::legal || cluster.cause.empty();
}

// What is said in place of a cause: what all have in common, and what some look like.
std::string words_without_cause(const Cluster& cluster) {
  constexpr std::size_t kMostLikenesses = 2;
  std::vector<std::string> words;
  if (!cluster.common.empty()) words.push_back("all " + cluster.common);
  for (const ClusterSituation& row : cluster.situations)
    if (row.text.starts_with("as if ") && words.size() < kMostLikenesses)
      words.push_back(fmt::format("{} {}", counted(row.cases, "case", "cases"), row.text));
  if (words.empty()) return "";
  return one_line(fmt::format("no one cause found: {}", fmt::join(words, "; ")));
}

void write_cluster(const Cluster& cluster, const RendererInfo& renderer, const std::string& policy,
                   const Painter& paint, std::ostream& out) {
  out << fmt::format(
      "  {}  {}: {}\n",
      paint(style_of(cluster.legality), fmt::format("{:<11}", describe(cluster.legality))),
      one_line(title_of(cluster)), counts_of(cluster));
  if (const std::string words = words_without_cause(cluster); !words.empty())
    out << fmt::format("               {}\n", words);
  if (needs_a_look(cluster))
    out << fmt::format("               {}\n", command_for(cluster, renderer, policy));
}

// In the order of clusters_of: illegal ones, then contested ones, then legal ones.
void write_renderer(std::span<const Cluster> clusters, const RendererInfo& renderer,
                    const std::string& policy, const Painter& paint, std::ostream& out) {
  if (clusters.empty()) return;
  out << '\n' << paint.bold(fmt::format("What differs with {}:", one_line(renderer.name))) << '\n';
  while (!clusters.empty()) {
    const auto other = std::ranges::find_if(clusters, [&](const Cluster& cluster) {
      return cluster.legality != clusters.front().legality;
    });
    const auto alike = clusters.first(static_cast<std::size_t>(other - clusters.begin()));
    for (const Cluster& cluster : alike.first(std::min(kMaxListed, alike.size())))
      write_cluster(cluster, renderer, policy, paint, out);
    if (alike.size() > kMaxListed)
      out << fmt::format("  {:<11}  and {} more\n", "", alike.size() - kMaxListed);
    clusters = clusters.subspan(alike.size());
  }
}

}  // namespace

void write_clusters(const Results& results, const std::vector<std::vector<Cluster>>& clusters,
                    const Painter& paint, std::ostream& out) {
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    write_renderer(clusters[r], results.renderers[r], results.policy, paint, out);
}

}  // namespace edgecase
