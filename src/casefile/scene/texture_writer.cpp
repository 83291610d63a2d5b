// SPDX-License-Identifier: MIT
#include "casefile/scene/textures.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "casefile/json/numbers.h"
#include "casefile/scene/patterns.h"

namespace edgecase {

namespace {

constexpr std::size_t kFewTexels = 16;  // written one by one, whatever they show

PatternSize size_of(const TextureLevel& level) {
  return {level.width, level.height};
}

StoredTexel texel_of(const TextureLevel& level, int i, int j) {
  StoredTexel texel{};
  std::copy_n(level.texels.begin() + static_cast<std::ptrdiff_t>(level.index(i, j)), texel.size(),
              texel.begin());
  return texel;
}

JsonPiece texel_piece(StoredTexel texel, TextureFormat format) {
  if (format != TextureFormat::rgba32f)
    for (float& number : texel) number /= 255;
  return color_piece(texel);
}

JsonPiece texels_piece(std::span<const StoredTexel> texels, TextureFormat format) {
  Pieces items;
  for (const StoredTexel& texel : texels) items.push_back(texel_piece(texel, format));
  JsonPiece list = json_array(std::move(items));
  list.together = 4;
  return list;
}

JsonPiece colors_object(std::span<const StoredTexel> colors, TextureFormat format) {
  return json_object({named("colors", texels_piece(colors, format))});
}

std::optional<JsonPiece> as_zone_plate(const TextureLevel& image, TextureFormat format) {
  if (image != zone_plate_image(size_of(image), format)) return std::nullopt;
  return named("zone-plate", json_object({}));
}

std::optional<JsonPiece> as_gradient(const TextureLevel& image, TextureFormat format) {
  const int right = image.width - 1;
  const int top = image.height - 1;
  const std::array<StoredTexel, 4> corners{texel_of(image, 0, 0), texel_of(image, right, 0),
                                           texel_of(image, 0, top), texel_of(image, right, top)};
  if (image != gradient_image(size_of(image), corners, format)) return std::nullopt;
  const bool along_s = corners[0] == corners[2] && corners[1] == corners[3];
  return named("gradient", colors_object({corners.data(), along_s ? 2U : 4U}, format));
}

// The number of the first texel, row by row, that differs from the first one; 0: there is none.
std::size_t first_change(const TextureLevel& image) {
  const auto& texels = image.texels;
  for (std::size_t at = 4; at < texels.size(); at += 4)
    if (!std::equal(texels.begin(), texels.begin() + 4,
                    texels.begin() + static_cast<std::ptrdiff_t>(at)))
      return at / 4;
  return 0;
}

std::optional<JsonPiece> as_checker(const TextureLevel& image, TextureFormat format) {
  const std::size_t change = first_change(image);
  const auto width = static_cast<std::size_t>(image.width);
  const auto i = static_cast<int>(change % width);
  const auto j = static_cast<int>(change / width);
  const std::array<StoredTexel, 2> colors{texel_of(image, 0, 0), texel_of(image, i, j)};
  const int cell = change == 0 ? 1 : j == 0 ? i : j;
  if (image != checker_image(size_of(image), cell, colors)) return std::nullopt;
  Pieces members;
  if (cell != 1) members.push_back(named("cell", integer_piece(cell)));
  const std::array<StoredTexel, 2> standard{black_texel(format), white_texel(format)};
  if (colors != standard) members.push_back(named("colors", texels_piece(colors, format)));
  return named("checker", json_object(std::move(members)));
}

std::optional<JsonPiece> as_noise(const TextureLevel& image, TextureFormat format) {
  const StoredTexel first = texel_of(image, 0, 0);
  for (int seed = 0; seed <= kMaxNoiseSeed; ++seed) {
    const auto word = static_cast<std::uint64_t>(seed);
    if (texel_of(noise_image({1, 1}, format, word), 0, 0) != first) continue;
    if (image != noise_image(size_of(image), format, word)) continue;
    return named("noise", json_object({named("seed", integer_piece(seed))}));
  }
  return std::nullopt;
}

JsonPiece as_picture(const TextureLevel& image, TextureFormat format) {
  Pieces rows;
  for (int j = image.height; j-- > 0;) {
    std::vector<StoredTexel> row;
    for (int i = 0; i < image.width; ++i) row.push_back(texel_of(image, i, j));
    rows.push_back(texels_piece(row, format));
  }
  return named("texels", json_array(std::move(rows)));
}

JsonPiece image_piece(const TextureLevel& image, TextureFormat format) {
  if (image.texels.size() > 4 * kFewTexels)
    for (const auto as_pattern : {as_zone_plate, as_checker, as_gradient, as_noise})
      if (auto piece = as_pattern(image, format)) return std::move(*piece);
  return as_picture(image, format);
}

// Of a chain in which every level has one colour.
std::optional<JsonPiece> as_flat_levels(const Texture& texture) {
  std::vector<StoredTexel> colors;
  for (const TextureLevel& level : texture.levels) colors.push_back(texel_of(level, 0, 0));
  const PatternSize size = size_of(texture.levels.front());
  if (texture.levels != flat_levels(size, colors)) return std::nullopt;
  if (colors == level_colors(static_cast<int>(colors.size()), texture.format))
    return named("levels", json_object({}));
  return named("levels", colors_object(colors, texture.format));
}

JsonPiece size_piece(const Texture& texture) {
  const TextureLevel& base = texture.levels.front();
  Pieces sides{integer_piece(base.width)};
  if (texture.dimensions == 2) sides.push_back(integer_piece(base.height));
  return json_array(std::move(sides));
}

}  // namespace

JsonPiece texture_piece(const Texture& texture) {
  Pieces members{named("size", size_piece(texture))};
  if (texture.format != TextureFormat::rgba8)
    members.push_back(named("format", json_string(name_of(texture.format))));
  const TextureLevel& base = texture.levels.front();
  if (texture.generated) {
    members.push_back(named("mipmaps", json_string("generated")));
  } else if (texture.levels.size() > 1) {
    const bool boxes = texture.levels == box_chain(base, texture.format);
    const auto flat = boxes ? std::nullopt : as_flat_levels(texture);
    members.push_back(flat ? *flat : named("mipmaps", json_string("box")));
    if (flat) return json_object(std::move(members));
  }
  members.push_back(image_piece(base, texture.format));
  return json_object(std::move(members));
}

}  // namespace edgecase
