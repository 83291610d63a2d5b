// SPDX-License-Identifier: MIT
#include "wire/texture_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace edgecase::wire {

using nlohmann::json;

namespace {

constexpr int kMaxCode = 255;
constexpr int kMaxBaseLevel = 10;

void write_texel(Output out, float value) {
  const bool is_code = value >= 0 && value <= static_cast<float>(kMaxCode) &&
                       value == std::trunc(value) && !std::signbit(value);
  if (is_code) {
    const fmt::format_int digits(static_cast<int>(value));
    std::copy(digits.data(), digits.data() + digits.size(), out);
  } else if (!write_not_finite(out, static_cast<double>(value))) {
    write_number(out, static_cast<double>(value));
  }
}

void write_numbers(Output out, const std::array<float, 2>& pair) {
  *out++ = '[';
  write_number(out, static_cast<double>(pair[0]));
  *out++ = ',';
  write_number(out, static_cast<double>(pair[1]));
  *out++ = ']';
}

void write_lookup(Output out, const Lookup& lookup) {
  fmt::format_to(out, R"({{"kind":"{}")", name_of(lookup.kind));
  if (lookup.kind == LookupKind::bias || lookup.kind == LookupKind::lod) {
    fmt::format_to(out, R"(,"value":)");
    write_number(out, static_cast<double>(lookup.value));
  } else if (lookup.kind == LookupKind::gradients) {
    fmt::format_to(out, R"(,"dx":)");
    write_numbers(out, lookup.dx);
    fmt::format_to(out, R"(,"dy":)");
    write_numbers(out, lookup.dy);
  }
  *out++ = '}';
}

// How a number of a texel is read: what the format holds, and what may stand there.
using ReadTexel = float (*)(const json& value, const Path& path);

float read_code(const json& value, const Path& path) {
  return static_cast<float>(read_integer(value, path, 0, kMaxCode));
}

float read_generated_float32(const json& value, const Path& path) {
  return value.is_string() ? static_cast<float>(read_number(value, path))
                           : read_any_float32(value, path);
}

constexpr std::size_t kComponents = 4;

// A level of one colour is told by one texel.
std::vector<float> repeated(const json& texel, const Path& path, const TextureLevel& level,
                            ReadTexel read_texel) {
  require_array(texel, path, kComponents);
  std::vector<float> texels(level.index(0, level.height));
  for (std::size_t c = 0; c < kComponents; ++c) {
    const float component = read_texel(texel[c], {path, c});
    for (std::size_t i = c; i < texels.size(); i += kComponents) texels[i] = component;
  }
  return texels;
}

TextureLevel read_level(const json& value, const Path& path, ReadTexel read_texel) {
  require_object(value, path, {"width", "height", "texels", "texel"});
  TextureLevel level;
  level.width = read_int(member(value, path, "width"), {path, "width"}, 1, kMaxTextureSize);
  level.height = read_int(member(value, path, "height"), {path, "height"}, 1, kMaxTextureSize);
  if (const json* texel = optional_member(value, "texel")) {
    if (value.contains("texels")) throw Refusal(path.text() + " has both \"texel\" and \"texels\"");
    level.texels = repeated(*texel, {path, "texel"}, level, read_texel);
    return level;
  }
  const json& texels = member(value, path, "texels");
  const Path at(path, "texels");
  require_array(texels, at, level.index(0, level.height));
  level.texels.reserve(texels.size());
  for (std::size_t i = 0; i < texels.size(); ++i)
    level.texels.push_back(read_texel(texels[i], {at, i}));
  return level;
}

std::vector<TextureLevel> read_levels(const json& value, const Path& path, ReadTexel read_texel) {
  require_array(value, path, value.size());
  if (value.empty()) throw Refusal(path.text() + " must have an element");
  std::vector<TextureLevel> levels;
  for (std::size_t i = 0; i < value.size(); ++i)
    levels.push_back(read_level(value[i], {path, i}, read_texel));
  return levels;
}

int whole_chain(const Texture& texture) {
  return level_count(texture.levels[0].width, texture.levels[0].height);
}

// One level, or a whole chain of the right sizes.
void check_levels(const Texture& texture, const Path& path) {
  const TextureLevel& base = texture.levels[0];
  if (texture.dimensions == 1 && base.height != 1)
    throw Refusal(fmt::format("{}/0/height is {}, but a one-dimensional texture has 1", path.text(),
                              base.height));
  const std::size_t count = texture.levels.size();
  const auto whole = static_cast<std::size_t>(whole_chain(texture));
  if (texture.generated && count != 1)
    throw Refusal(
        fmt::format("{} has {} levels, but generated ones are not given", path.text(), count));
  if (count != 1 && count != whole)
    throw Refusal(
        fmt::format("{} has {} levels, but a whole chain has {}", path.text(), count, whole));
  for (std::size_t i = 1; i < count; ++i) {
    const TextureLevel& level = texture.levels[i];
    const int width = level_size(base.width, static_cast<int>(i));
    const int height = level_size(base.height, static_cast<int>(i));
    if (level.width != width || level.height != height)
      throw Refusal(fmt::format("{}/{} is {}x{}, but this level must be {}x{}", path.text(), i,
                                level.width, level.height, width, height));
  }
}

std::array<float, 2> read_pair(const json& value, const Path& path) {
  require_array(value, path, 2);
  return {read_any_float32(value[0], {path, std::size_t{0}}),
          read_any_float32(value[1], {path, std::size_t{1}})};
}

Lookup read_lookup(const json& value, const Path& path) {
  require_object(value, path, {"kind", "value", "dx", "dy"});
  Lookup lookup;
  lookup.kind = read_name<LookupKind>(value, path, "kind");
  const auto find = [&](const char* key, bool is_known) -> const json* {
    if (is_known) return &member(value, path, key);
    if (value.contains(key))
      throw Refusal(fmt::format("{} has \"{}\", which a lookup of kind \"{}\" does not take",
                                path.text(), key, name_of(lookup.kind)));
    return nullptr;
  };
  const bool has_value = lookup.kind == LookupKind::bias || lookup.kind == LookupKind::lod;
  const bool has_gradients = lookup.kind == LookupKind::gradients;
  if (const json* number = find("value", has_value))
    lookup.value = read_any_float32(*number, {path, "value"});
  if (const json* dx = find("dx", has_gradients)) lookup.dx = read_pair(*dx, {path, "dx"});
  if (const json* dy = find("dy", has_gradients)) lookup.dy = read_pair(*dy, {path, "dy"});
  return lookup;
}

// What does not depend on the texture.
Sampler read_sampler(const json& value, const Path& path) {
  const auto number = [&](const char* key) {
    return read_any_float32(member(value, path, key), {path, key});
  };
  const auto integer = [&](const char* key, int low, int high) {
    return read_int(member(value, path, key), {path, key}, low, high);
  };
  Sampler sampler;
  sampler.magnify = read_name<Filter>(value, path, "magnify");
  sampler.minify = read_name<Filter>(value, path, "minify");
  sampler.mipmap = read_name<MipFilter>(value, path, "mipmap");
  sampler.lod_bias = read_float32(member(value, path, "lod_bias"), {path, "lod_bias"},
                                  {-kMaxLodBias, kMaxLodBias, "a float32 value of -16 to 16"});
  sampler.min_lod = number("min_lod");
  sampler.max_lod = number("max_lod");
  if (sampler.min_lod > sampler.max_lod)
    throw Refusal(fmt::format("{} has a min_lod of {}, which is more than its max_lod of {}",
                              path.text(), sampler.min_lod, sampler.max_lod));
  sampler.base_level = integer("base_level", 0, kMaxBaseLevel);
  sampler.max_level = integer("max_level", sampler.base_level, std::numeric_limits<int>::max());
  const json& border = member(value, path, "border");
  require_array(border, {path, "border"}, sampler.border.size());
  for (std::size_t i = 0; i < sampler.border.size(); ++i)
    sampler.border[i] = read_any_float32(border[i], {{path, "border"}, i});
  sampler.max_anisotropy =
      read_float32(member(value, path, "max_anisotropy"), {path, "max_anisotropy"},
                   {1, kMaxAnisotropy, "a float32 value of 1 to 16"});
  return sampler;
}

std::array<Wrap, 2> read_wrap(const json& value, const Path& path) {
  require_array(value, path, 2);
  return {read_name<Wrap>(value[0], {path, std::size_t{0}}),
          read_name<Wrap>(value[1], {path, std::size_t{1}})};
}

void check_sampler(const Sampler& sampler, const Texture& texture, const Path& path) {
  const int whole = whole_chain(texture);
  const int count = texture.generated ? whole : static_cast<int>(texture.levels.size());
  if (sampler.mipmap != MipFilter::none && count < whole)
    throw Refusal(
        fmt::format("{} looks up levels, but its texture has 1 of {}", path.text(), whole));
  if (sampler.base_level >= count)
    throw Refusal(fmt::format("{}/base_level is {}, but the texture's last level is {}",
                              path.text(), sampler.base_level, count - 1));
}

}  // namespace

