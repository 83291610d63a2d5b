// SPDX-License-Identifier: MIT
#include "casefile/gallery_reader.h"

#include <fmt/format.h>

#include <utility>

#include "casefile/json/fields.h"
#include "casefile/json/text.h"
#include "casefile/json/text_file.h"

namespace edgecase {
namespace {

const Keys kGalleryKeys{
    {"title", "policy", "pictures"}, {"$schema", "about", "sources", "choices", "not_shown"}, {}};
const Keys kPictureKeys{{"case", "heading"}, {"text", "rules"}, {}};
constexpr TextLimits kLine{1, 200};
constexpr TextLimits kWords{1, 2000};
constexpr std::size_t kMostPictures = 100;

std::string text_of(const ObjectReader& object, const char* key, const std::string& what,
                    TextLimits limits, Findings& findings) {
  const auto place = object.find(key);
  return place ? read_text(*place, what, limits, findings).value_or("") : "";
}

std::map<std::string, std::string> read_words(const Place& place, std::span<const KnownRule> known,
                                              Findings& findings) {
  std::map<std::string, std::string> words;
  if (!expect_kind(place, JsonKind::object, "words on rules", findings)) return words;
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place item = place.child(i);
    const auto text = read_text(item, "what is said of a rule", kWords, findings);
    if (check_rule_id(item, known, findings) && text && !item.node->duplicate)
      words[item.node->name] = *text;
  }
  return words;
}

std::vector<std::string> read_sources(const Place& place, Findings& findings) {
  std::vector<std::string> sources;
  if (!expect_kind(place, JsonKind::array, "sources", findings)) return sources;
  for (std::size_t i = 0; i < place.node->children.size(); ++i)
    if (auto source = read_text(place.child(i), "a source", {1, 500}, findings))
      sources.push_back(std::move(*source));
  return sources;
}

GalleryPicture read_picture(const Place& place, std::span<const KnownRule> known,
                            Findings& findings) {
  GalleryPicture picture;
  const ObjectReader object(place, "a picture", kPictureKeys, findings);
  picture.case_id = text_of(object, "case", "a case's id", {1, 500}, findings);
  picture.heading = text_of(object, "heading", "a heading", kLine, findings);
  picture.text = text_of(object, "text", "a picture's text", kWords, findings);
  if (const auto rules = object.find("rules"))
    picture.rules = read_choices(*rules, known, findings);
  return picture;
}

std::vector<GalleryPicture> read_pictures(const Place& place, std::span<const KnownRule> known,
                                          Findings& findings) {
  std::vector<GalleryPicture> pictures;
  if (!expect_kind(place, JsonKind::array, "pictures", findings)) return pictures;
  const std::size_t count = place.node->children.size();
  if (count == 0 || count > kMostPictures) {
    findings.add(place, fmt::format("a gallery cannot have {} pictures", count),
                 fmt::format("give 1 to {}", kMostPictures));
    return pictures;
  }
  for (std::size_t i = 0; i < count; ++i)
    pictures.push_back(read_picture(place.child(i), known, findings));
  return pictures;
}

Gallery read_gallery(const JsonNode& root, std::span<const KnownRule> known, Findings& findings) {
  Gallery gallery;
  const ObjectReader object({&root, ""}, "a gallery", kGalleryKeys, findings);
  text_of(object, "$schema", "$schema", {}, findings);
  gallery.title = text_of(object, "title", "a gallery's title", kLine, findings);
  gallery.about = text_of(object, "about", "about", kWords, findings);
  gallery.policy = text_of(object, "policy", "a policy's name", {1, 100}, findings);
  if (const auto place = object.find("sources")) gallery.sources = read_sources(*place, findings);
  if (const auto place = object.find("choices"))
    gallery.choices = read_words(*place, known, findings);
  if (const auto place = object.find("not_shown"))
    gallery.not_shown = read_words(*place, known, findings);
  if (const auto place = object.find("pictures"))
    gallery.pictures = read_pictures(*place, known, findings);
  return gallery;
}

}  // namespace

LoadedGallery load_gallery(const std::filesystem::path& file, std::span<const KnownRule> known) {
  TextFile read = read_text_file(file, kMaxFileBytes);
  if (read.text) return load_gallery_text(*read.text, file, known);
  LoadedGallery loaded;
  loaded.diagnostics.push_back(
      {file.generic_string(), 0, "", std::move(read.message), std::move(read.remedy)});
  return loaded;
}

LoadedGallery load_gallery_text(const std::string& text, const std::filesystem::path& file,
                                std::span<const KnownRule> known) {
  Findings findings(file.generic_string());
  JsonDocument document = parse_json(text, findings.file());
  for (Diagnostic& diagnostic : document.diagnostics) findings.add(std::move(diagnostic));
  Gallery gallery;
  if (document.root) gallery = read_gallery(*document.root, known, findings);
  LoadedGallery loaded;
  loaded.diagnostics = findings.take();
  if (loaded.diagnostics.empty()) loaded.value = std::move(gallery);
  return loaded;
}

}  // namespace edgecase
