// SPDX-License-Identifier: MIT
#include "wire/texture_levels.h"

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

// How a number of a texel is read: what the format holds, and what may stand there.
using ReadTexel = float (*)(const json& value, const Path& path);

float read_code(const json& value, const Path& path) {
  return static_cast<float>(read_integer(value, path, 0, kMaxCode));
}

float read_generated_float32(const json& value, const Path& path) {
  return value.is_string() ? static_cast<float>(read_number(value, path))
                           : read_float32(value, path);
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

float read_any_float32(const json& value, const Path& path) {
  return read_float32(value, path);
}

// Has it more than one texel, all of them the same to the bit?
bool is_uniform(const TextureLevel& level) {
  if (level.texels.size() <= kComponents) return false;
  for (std::size_t i = kComponents; i < level.texels.size(); ++i)
    if (std::bit_cast<std::uint32_t>(level.texels[i]) !=
        std::bit_cast<std::uint32_t>(level.texels[i - kComponents]))
      return false;
  return true;
}

}  // namespace

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

std::vector<TextureLevel> read_levels(const json& value, const Path& path, TextureFormat format) {
  return read_levels(value, path, format == TextureFormat::rgba32f ? read_any_float32 : read_code);
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
