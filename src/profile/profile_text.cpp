// SPDX-License-Identifier: MIT
#include "profile/profile_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "model/counted.h"
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
        "  What differs from this profile or is outside the specification ({}), what "
        "nothing catalogued explains first:\n",
        counted(surface.illegal_scenes, "scene is", "scenes are"));
  const std::size_t shown = std::min(most, surface.clusters.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const auto& [cluster, scene] = surface.clusters[i];
    print(out, "    {} {} in {}, {}\n      smallest: {}, pixel ({}, {})\n", cluster.disagreements,
          title_of(cluster), counted(cluster.cases, "scene", "scenes"),
          cluster.legality == Legality::illegal ? "NOT allowed" : describe(cluster.legality),
          scene_words(scene), cluster.x, cluster.y);
  }
  if (shown < surface.clusters.size())
    print(out, "    and {}; --json has all\n",
          counted(surface.clusters.size() - shown, "more cluster", "more clusters"));
}

void print_surface(Buffer& out, const SurfaceProfile& surface, std::size_t most_clusters) {
  if (!surface.unavailable.empty()) {
    print(out, "\n{}: not measured: {}\n", name_of(surface.surface), surface.unavailable);
    return;
  }
  print(out, "\n{}: {} scenes, {} of the {} random ones with a tie\n", name_of(surface.surface),
        surface.scenes, percent({surface.with_ties, surface.random_scenes}), surface.random_scenes);
  if (surface.not_drawn > 0)
    print(out, "  {} not drawn, the first: {}\n",
          counted(surface.not_drawn, "scene was", "scenes were"), surface.first_failure);
  print_traits(out, surface);
  print(out, "{}", value_errors_text(surface.values));
  print(out, "{}", level_residuals_text(surface.levels));
  print(out, "{}", sample_profile_text(surface.samples));
  print(out, "{}", output_profile_text(surface.output));
  for (const OwnershipTable& table : surface.tables) print_table(out, table);
  print_clusters(out, surface, most_clusters);
}

// ------------------------------------------------------------------------------------- summary

// The traits that some scene contradicts, least followed first.
std::vector<const Trait*> exceptions_of(const SurfaceProfile& surface) {
  std::vector<const Trait*> found;
  for (const Trait& trait : surface.traits)
    if (trait.rate.agreeing < trait.rate.of) found.push_back(&trait);
  const auto share = [](const Trait* trait) {
    return static_cast<double>(trait->rate.agreeing) / static_cast<double>(trait->rate.of);
  };
  std::ranges::stable_sort(found, {}, share);
  return found;
}

void summarize_traits(Buffer& out, const SurfaceProfile& surface) {
  constexpr std::size_t kMostNamed = 3;
  const auto exceptions = exceptions_of(surface);
  const auto undecided = std::ranges::count_if(surface.traits, &Trait::is_undecided);
  print(out, "{}: {} of {} traits hold in every scene", name_of(surface.surface),
        surface.traits.size() - exceptions.size(), surface.traits.size());
  if (undecided > 0) print(out, "; for {} another alternative is as good", undecided);
  print(out, "\n  least followed: ");
  if (exceptions.empty()) print(out, "none");
  for (std::size_t i = 0; i < std::min(kMostNamed, exceptions.size()); ++i)
    print(out, "{}{} {} ({})", i == 0 ? "" : ", ", exceptions[i]->id, exceptions[i]->alternative,
          percent(exceptions[i]->rate));
  print(out, "\n");
}

void summarize_surface(Buffer& out, const SurfaceProfile& surface) {
  if (!surface.unavailable.empty()) {
    print(out, "{}: not measured: {}\n", name_of(surface.surface), surface.unavailable);
    return;
  }
  summarize_traits(out, surface);
  if (surface.illegal_scenes == 0) {
    print(out, "  outside the specification: nothing\n");
    return;
  }
  print(out, "  outside the specification: {}", counted(surface.illegal_scenes, "scene", "scenes"));
  const auto illegal = std::ranges::find_if(surface.clusters, [](const ProfileCluster& found) {
    return found.cluster.legality == Legality::illegal;
  });
  if (illegal != surface.clusters.end())
    print(out, "; first {}, in {}", title_of(illegal->cluster),
          counted(illegal->cluster.cases, "scene", "scenes"));
  print(out, "\n");
}

// What the first surface that was measured follows of the rules that decide over coverage.
void summarize_coverage(Buffer& out, const Profile& profile) {
  const auto measured = std::ranges::find_if(
      profile.surfaces, [](const SurfaceProfile& surface) { return surface.unavailable.empty(); });
  if (measured == profile.surfaces.end()) return;
  std::string text;
  for (const char* rule : {name_of(RuleId::point_ownership), name_of(RuleId::line_algorithm),
                           name_of(RuleId::triangle_algorithm), name_of(RuleId::triangle_fill_rule),
                           name_of(RuleId::triangle_snap)}) {
    const auto trait = std::ranges::find(measured->traits, rule, &Trait::id);
    if (trait == measured->traits.end()) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", rule, trait->alternative);
  }
  if (!text.empty()) print(out, "coverage: {}\n", text);
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

std::string profile_summary(const Profile& profile) {
  Buffer out;
  print(out, "{}: {}, {}\n", profile.renderer.name, profile.renderer.device,
        profile.renderer.version);
  std::size_t scenes = 0;
  for (const SurfaceProfile& surface : profile.surfaces) scenes += surface.scenes;
  print(out, "{} drawn, seed {}; {} reported\n", counted(scenes, "scene", "scenes"), profile.seed,
        counted(static_cast<std::size_t>(std::max(0, profile.renderer.subpixel_bits)),
                "sub-pixel bit is", "sub-pixel bits are"));
  for (const SurfaceProfile& surface : profile.surfaces) summarize_surface(out, surface);
  summarize_coverage(out, profile);
  return fmt::to_string(out);
}

}  // namespace edgecase