// Has it more than one texel, all of them the same to the bit?
bool is_uniform(const TextureLevel& level) {
  if (level.texels.size() <= kComponents) return false;
  for (std::size_t i = kComponents; i < level.texels.size(); ++i)
    if (std::bit_cast<std::uint32_t>(level.texels[i]) !=
        std::bit_cast<std::uint32_t>(level.texels[i - kComponents]))
      return false;
  return true;
}

void write_level(Output out, const TextureLevel& level) {
  const bool uniform = is_uniform(level);
  fmt::format_to(out, R"({{"width":{},"height":{},"{}":[)", level.width, level.height,
                 uniform ? "texel" : "texels");
  for (std::size_t i = 0; i < (uniform ? kComponents : level.texels.size()); ++i) {
    if (i > 0) *out++ = ',';
    write_texel(out, level.texels[i]);
  }
  *out++ = ']';
  *out++ = '}';
}

void write_texture(Output out, const Texture& texture) {
  fmt::format_to(out, R"({{"dimensions":{},"format":"{}","levels":[)", texture.dimensions,
                 name_of(texture.format));
  for (std::size_t i = 0; i < texture.levels.size(); ++i) {
    if (i > 0) *out++ = ',';
    write_level(out, texture.levels[i]);
  }
  fmt::format_to(out, R"(],"generated":{}}})", texture.generated);
}

