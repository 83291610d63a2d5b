// SPDX-License-Identifier: MIT
#include "casefile/scene/textures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "casefile/json/numbers.h"
#include "casefile/json/text.h"
#include "casefile/scene/patterns.h"
#include "image/image_file.h"

namespace edgecase {

namespace {

namespace fs = std::filesystem;

const Keys kTextureKeys{{},
                        {"size", "format", "mipmaps", "checker", "gradient", "zone-plate", "levels",
                         "noise", "texels", "file"},
                        {}};
const std::vector<std::string> kSources{"checker", "gradient", "zone-plate", "levels",
                                        "noise",   "texels",   "file"};
const Keys kCheckerKeys{{}, {"cell", "colors"}, {}};
const Keys kGradientKeys{{"colors"}, {}, {}};
const Keys kZonePlateKeys{{}, {}, {}};
const Keys kLevelsKeys{{}, {"colors"}, {}};
const Keys kNoiseKeys{{"seed"}, {}, {}};
constexpr std::uintmax_t kMostFileBytes = std::uintmax_t{64} << 20;

// The properties of a texture that its source needs.
struct Outline {
  TextureFormat format = TextureFormat::rgba8;
  std::optional<PatternSize> size;
  int dimensions = 2;
};

std::string text_of(PatternSize size) {
  return fmt::format("{} x {}", size.width, size.height);
}

void read_size(const Place& place, Findings& findings, Outline& outline) {
  if (!expect_kind(place, JsonKind::array, "a texture's size", findings)) return;
  const std::size_t count = place.node->children.size();
  if (count != 1 && count != 2) {
    findings.add(place, fmt::format("a texture's size has {} numbers", count),
                 "write [width, height], or [width] of a one-dimensional texture");
    return;
  }
  std::array<int, 2> sides{1, 1};
  for (std::size_t i = 0; i < count; ++i) {
    const auto side =
        read_integer(place.child(i), "a texture's size", {1, kMaxTextureSize}, findings);
    if (!side) return;
    sides[i] = *side;
  }
  outline.size = PatternSize{sides[0], sides[1]};
  outline.dimensions = static_cast<int>(count);
}

std::optional<StoredTexel> read_texel(const Place& place, TextureFormat format,
                                      Findings& findings) {
  const bool coded = !holds_floats(format);
  const Float32Range range = coded ? Float32Range{0, 1} : Float32Range{-kMaxTexel, kMaxTexel};
  const auto color = read_color(place, "a texture's colour", range, findings);
  if (!color) return std::nullopt;
  return stored_texel(*color, format);
}

// A list of colours; empty, and a finding, if one is faulty.
std::vector<StoredTexel> read_texels(const Place& place, TextureFormat format, Findings& findings) {
  std::vector<StoredTexel> texels;
  if (!expect_kind(place, JsonKind::array, "a list of colours", findings)) return texels;
  const std::size_t before = findings.size();
  for (std::size_t i = 0; i < place.node->children.size(); ++i)
    texels.push_back(read_texel(place.child(i), format, findings).value_or(StoredTexel{}));
  if (findings.size() != before) texels.clear();
  return texels;
}

// The same for a given number of colours; a fault is reported once.
std::vector<StoredTexel> read_colors(const Place& place, std::span<const std::size_t> counts,
                                     TextureFormat format, Findings& findings) {
  const std::size_t before = findings.size();
  std::vector<StoredTexel> colors = read_texels(place, format, findings);
  if (findings.size() != before) return {};
  if (std::find(counts.begin(), counts.end(), colors.size()) != counts.end()) return colors;
  findings.add(place, fmt::format("a list has {} colours", colors.size()),
               fmt::format("write {}", fmt::join(counts, " or ")));
  return {};
}

using Levels = std::vector<TextureLevel>;

Levels read_checker(const Place& place, const Outline& outline, Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, "a checker", kCheckerKeys, findings);
  int cell = 1;
  if (const auto given = object.find("cell"))
    cell = read_integer(*given, "cell", {1, kMaxTextureSize}, findings).value_or(cell);
  std::vector<StoredTexel> colors{black_texel(outline.format), white_texel(outline.format)};
  constexpr std::size_t kTwo[] = {2};
  if (const auto given = object.find("colors"))
    colors = read_colors(*given, kTwo, outline.format, findings);
  if (findings.size() != before || !outline.size) return {};
  return {checker_image(*outline.size, cell, {colors[0], colors[1]})};
}

Levels read_gradient(const Place& place, const Outline& outline, Findings& findings) {
  const ObjectReader object(place, "a gradient", kGradientKeys, findings);
  const auto given = object.find("colors");
  if (!given) return {};
  constexpr std::size_t kTwoOrFour[] = {2, 4};
  const auto colors = read_colors(*given, kTwoOrFour, outline.format, findings);
  if (colors.empty() || !outline.size) return {};
  const std::size_t upper = colors.size() - 2;  // where the colours of the top row start
  return {gradient_image(*outline.size, {colors[0], colors[1], colors[upper], colors[upper + 1]},
                         outline.format)};
}

Levels read_zone_plate(const Place& place, const Outline& outline, Findings& findings) {
  const ObjectReader object(place, "a zone plate", kZonePlateKeys, findings);
  if (!object.valid() || !outline.size) return {};
  return {zone_plate_image(*outline.size, outline.format)};
}

Levels read_levels(const Place& place, const Outline& outline, Findings& findings) {
  const ObjectReader object(place, "levels", kLevelsKeys, findings);
  if (!object.valid() || !outline.size) return {};
  const int count = level_count(outline.size->width, outline.size->height);
  std::vector<StoredTexel> colors = level_colors(count, outline.format);
  const std::size_t counts[] = {static_cast<std::size_t>(count)};
  if (const auto given = object.find("colors"))
    colors = read_colors(*given, counts, outline.format, findings);
  return flat_levels(*outline.size, colors);
}

Levels read_noise(const Place& place, const Outline& outline, Findings& findings) {
  const ObjectReader object(place, "noise", kNoiseKeys, findings);
  const auto given = object.find("seed");
  if (!given) return {};
  const auto seed = read_integer(*given, "a seed", {0, kMaxNoiseSeed}, findings);
  if (!seed || !outline.size) return {};
  return {noise_image(*outline.size, outline.format, static_cast<std::uint64_t>(*seed))};
}

// Checks that a picture has the size that the file gives, if any.
bool is_sized(const Place& place, PatternSize found, const Outline& outline, Findings& findings) {
  if (!outline.size) return true;
  if (outline.size->width == found.width && outline.size->height == found.height) return true;
  findings.add(place,
               fmt::format("the picture has {} texels, and the texture's size is {}",
                           text_of(found), text_of(*outline.size)),
               "make them equal, or leave the size out");
  return false;
}

// One row of a picture, as wide as the earlier rows of `level`.
bool read_row(const Place& place, TextureFormat format, TextureLevel& level, Findings& findings) {
  const std::size_t before = findings.size();
  const std::vector<StoredTexel> row = read_texels(place, format, findings);
  if (findings.size() != before) return false;
  const auto width = static_cast<int>(std::min(row.size(), std::size_t{kMaxTextureSize} + 1));
  const bool first = level.texels.empty();
  if (width == 0 || width > kMaxTextureSize || (!first && width != level.width)) {
    findings.add(place, fmt::format("a row has {} texels", row.size()),
                 first ? fmt::format("write 1 to {}", kMaxTextureSize)
                       : fmt::format("write {}, as many as the row above has", level.width));
    return false;
  }
  level.width = width;
  for (const StoredTexel& texel : row)
    level.texels.insert(level.texels.end(), texel.begin(), texel.end());
  return true;
}

// A file has the top row first.
TextureLevel turned_over(const TextureLevel& level) {
  TextureLevel result{level.width, level.height, {}};
  for (int j = level.height; j-- > 0;) {
    const auto row = level.texels.begin() + static_cast<std::ptrdiff_t>(level.index(0, j));
    result.texels.insert(result.texels.end(), row, row + std::ptrdiff_t{4} * level.width);
  }
  return result;
}

Levels read_picture(const Place& place, const Outline& outline, Findings& findings) {
  if (!expect_kind(place, JsonKind::array, "texels", findings)) return {};
  const std::size_t count = place.node->children.size();
  if (count == 0 || count > std::size_t{kMaxTextureSize}) {
    findings.add(place, fmt::format("a picture has {} rows", count),
                 fmt::format("write 1 to {}", kMaxTextureSize));
    return {};
  }
  TextureLevel level{0, static_cast<int>(count), {}};
  for (std::size_t i = 0; i < count; ++i)
    if (!read_row(place.child(i), outline.format, level, findings)) return {};
  if (!is_sized(place, {level.width, level.height}, outline, findings)) return {};
  return {turned_over(level)};
}

// Why an image file cannot be a texture of this format; empty if it can.
std::string fault_of(const ImageFile& image, TextureFormat format) {
  if (!holds_floats(format) && image.bits != 8)
    return fmt::format("its components have {} bits, and {} holds 8", image.bits, name_of(format));
  if (!std::all_of(image.rgba.begin(), image.rgba.end(),
                   [](float number) { return std::isfinite(number); }))
    return "it holds numbers that are not finite";
  return "";
}

Levels read_file(const Place& place, const fs::path& case_file, const Outline& outline,
                 Findings& findings) {
  if (!read_text(place, "a file", kPathLimits, findings)) return {};
  const auto path = find_in_suite(case_file, place, "an image file", findings);
  if (!path) return {};
  const auto refuse = [&](const std::string& message, const char* remedy) {
    findings.add(place, fmt::format("{}: {}", quote(place.node->text), message), remedy);
    return Levels{};
  };
  constexpr const char* kRemedy = "name a PNG, TIFF or EXR file of the suite";
  const std::string suffix = path->extension().string();
  if (suffix != ".png" && suffix != ".tif" && suffix != ".exr")
    return refuse("its name ends in none of .png, .tif and .exr", kRemedy);
  std::error_code error;
  if (!fs::exists(*path, error)) return refuse("there is no such file", kRemedy);
  if (!fs::is_regular_file(*path, error)) return refuse("this is no regular file", kRemedy);
  if (const auto bytes = fs::file_size(*path, error); error || bytes > kMostFileBytes)
    return refuse("it is too large", kRemedy);
  ImageFile image = read_image(*path, kMaxTextureSize);
  if (image.error.empty()) image.error = fault_of(image, outline.format);
  if (!image.error.empty())
    return refuse(image.error,
                  "use an image of up to 1024 x 1024 pixels, with 8 bits, or with 16 or floating "
                  "point as \"rgba32f\"");
  const bool scaled = holds_floats(outline.format) && image.bits != 32;
  const float one = image.bits == 8 ? 255.0F : 65535.0F;
  for (float& number : image.rgba) number = (scaled ? number / one : number) + 0.0F;
  if (!is_sized(place, {image.width, image.height}, outline, findings)) return {};
  return {TextureLevel{image.width, image.height, std::move(image.rgba)}};
}

Levels read_source(const Place& place, const fs::path& case_file, const Outline& outline,
                   Findings& findings) {
  const std::string& name = place.node->name;
  if (name == "checker") return read_checker(place, outline, findings);
  if (name == "gradient") return read_gradient(place, outline, findings);
  if (name == "zone-plate") return read_zone_plate(place, outline, findings);
  if (name == "levels") return read_levels(place, outline, findings);
  if (name == "noise") return read_noise(place, outline, findings);
  if (name == "texels") return read_picture(place, outline, findings);
  return read_file(place, case_file, outline, findings);
}

// The member that defines the image.
std::optional<Place> find_source(const Place& place, const ObjectReader& object,
                                 Findings& findings) {
  std::vector<Place> given;
  for (const std::string& name : kSources)
    if (const auto source = object.find(name)) given.push_back(*source);
  if (given.size() == 1) return given.front();
  if (object.valid())
    findings.add(place,
                 given.empty()
                     ? "a texture has no image"
                     : fmt::format("a texture has both {} and {}", quote(given[0].node->name),
                                   quote(given[1].node->name)),
                 "give exactly one of " + join_names(kSources));
  return std::nullopt;
}

std::string read_mipmaps(const ObjectReader& object, bool whole, Findings& findings) {
  const auto place = object.find("mipmaps");
  if (!place) return "none";
  if (whole)
    findings.add(*place, "\"levels\" are a whole chain, and \"mipmaps\" would make another",
                 "remove one of the two");
  return read_choice(*place, "mipmaps", {kMipmaps, {}}, findings).value_or("none");
}

std::optional<Texture> read_texture(const Place& place, const fs::path& case_file,
                                    Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, "a texture", kTextureKeys, findings);
  Outline outline;
  if (const auto format = object.find("format"))
    read_enum(*format, "a texture's format", {names_of<TextureFormat>(), {}}, findings,
              outline.format);
  if (const auto size = object.find("size")) read_size(*size, findings, outline);
  const auto source = find_source(place, object, findings);
  if (!source) return std::nullopt;
  const std::string& name = source->node->name;
  if (name != "texels" && name != "file" && !object.find("size"))
    findings.add(place, "a texture lacks \"size\"", "add \"size\": [width, height]");
  const std::string mipmaps = read_mipmaps(object, name == "levels", findings);
  Levels levels = read_source(*source, case_file, outline, findings);
  if (findings.size() != before) return std::nullopt;
  if (mipmaps == "box") levels = box_chain(std::move(levels.front()), outline.format);
  return Texture{outline.dimensions, outline.format, std::move(levels), mipmaps == "generated"};
}

