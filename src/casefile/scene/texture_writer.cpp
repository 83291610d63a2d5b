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
#include "casefile/json/schema.h"
#include "casefile/scene/patterns.h"

namespace edgecase {

namespace {

constexpr std::size_t kFewTexels = 16;  // listed one by one, whatever the pattern

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
  if (!holds_floats(format))
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

// The index of the first texel, row by row, that differs from the first one; 0 if there is none.
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

// A chain in which every level has a single colour.
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

namespace {

constexpr std::string_view kTextureSchema = R"json({
  "texel_color": {
    "description": "[red, green, blue] or [red, green, blue, alpha], each taken to the nearest \
        float32; alpha is 1 if not said. Of rgba8 and srgb8, 0 to 1, then taken to the nearest \
        of 255 steps, a tie to the even one; of rgba32f, any.",
    "type": "array",
    "minItems": 3,
    "maxItems": 4,
    "items": {
      "title": "Component",
      "description": "0 to 1; of rgba32f any float32 number.",
      "type": "number",
      "minimum": "@least_texel",
      "maximum": "@largest_texel"
    }
  },
  "two_texel_colors": {
    "description": "Two colours.",
    "type": "array",
    "minItems": 2,
    "maxItems": 2,
    "items": {"$ref": "#/$defs/texel_color"}
  },
  "texture": {
    "title": "Texture",
    "description": "An image of one kind, and what makes its smaller levels. Texel (0, 0) is at \
        the lower left, at texture coordinates (0, 0).",
    "type": "object",
    "additionalProperties": false,
    "oneOf": [
      {"required": ["checker", "size"]},
      {"required": ["gradient", "size"]},
      {"required": ["zone-plate", "size"]},
      {"required": ["levels", "size"], "not": {"required": ["mipmaps"]}},
      {"required": ["noise", "size"]},
      {"required": ["texels"]},
      {"required": ["file"]}
    ],
    "properties": {
      "size": {
        "title": "Size",
        "description": "[width, height] in texels, or [width] of a one-dimensional texture. Of \
            \"texels\" and \"file\" it may be left out.",
        "type": "array",
        "minItems": 1,
        "maxItems": 2,
        "items": {"type": "integer", "minimum": 1, "maximum": "@side"}
      },
      "format": {
        "title": "Format",
        "description": "rgba8: 0 to 255 stand for 0 to 1; srgb8: the same, of which red, green \
            and blue are decoded by the sRGB curve when they are looked up; rgba32f: float32 \
            numbers.",
        "enum": "@formats",
        "default": "@format"
      },
      "mipmaps": {
        "title": "Mip chain",
        "description": "none: level 0 alone. box: each texel is the mean of the 2 x 2 of the \
            level before, as stored, rounded once, a tie to even; the last row or column of an \
            odd size goes nowhere. generated: the renderer makes them (glGenerateMipmap).",
        "enum": "@mipmaps",
        "default": "none"
      },
      "checker": {
        "title": "Checker",
        "description": "Squares of two colours by turns; the one at the lower left has the \
            first.",
        "type": "object",
        "additionalProperties": false,
        "properties": {
          "cell": {
            "title": "Cell",
            "description": "Side of a square, in texels.",
            "type": "integer",
            "minimum": 1,
            "maximum": "@side",
            "default": 1
          },
          "colors": {
            "title": "Colours",
            "description": "Black and white if not said.",
            "$ref": "#/$defs/two_texel_colors"
          }
        }
      },
      "gradient": {
        "title": "Gradient",
        "description": "From the first column to the last, or between the four corners: the \
            nearest stored numbers, ties to even.",
        "type": "object",
        "required": ["colors"],
        "additionalProperties": false,
        "properties": {
          "colors": {
            "title": "Colours",
            "description": "[left, right], or [bottom left, bottom right, top left, top right].",
            "type": "array",
            "minItems": 2,
            "maxItems": 4,
            "not": {"minItems": 3, "maxItems": 3},
            "items": {"$ref": "#/$defs/texel_color"}
          }
        }
      },
      "zone-plate": {
        "title": "Zone plate",
        "description": "Rings that get narrower outwards: grey 1/2 + 1/2 cos(pi (x^2 + y^2) / \
            larger side), x and y in texels from the centre.",
        "type": "object",
        "additionalProperties": false
      },
      "levels": {
        "title": "Levels",
        "description": "A whole mip chain, each level of one colour. Without colours, level k of \
            rgba32f is (k, k/2, 1/4, 1), and the others have a fixed list.",
        "type": "object",
        "additionalProperties": false,
        "properties": {
          "colors": {
            "title": "Colours",
            "description": "One for each level, the largest first.",
            "type": "array",
            "minItems": 1,
            "maxItems": "@levels",
            "items": {"$ref": "#/$defs/texel_color"}
          }
        }
      },
      "noise": {
        "title": "Noise",
        "description": "Every component of every texel drawn at random, the same on every \
            machine (SplitMix64): all 256 steps, or, of rgba32f, multiples of 2^-24 from 0 to 1.",
        "type": "object",
        "required": ["seed"],
        "additionalProperties": false,
        "properties": {
          "seed": {
            "title": "Seed",
            "description": "Which noise.",
            "type": "integer",
            "minimum": 0,
            "maximum": "@seed"
          }
        }
      },
      "texels": {
        "title": "Texels",
        "description": "A picture: rows of equally many colours, the top row first.",
        "type": "array",
        "minItems": 1,
        "maxItems": "@side",
        "items": {
          "title": "Row",
          "description": "Colours from left to right.",
          "type": "array",
          "minItems": 1,
          "maxItems": "@side",
          "items": {"$ref": "#/$defs/texel_color"}
        }
      },
      "file": {
        "title": "File",
        "description": "Path of a PNG, TIFF or EXR file, relative to the case's folder and \
            inside the suite, of @side x @side pixels at most. Its numbers are taken as they \
            are: 8 bits for rgba8 and srgb8; 8 bits, 16 bits (both 0 to 1) or floating point for \
            rgba32f.",
        "type": "string",
        "minLength": 5,
        "maxLength": "@path",
        "pattern": "^[^/\\u0000-\\u001f\\u007f][^\\u0000-\\u001f\\u007f]*\\.(png|tif|exr)$"
      }
    }
  }
})json";

}  // namespace

Pieces texture_schemas() {
  return schema_pieces(
      kTextureSchema,
      {named("largest_texel", schema_number(kMaxTexel)),
       named("path", schema_number(kPathLimits.most)),
       named("least_texel", schema_number(-kMaxTexel)),
       named("side", schema_number(kMaxTextureSize)),
       named("formats", schema_names<TextureFormat>()),
       named("format", json_string(name_of(Texture().format))),
       named("mipmaps", json_strings(kMipmaps)),
       named("levels", schema_number(level_count(kMaxTextureSize, kMaxTextureSize))),
       named("seed", schema_number(kMaxNoiseSeed))});
}

}  // namespace edgecase
