// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "model/text.h"
#include "profile/profile.h"

namespace edgecase {
namespace {

// The traits that something contradicts of what was asked, least followed first.
std::vector<const Trait*> exceptions_of(const SurfaceProfile& surface) {
  std::vector<const Trait*> found;
  for (const Trait& trait : surface.findings.traits)
    if (trait.rate.agreeing < trait.rate.of) found.push_back(&trait);
  std::ranges::stable_sort(found, {}, [](const Trait* trait) { return told(*trait).rate.share(); });
  return found;
}

void summarize_traits(Buffer& out, const SurfaceProfile& surface) {
  constexpr std::size_t kMostNamed = 3;
  const auto exceptions = exceptions_of(surface);
  const std::vector<Trait>& traits = surface.findings.traits;
  const auto asked = static_cast<std::size_t>(std::ranges::count_if(traits, &Trait::is_asked));
  const auto undecided = std::ranges::count_if(
      traits, [](const Trait& trait) { return trait.is_asked() && trait.is_undecided(); });
  print(out, "{}: {} of {} traits that were asked hold in every scene", name_of(surface.surface),
        asked - exceptions.size(), asked);
  if (asked < traits.size()) print(out, "; {} could not be asked", traits.size() - asked);
  if (undecided > 0) print(out, "; for {} another alternative is as good", undecided);
  print(out, "\n  least followed: ");
  if (exceptions.empty()) print(out, "none");
  for (std::size_t i = 0; i < std::min(kMostNamed, exceptions.size()); ++i) {
    const auto& [alternative, rate] = told(*exceptions[i]);
    print(out, "{}{} {} ({})", i == 0 ? "" : ", ", text_of(exceptions[i]->id), alternative,
          percent(rate));
  }
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

// The alternatives of the rules that decide coverage, on the first surface that was measured.
void summarize_coverage(Buffer& out, const Profile& profile) {
  const auto measured = std::ranges::find_if(
      profile.surfaces, [](const SurfaceProfile& surface) { return surface.unavailable.empty(); });
  if (measured == profile.surfaces.end()) return;
  std::string text;
  for (const RuleId rule :
       {RuleId::point_ownership, RuleId::line_algorithm, RuleId::triangle_algorithm,
        RuleId::triangle_fill_rule, RuleId::triangle_snap}) {
    const auto& traits = measured->findings.traits;
    const auto trait = std::ranges::find(traits, TraitId(rule), &Trait::id);
    if (trait == traits.end() || !trait->is_asked()) continue;
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : ", ", name_of(rule), told(*trait).alternative);
  }
  if (!text.empty()) print(out, "coverage: {}\n", text);
}

}  // namespace

void print_renderer(Buffer& out, const Profile& profile) {
  print(out, "{}: {}, {}\n", profile.renderer.name, profile.renderer.device,
        profile.renderer.version);
}

ToldTrait told(const Trait& trait) {
  if (trait.alternative == kNoneFits)
    return 10 * trait.runner_up_rate.agreeing >= 9 * trait.runner_up_rate.of
               ? ToldTrait{trait.runner_up, trait.runner_up_rate}
               : ToldTrait{kNoneKnown, trait.runner_up_rate};
  const std::vector<std::string> names =
      trait.id.is_rule() ? names_of_alternatives(trait.id.rule) : std::vector<std::string>();
  const bool is_alternative = std::ranges::find(names, trait.alternative) != names.end();
  const bool is_rare = 10 * trait.rate.agreeing < 9 * trait.rate.of;
  return {is_alternative && is_rare ? kNoneKnown : trait.alternative, trait.rate};
}

std::string words_of_bits(const RendererInfo& renderer) {
  constexpr int kAssumed = 4;
  if (renderer.subpixel_bits == kAssumed)
    return "4 sub-pixel bits are reported, or assumed as nothing is";
  return counted(static_cast<std::size_t>(std::max(0, renderer.subpixel_bits)), "sub-pixel bit is",
                 "sub-pixel bits are") +
         " reported";
}

std::string profile_summary(const Profile& profile) {
  Buffer out;
  print_renderer(out, profile);
  std::size_t scenes = 0;
  for (const SurfaceProfile& surface : profile.surfaces) scenes += surface.findings.drawn.scenes;
  print(out, "{} drawn, seed {}; {}\n", counted(scenes, "scene", "scenes"), profile.seed,
        words_of_bits(profile.renderer));
  for (const SurfaceProfile& surface : profile.surfaces) summarize_surface(out, surface);
  summarize_coverage(out, profile);
  return fmt::to_string(out);
}

}  // namespace edgecase
