// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/gallery_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "casefile/loader.h"
#include "casefile/policy_reader.h"
#include "rules/all_rules.h"
#include "suite/expectation_check.h"
#include "suite/policy_contrast.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

// The case file of an id.
std::string file_id_of(const std::string& id) {
  return id.substr(0, id.find(':'));
}

const Case* find_case(const std::vector<Case>& cases, const std::string& id) {
  const auto found =
      std::find_if(cases.begin(), cases.end(), [&](const Case& one) { return one.id == id; });
  return found == cases.end() ? nullptr : &*found;
}

// Prints that a picture's case does not exist.
void print_unknown_case(const fs::path& file, const std::string& id,
                        const std::vector<Case>& cases) {
  const std::string start = file_id_of(id) + ":";
  for (const Case& one : cases)
    if (one.id.starts_with(start) || one.id == file_id_of(id)) {
      print_error(fmt::format("{}: there is no case {}; its file has others, such as {}",
                              file.string(), id, one.id));
      return;
    }
  print_error(fmt::format("{}: there is no case {}; `edgecase run --list` prints the ids of all",
                          file.string(), id));
}

// The cases of all pictures; prints errors and returns nothing if one is missing.
std::optional<std::vector<Case>> load_cases_of(const Gallery& gallery, const fs::path& file,
                                               const fs::path& suite_folder) {
  std::set<std::string> ids;
  Selection selection;
  for (const GalleryPicture& picture : gallery.pictures) {
    ids.insert(picture.case_id);
    const fs::path path = suite_folder / (file_id_of(picture.case_id) + ".json");
    std::error_code error;
    if (fs::is_regular_file(path, error)) selection.paths.push_back(path);
  }
  Suite suite;
  if (!selection.paths.empty()) suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  const std::vector<Case> loaded = suite.cases.all();
  std::vector<Case> cases;
  bool complete = suite.diagnostics.empty();
  for (const std::string& id : ids) {
    if (const Case* found = find_case(loaded, id)) {
      cases.push_back(*found);
      continue;
    }
    print_unknown_case(file, id, loaded);
    complete = false;
  }
  if (!complete) return std::nullopt;
  return cases;
}

// Checks that the policy chooses each rule that the gallery explains.
bool check_choices(const Gallery& gallery, const Policy& policy, const fs::path& file) {
  bool fine = true;
  for (const auto* words : {&gallery.choices, &gallery.not_shown})
    for (const auto& word : *words) {
      const std::string& rule = word.first;
      const bool chosen =
          policy.rules.contains(rule) ||
          std::any_of(policy.surfaces.begin(), policy.surfaces.end(),
                      [&](const auto& surface) { return surface.second.contains(rule); });
      if (chosen) continue;
      print_error(fmt::format("{}: policy {} chooses no alternative of {}; leave its words out",
                              file.string(), policy.name, rule));
      fine = false;
    }
  return fine;
}

Policy policy_of(const Policy& policy, const GalleryPicture& picture) {
  Policy result = policy;
  for (const auto& [rule, alternative] : picture.rules) {
    result.rules[rule] = alternative;
    for (auto& [surface, choices] : result.surfaces) choices.erase(rule);
  }
  return result;
}

std::string words_at(const std::map<std::string, std::string>& words, const std::string& rule) {
  const auto found = words.find(rule);
  return found == words.end() ? "" : found->second;
}

GalleryChoice choice_of(const Gallery& gallery, const Rule& rule, const std::string& name) {
  const Alternative& chosen = *find_alternative(rule, name);
  GalleryChoice choice{name_of(rule.id),
                       rule.title,
                       words_at(gallery.choices, name_of(rule.id)),
                       name,
                       chosen.meaning,
                       "",
                       "",
                       name_of(chosen.openness),
                       words_at(gallery.not_shown, name_of(rule.id))};
  if (name == rule.standard) return choice;
  choice.standard = rule.standard;
  choice.standard_meaning = find_alternative(rule, rule.standard)->meaning;
  return choice;
}

std::vector<GalleryChoice> choices_of(const LoadedPictures& loaded) {
  std::vector<GalleryChoice> choices;
  for (const Rule& rule : all_rules())
    if (const auto chosen = loaded.policy.rules.find(name_of(rule.id));
        chosen != loaded.policy.rules.end())
      choices.push_back(choice_of(loaded.gallery, rule, chosen->second));
  return choices;
}

GalleryImage image_of(const Rendering& rendering) {
  return {rendering.pixels, hits_of(rendering)};
}

GalleryEntry entry_of(const GalleryPicture& picture, const Case& one, const Policy& policy,
                      const CaseResults& results) {
  const Result& result = results.results.front();
  const PolicyContrast contrast =
      contrast_with_opengl(one.scene, policy_of(policy, picture), result.samples.positions);
  GalleryEntry entry;
  entry.case_id = one.id;
  entry.heading = picture.heading;
  entry.text = picture.text;
  entry.origin = one.title;
  for (const auto& [rule, alternative] : picture.rules)
    entry.otherwise.push_back(rule + "=" + alternative);
  entry.width = one.scene.target.width;
  entry.height = one.scene.target.height;
  entry.figure = results.figure;
  entry.policy = image_of(contrast.under_policy);
  entry.opengl = image_of(contrast.under_opengl);
  entry.rendered.pixels = result.pixels->bytes();
  entry.verdict = result.verdict;
  if (result.failure)
    entry.failure = fmt::format("{}: {}", name_of(result.failure->kind), result.failure->reason);
  entry.alone = contrast.alone;
  entry.together = contrast.together;
  return entry;
}

}  // namespace

std::optional<LoadedPictures> load_pictures(const fs::path& file, const fs::path& suite) {
  if (leads_out_of_suite(file)) {
    print_error(fmt::format("{}: {}; {}", file.string(), kLeadsOut, kLeadsOutRemedy));
    return std::nullopt;
  }
  LoadedGallery read = load_gallery(file, known_rules());
  print_diagnostics(read.diagnostics);
  if (!read.value) return std::nullopt;
  Selection selection;
  selection.paths = {suite};
  PolicyOptions options;
  options.policy = read.value->policy;
  auto policy = options.load(selection);
  if (!policy || !check_choices(*read.value, *policy, file)) return std::nullopt;
  auto cases = load_cases_of(*read.value, file, suite);
  if (!cases) return std::nullopt;
  return LoadedPictures{file.stem().string(), std::move(*read.value), std::move(*policy),
                        std::move(*cases)};
}

GalleryPage gallery_page(const LoadedPictures& loaded, const Results& results) {
  const RendererInfo& renderer = results.renderers.front();
  GalleryPage page;
  page.tool = results.tool;
  page.title = loaded.gallery.title;
  page.about = loaded.gallery.about;
  page.policy = loaded.policy.name;
  page.renderer = renderer.device.empty() ? renderer.name
                                          : fmt::format("{} ({})", renderer.name, renderer.device);
  page.sources = loaded.gallery.sources;
  page.choices = choices_of(loaded);
  for (const GalleryPicture& picture : loaded.gallery.pictures)
    page.entries.push_back(entry_of(picture, *find_case(loaded.cases, picture.case_id),
                                    loaded.policy,
                                    results.cases[results.cases.find(picture.case_id).value()]));
  return page;
}

}  // namespace edgecase
