// SPDX-License-Identifier: MIT
#include "reports/cluster_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

#include "reports/explain_command.h"
#include "reports/text.h"
#include "results/clusters.h"

namespace edgecase {
namespace {

constexpr std::size_t kMaxListed = 5;  // of those without cause, and of the causes

std::string legality(const Cluster& cluster, const Painter& paint) {
  return paint(style_of(cluster.legal ? Verdict::permitted : Verdict::violation),
               fmt::format("{:<9}", cluster.legal ? "legal" : "not legal"));
}

std::string counts_of(const Cluster& cluster) {
  return fmt::format("{}{} in {} case{}", cluster.disagreements,
                     cluster.attribute.empty() ? "" : " values", cluster.cases,
                     cluster.cases == 1 ? "" : "s");
}

std::string command_for(const Cluster& cluster, const std::string& renderer,
                        const std::string& policy) {
  return words_of(ExplainCommand{cluster.smallest_file, cluster.smallest_case, renderer, policy,
                                 std::pair(cluster.x, cluster.y)});
}

void write_more(std::size_t count, std::ostream& out) {
  if (count > kMaxListed) out << fmt::format("  and {} more\n", count - kMaxListed);
}

// Each with the command that shows its smallest case.
void write_unexplained(std::span<const Cluster> clusters, const Results& results,
                       const std::string& renderer, const Painter& paint, std::ostream& out) {
  for (const Cluster& cluster : clusters.first(std::min(kMaxListed, clusters.size())))
    out << fmt::format("  {}  {}\n             {}: {}\n", legality(cluster, paint),
                       one_line(title_of(cluster)), counts_of(cluster),
                       command_for(cluster, renderer, results.policy));
  write_more(clusters.size(), out);
}

void write_causes(std::span<const Cluster> clusters, const Painter& paint, std::ostream& out) {
  for (const Cluster& cluster : clusters.first(std::min(kMaxListed, clusters.size())))
    out << fmt::format("  {}  {}: {}\n", legality(cluster, paint), one_line(title_of(cluster)),
                       counts_of(cluster));
  write_more(clusters.size(), out);
}

void write_heading(const std::string& text, const std::string& renderer, const Painter& paint,
                   std::ostream& out) {
  out << '\n' << paint.bold(fmt::format("{} {}:", text, one_line(renderer))) << '\n';
}

}  // namespace

void write_clusters(const Results& results, const Painter& paint, std::ostream& out) {
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const std::string& renderer = results.renderers[r].name;
    const std::vector<Cluster> clusters = clusters_of(results, r);
    const auto first_cause = std::ranges::find_if(
        clusters, [](const Cluster& cluster) { return !cluster.cause.empty(); });
    const std::span<const Cluster> unexplained(clusters.begin(), first_cause);
    const std::span<const Cluster> causes(first_cause, clusters.end());
    if (!unexplained.empty()) {
      write_heading("No alternative accounts for these differences of", renderer, paint, out);
      write_unexplained(unexplained, results, renderer, paint, out);
    }
    if (!causes.empty()) {
      write_heading("Alternatives account for these differences of", renderer, paint, out);
      write_causes(causes, paint, out);
    }
  }
}

}  // namespace edgecase