// A key that is equal exactly for equal trees.
void append_key(const JsonNode& node, std::string& key) {
  key += fmt::format("{}:{}:{}{}:{}{}(", static_cast<int>(node.kind), node.name.size(), node.name,
                     node.text.size(), node.text, node.truth ? '1' : '0');
  for (const JsonNode& child : node.children) append_key(child, key);
  key += ')';
}

}  // namespace

std::shared_ptr<const Texture> TextureShelf::find(const Place& place, Findings& findings) {
  std::string key;
  append_key(*place.node, key);
  if (const auto known = textures_.find(key); known != textures_.end()) return known->second;
  if (texels_ > kMost) {
    findings.add(place,
                 fmt::format("the textures of the file's cases have more than {} texels", kMost),
                 "use smaller textures, or fewer values");
    return nullptr;
  }
  std::optional<Texture> texture = read_texture(place, case_file_, findings);
  if (!texture) return nullptr;
  for (const TextureLevel& level : texture->levels) texels_ += level.texels.size() / 4;
  return textures_[key] = std::make_shared<const Texture>(std::move(*texture));
}

std::optional<TextureList> read_textures(const Place& place, TextureShelf& shelf,
                                         Findings& findings) {
  if (!expect_kind(place, JsonKind::array, "the list of textures", findings)) return std::nullopt;
  const std::size_t count = place.node->children.size();
  if (count == 0 || count > kMaxTextures) {
    findings.add(place, fmt::format("a case has {} textures", count),
                 fmt::format("write 1 to {}, or remove the key", kMaxTextures));
    return std::nullopt;
  }
  TextureList textures;
  for (std::size_t i = 0; i < count; ++i) textures.push_back(shelf.find(place.child(i), findings));
  return textures;
}

}  // namespace edgecase