void write_texture_use(Output out, const TextureUse& use) {
  const Sampler& sampler = use.sampler;
  const auto number = [&](const char* key, float value) {
    fmt::format_to(out, R"(,"{}":)", key);
    write_number(out, static_cast<double>(value));
  };
  fmt::format_to(out, R"({{"texture":{},"wrap":["{}","{}"],"magnify":"{}","minify":"{}")",
                 use.texture, name_of(sampler.wrap[0]), name_of(sampler.wrap[1]),
                 name_of(sampler.magnify), name_of(sampler.minify));
  fmt::format_to(out, R"(,"mipmap":"{}")", name_of(sampler.mipmap));
  number("lod_bias", sampler.lod_bias);
  number("min_lod", sampler.min_lod);
  number("max_lod", sampler.max_lod);
  fmt::format_to(out, R"(,"base_level":{},"max_level":{},"border":)", sampler.base_level,
                 sampler.max_level);
  write_color(out, sampler.border);
  number("max_anisotropy", sampler.max_anisotropy);
  fmt::format_to(out, R"(,"lookup":)");
  write_lookup(out, use.lookup);
  *out++ = '}';
}

Texture read_texture(const json& value, const Path& path) {
  require_object(value, path, {"dimensions", "format", "levels", "generated"});
  Texture texture;
  texture.dimensions = read_int(member(value, path, "dimensions"), {path, "dimensions"}, 1, 2);
  texture.format = read_name<TextureFormat>(value, path, "format");
  texture.generated = read_bool(member(value, path, "generated"), {path, "generated"});
  const Path at(path, "levels");
  texture.levels =
      read_levels(member(value, path, "levels"), at,
                  texture.format == TextureFormat::rgba32f ? read_any_float32 : read_code);
  check_levels(texture, at);
  return texture;
}

TextureUse read_texture_use(const json& value, const Path& path, const Scene& scene) {
  require_object(value, path,
                 {"texture", "wrap", "magnify", "minify", "mipmap", "lod_bias", "min_lod",
                  "max_lod", "base_level", "max_level", "border", "max_anisotropy", "lookup"});
  if (scene.textures.empty())
    throw Refusal(path.text() + " is there, but the scene has no textures");
  TextureUse use;
  use.texture =
      static_cast<std::size_t>(read_integer(member(value, path, "texture"), {path, "texture"}, 0,
                                            static_cast<std::int64_t>(scene.textures.size()) - 1));
  use.sampler = read_sampler(value, path);
  use.sampler.wrap = read_wrap(member(value, path, "wrap"), {path, "wrap"});
  check_sampler(use.sampler, *scene.textures[use.texture], path);
  use.lookup = read_lookup(member(value, path, "lookup"), {path, "lookup"});
  return use;
}

std::map<std::size_t, std::vector<TextureLevel>> read_mip_chains(const json& value,
                                                                 const Path& path,
                                                                 const Scene& scene) {
  if (!value.is_object()) throw Refusal(path.text() + " must be an object of arrays");
  std::map<std::size_t, std::vector<TextureLevel>> chains;
  for (const auto& [key, levels] : value.items()) {
    std::size_t number = scene.textures.size();
    std::from_chars(key.data(), key.data() + key.size(), number);
    if (number >= scene.textures.size() || std::to_string(number) != key)
      throw Refusal(fmt::format("{} has the key \"{}\", which is no number of a texture",
                                path.text(), excerpt(key, 40)));
    const Texture& texture = *scene.textures[number];
    const Path at(path, key.c_str());
    if (!texture.generated)
      throw Refusal(at.text() + " is there, but the request gives this texture's levels");
    chains[number] = read_levels(
        levels, at, texture.format == TextureFormat::rgba32f ? read_generated_float32 : read_code);
  }
  return chains;
}

}  // namespace edgecase::wire
