// SPDX-License-Identifier: MIT
#include "profile/profile_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "model/scene_words.h"
#include "profile/output/output_text.h"
#include "profile/samples/sample_text.h"
#include "profile/textures/texture_text.h"
#include "profile/values/value_text.h"

namespace edgecase {
namespace {

using Buffer = fmt::memory_buffer;

template <class... Args>
void print(Buffer& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

void print_traits(Buffer& out, const SurfaceProfile& surface) {
  print(out, "  {:<38}{:<33}{:<26}{}\n", "rule or probe", "follows", "agreement", "runner-up");
  for (const Trait& trait : surface.traits) {
    print(out, "  {:<38}{:<33}{:<26}", trait.id, trait.alternative,
          fmt::format("{} ({} of {})", percent(trait.rate), trait.rate.agreeing, trait.rate.of));
    if (!trait.runner_up.empty())
      print(out, "{} {}", trait.runner_up, percent(trait.runner_up_rate));
    if (trait.is_undecided()) print(out, " (as good)");
    print(out, "\n");
    if (!trait.remark.empty()) print(out, "    {}\n", trait.remark);
  }
}

// '#' always drawn, '.' never, '?' now and then, ' ' not asked.
char sign_of(const OwnershipTable::Cell& cell) {
  if (cell.of == 0) return ' ';
  if (cell.drawn == 0) return '.';
  return cell.drawn == cell.of ? '#' : '?';
}

void print_table(Buffer& out, const OwnershipTable& table) {
  print(out, "  {}: # drawn, . not drawn, ? now and then\n", table.title);
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    print(out, "    {:<24}{:>{}} {}\n", "", "|", c + 1, table.columns[c]);
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    print(out, "    {:<24}", table.rows[r]);
    for (const OwnershipTable::Cell& cell : table.cells[r]) print(out, "{}", sign_of(cell));
    print(out, "\n");
  }
}

void print_clusters(Buffer& out, const SurfaceProfile& surface, std::size_t most) {
  if (surface.clusters.empty()) {
    print(out, "  Nothing differs from this profile, and nothing is outside the specification.\n");
    return;
  }
  print(out,
        "  What differs from this profile or is outside the specification ({} scenes are), what "
        "nothing catalogued explains first:\n",
        surface.illegal_scenes);
  const std::size_t shown = std::min(most, surface.clusters.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const auto& [cluster, scene] = surface.clusters[i];
    print(out, "    {} {} in {} scenes, {}\n      smallest: {}, pixel ({}, {})\n",
          cluster.disagreements, title_of(cluster), cluster.cases,
          cluster.legality == Legality::illegal ? "NOT allowed" : describe(cluster.legality),
          scene_words(scene), cluster.x, cluster.y);
  }
  if (shown < surface.clusters.size())
    print(out, "    and {} more clusters; --json has all\n", surface.clusters.size() - shown);
}

void print_surface(Buffer& out, const SurfaceProfile& surface, std::size_t most_clusters) {
  if (!surface.unavailable.empty()) {
    print(out, "\n{}: not measured: {}\n", name_of(surface.surface), surface.unavailable);
    return;
  }
  print(out, "\n{}: {} scenes, {} of the {} random ones with a tie\n", name_of(surface.surface),
        surface.scenes, percent({surface.with_ties, surface.random_scenes}), surface.random_scenes);
  if (surface.not_drawn > 0)
    print(out, "  {} scenes were not drawn, the first: {}\n", surface.not_drawn,
          surface.first_failure);
  print_traits(out, surface);
  print(out, "{}", value_errors_text(surface.values));
  print(out, "{}", level_residuals_text(surface.levels));
  print(out, "{}", sample_profile_text(surface.samples));
  print(out, "{}", output_profile_text(surface.output));
  for (const OwnershipTable& table : surface.tables) print_table(out, table);
  print_clusters(out, surface, most_clusters);
}

}  // namespace

std::string percent(const Rate& rate) {
  if (rate.of == 0) return "-";
  if (rate.agreeing == rate.of) return "100 %";
  const std::size_t hundredths = rate.agreeing * 10'000 / rate.of;
  return fmt::format("{}.{:02} %", hundredths / 100, hundredths % 100);
}

std::string profile_text(const Profile& profile, std::size_t most_clusters) {
  Buffer out;
  print(out, "{}: {}, {}\n", profile.renderer.name, profile.renderer.device,
        profile.renderer.version);
  print(out,
        "{} random scenes of each primitive type on each surface, seed {}; {} sub-pixel bits "
        "are reported\n",
        profile.scenes_per_kind, profile.seed, profile.renderer.subpixel_bits);
  for (const SurfaceProfile& surface : profile.surfaces) print_surface(out, surface, most_clusters);
  return fmt::to_string(out);
}

}  // namespace edgecase
