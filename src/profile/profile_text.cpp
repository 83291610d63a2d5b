// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "model/text.h"
#include "profile/profile.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;
using Buffer = fmt::memory_buffer;

template <class... Args>
void print(Buffer& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

// How many answers speak for each alternative, most first.
std::vector<std::pair<std::string, std::size_t>> ranked(const RuleAnswers& answers) {
  auto names = names_spoken_for(answers);
  std::ranges::stable_sort(names, std::ranges::greater(),
                           [](const auto& one) { return one.second; });
  return names;
}

std::string answers_for(const RuleAnswers& answers, std::size_t count) {
  return fmt::format("{} of {}", count, answers.asked);
}

// "left-bottom (48 of 48)", "none known (12 of 18 for sampler-nearest-8)".
std::string told(const RuleAnswers& answers) {
  const auto names = ranked(answers);
  const std::string remaining = remaining_of(answers);
  if (names.empty()) return fmt::format("{} (0 of {})", remaining, answers.asked);
  const auto& [name, count] = names.front();
  if (remaining != kNoneKnown)
    return fmt::format("{} ({})", remaining, answers_for(answers, count));
  return fmt::format("{} ({} for {})", remaining, answers_for(answers, count), name);
}

std::vector<const RuleAnswers*> unknown_of(const SurfaceProfile& surface) {
  std::vector<const RuleAnswers*> unknown;
  for (const RuleAnswers& answers : surface.rules)
    if (remaining_of(answers) == kNoneKnown) unknown.push_back(&answers);
  return unknown;
}

void summarize_surface(Buffer& out, const SurfaceProfile& surface) {
  const char* const name = name_of(surface.surface);
  if (surface.drawn == 0) {
    print(out, "{}: not measured: {}\n", name, surface.refusal);
    return;
  }
  const auto unknown = unknown_of(surface);
  print(out, "{}: {} were asked; {} of {} drawings are as the policy that was found has them", name,
        counted(surface.rules.size(), "rule", "rules"), surface.as_told, surface.drawn);
  if (surface.drawn < surface.cases)
    print(out, "; {} not drawn, the first: {}",
          counted(surface.cases - surface.drawn, "case was", "cases were"), surface.refusal);
  print(out, "\n  no alternative known: ");
  constexpr std::size_t kMostNamed = 4;
  for (std::size_t i = 0; i < std::min(unknown.size(), kMostNamed); ++i)
    print(out, "{}{} ({})", i == 0 ? "" : ", ", name_of(unknown[i]->rule),
          answers_for(*unknown[i],
                      ranked(*unknown[i]).empty() ? 0 : ranked(*unknown[i]).front().second));
  if (unknown.size() > kMostNamed) print(out, " and {} more", unknown.size() - kMostNamed);
  print(out, "{}\n", unknown.empty() ? "for no rule" : "");
}

// The alternatives of the rules that decide coverage, on the first surface that was measured.
void summarize_coverage(Buffer& out, const Profile& profile) {
  const auto measured = std::ranges::find_if(
      profile.surfaces, [](const SurfaceProfile& surface) { return surface.drawn > 0; });
  if (measured == profile.surfaces.end()) return;
  std::vector<std::string> words;
  for (const RuleId rule :
       {RuleId::point_ownership, RuleId::line_algorithm, RuleId::triangle_algorithm,
        RuleId::triangle_fill_rule, RuleId::triangle_snap}) {
    const auto found = std::ranges::find(measured->rules, rule, &RuleAnswers::rule);
    if (found != measured->rules.end())
      words.push_back(fmt::format("{} {}", name_of(rule), remaining_of(*found)));
  }
  if (!words.empty()) print(out, "coverage: {}\n", fmt::join(words, ", "));
}

std::string words_of_bits(const RendererInfo& renderer) {
  constexpr int kAssumed = 4;
  if (renderer.subpixel_bits == kAssumed)
    return "4 sub-pixel bits are reported, or assumed as nothing is";
  return counted(static_cast<std::size_t>(std::max(0, renderer.subpixel_bits)), "sub-pixel bit is",
                 "sub-pixel bits are") +
         " reported";
}

std::size_t cases_of(const Profile& profile) {
  std::size_t cases = 0;
  for (const SurfaceProfile& surface : profile.surfaces) cases += surface.cases;
  return cases;
}

// What else was spoken for: "left-top 30, closed 12".
std::string others_of(const RuleAnswers& answers) {
  constexpr std::size_t kMostNamed = 3;
  const auto names = ranked(answers);
  std::vector<std::string> words;
  for (const auto& [name, count] : names)
    if (count < names.front().second && words.size() < kMostNamed)
      words.push_back(fmt::format("{} {}", name, count));
  return fmt::format("{}", fmt::join(words, ", "));
}

void print_rule(Buffer& out, const SurfaceProfile& surface, const RuleAnswers& answers) {
  print(out, "  {:<28} {}", name_of(answers.rule), told(answers));
  if (const std::string others = others_of(answers); !others.empty()) print(out, "; {}", others);
  print(out, "\n");
  if (remaining_of(answers) != kNoneKnown) return;
  for (const auto& [folder, rules] : surface.by_folder)
    if (const auto own = std::ranges::find(rules, answers.rule, &RuleAnswers::rule);
        own != rules.end())
      print(out, "    {:<26} {}\n", folder, told(*own));
}

std::string why_of(const Profile& profile) {
  std::vector<std::string> parts;
  for (const SurfaceProfile& surface : profile.surfaces) {
    std::string part =
        fmt::format("{}: {} of {}", name_of(surface.surface), surface.as_told, surface.drawn);
    std::vector<std::string> unknown;
    for (const RuleAnswers* answers : unknown_of(surface))
      unknown.push_back(fmt::format("{} {}", name_of(answers->rule), told(*answers)));
    if (!unknown.empty()) part += fmt::format(" ({})", fmt::join(unknown, ", "));
    parts.push_back(std::move(part));
  }
  return fmt::format("Measured by edgecase profile with {}. Drawings that are as it has them: {}.",
                     counted(cases_of(profile), "case", "cases"), fmt::join(parts, "; "));
}

Json to_json(const Policy& policy, const std::string& why) {
  Json json = {
      {"name", policy.name}, {"why", why}, {"latitude", "opengl"}, {"rules", policy.rules}};
  for (const auto& [surface, choices] : policy.surfaces)
    json["surfaces"][name_of(surface)] = choices;
  return json;
}

Json to_json(const SurfaceProfile& surface) {
  Json json = {{"surface", name_of(surface.surface)},
               {"cases", surface.cases},
               {"drawn", surface.drawn},
               {"as_told", surface.as_told}};
  if (!surface.refusal.empty()) json["refusal"] = surface.refusal;
  json["rules"] = surface.rules;
  json["by_folder"] = surface.by_folder;
  return json;
}

// Bytes of names and messages that are not UTF-8 are replaced, never fatal.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string profile_summary(const Profile& profile) {
  Buffer out;
  const RendererInfo& renderer = profile.renderer;
  print(out, "{}: {}, {}\n", renderer.name, renderer.device, renderer.version);
  print(out, "{} asked, in {}; {}\n", counted(cases_of(profile), "case", "cases"),
        counted(profile.rounds, "round", "rounds"), words_of_bits(renderer));
  for (const SurfaceProfile& surface : profile.surfaces) summarize_surface(out, surface);
  summarize_coverage(out, profile);
  return fmt::to_string(out);
}

std::string profile_tables(const Profile& profile) {
  Buffer out;
  for (const SurfaceProfile& surface : profile.surfaces) {
    print(out, "{}: rule, what is followed, and how many of the answers that were asked say so\n",
          name_of(surface.surface));
    for (const RuleAnswers& answers : surface.rules) print_rule(out, surface, answers);
    print(out, "\n");
  }
  return fmt::to_string(out);
}

std::string profile_json(const Profile& profile, const std::string& tool) {
  const RendererInfo& info = profile.renderer;
  Json json = {{"tool", tool},
               {"renderer",
                {{"name", info.name},
                 {"vendor", info.vendor},
                 {"version", info.version},
                 {"device", info.device},
                 {"subpixel_bits", info.subpixel_bits}}},
               {"rounds", profile.rounds},
               {"policy", to_json(profile.policy, why_of(profile))},
               {"surfaces", Json::array()}};
  for (const SurfaceProfile& surface : profile.surfaces)
    json["surfaces"].push_back(to_json(surface));
  return text_of(json);
}

std::string policy_text(const Profile& profile) {
  return text_of(to_json(profile.policy, why_of(profile)));
}

}  // namespace edgecase
