// SPDX-License-Identifier: MIT
//
// Texture: images that a scene looks up, and how. Passive, like the scene that owns it.
//
// Texel (0, 0) lies at texture coordinates (0, 0): rows run from the bottom, t upwards, as in GL.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "model/names.h"

namespace edgecase {

// The format of texels. srgb8: red, green and blue are coded by the sRGB curve, alpha is linear.
enum class TextureFormat { rgba8, srgb8, rgba32f };
template <>
inline constexpr auto kNames<TextureFormat> =
    std::to_array<Named<TextureFormat>>({{TextureFormat::rgba8, "rgba8"},
                                         {TextureFormat::srgb8, "srgb8"},
                                         {TextureFormat::rgba32f, "rgba32f"}});

// Whether texels are arbitrary float32 numbers; otherwise they are 8-bit codes.
constexpr bool holds_floats(TextureFormat format) {
  switch (format) {
    case TextureFormat::rgba8:
    case TextureFormat::srgb8:
      return false;
    case TextureFormat::rgba32f:
      return true;
  }
  return false;
}

// The image beyond 0 to 1 (GL 4.6 core, 8.14.2).
enum class Wrap { repeat, mirrored_repeat, clamp_to_edge, clamp_to_border };
template <>
inline constexpr auto kNames<Wrap> =
    std::to_array<Named<Wrap>>({{Wrap::repeat, "repeat"},
                                {Wrap::mirrored_repeat, "mirrored-repeat"},
                                {Wrap::clamp_to_edge, "clamp-to-edge"},
                                {Wrap::clamp_to_border, "clamp-to-border"}});

// Whether the image repeats beyond 0 to 1, as it is or mirrored: its period is 1 or 2.
constexpr bool is_periodic(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
    case Wrap::mirrored_repeat:
      return true;
    case Wrap::clamp_to_edge:
    case Wrap::clamp_to_border:
      return false;
  }
  return false;
}

// How the texels of a level are combined.
enum class Filter { nearest, linear };
template <>
inline constexpr auto kNames<Filter> = std::to_array<Named<Filter>>({{Filter::nearest, "nearest"},
                                                                     {Filter::linear, "linear"}});

// How levels are combined: only the base level, the nearest, or a mean of the two nearest.
enum class MipFilter { none, nearest, linear };
template <>
inline constexpr auto kNames<MipFilter> = std::to_array<Named<MipFilter>>(
    {{MipFilter::none, "none"}, {MipFilter::nearest, "nearest"}, {MipFilter::linear, "linear"}});

// One image of a mip chain.
struct TextureLevel {
  int width = 1;   // texels, 1 to kMaxTextureSize
  int height = 1;  // 1 for a one-dimensional texture
  // Red, green, blue, alpha of each texel, row by row from the bottom, 4 * width * height numbers
  // as stored by the format: whole numbers from 0 to 255, or any float32 numbers for rgba32f.
  std::vector<float> texels;

  std::size_t index(int i, int j) const {
    return 4 * (static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(i));
  }
  friend bool operator==(const TextureLevel&, const TextureLevel&) = default;
};

constexpr int kMaxTextureSize = 1024;

struct Texture {
  int dimensions = 2;  // 1 or 2
  TextureFormat format = TextureFormat::rgba8;
  // Level 0 first, as many as the scene gives: one, or a whole chain down to 1x1 with the sizes of
  // level_size.
  std::vector<TextureLevel> levels;
  // Whether the renderer makes the levels beyond 0 (glGenerateMipmap); `levels` then has one.
  bool generated = false;

  friend bool operator==(const Texture&, const Texture&) = default;
};

// The largest magnitude of a sampler's bias, of a lookup's, and of their sum. OpenGL requires at
// least 2 and lets a renderer report more (GL_MAX_TEXTURE_LOD_BIAS).
constexpr double kMaxLodBias = 16;
// The largest number of samples along a footprint; the least is 1.
constexpr double kMaxAnisotropy = 16;

// The parameters of a texture and its sampler (GL 4.6 core, 8.10, table 23.18).
struct Sampler {
  std::array<Wrap, 2> wrap{Wrap::repeat, Wrap::repeat};  // of s and t
  Filter magnify = Filter::linear;
  Filter minify = Filter::nearest;
  MipFilter mipmap = MipFilter::none;
  float lod_bias = 0;  // -kMaxLodBias to kMaxLodBias
  float min_lod = -1000;
  float max_lod = 1000;
  int base_level = 0;    // 0 to 10, a level of the texture
  int max_level = 1000;  // at least base_level
  std::array<float, 4> border{0, 0, 0, 0};
  float max_anisotropy = 1;  // 1 to kMaxAnisotropy

  friend bool operator==(const Sampler&, const Sampler&) = default;
};

// The shader's function: texture(), texture() with a bias, textureLod(), textureGrad().
enum class LookupKind { implicit, bias, lod, gradients };
template <>
inline constexpr auto kNames<LookupKind> =
    std::to_array<Named<LookupKind>>({{LookupKind::implicit, "implicit"},
                                      {LookupKind::bias, "bias"},
                                      {LookupKind::lod, "lod"},
                                      {LookupKind::gradients, "gradients"}});

struct Lookup {
  LookupKind kind = LookupKind::implicit;
  float value = 0;            // for bias and lod, in levels
  std::array<float, 2> dx{};  // for gradients: of (s, t) per pixel along x
  std::array<float, 2> dy{};  // and along y
  friend bool operator==(const Lookup&, const Lookup&) = default;
};

// A draw's texture: fragments take their colour from it at the vertices' texture coordinates,
// interpolated as the draw says.
struct TextureUse {
  std::size_t texture = 0;  // index in the scene
  Sampler sampler;
  Lookup lookup;
  friend bool operator==(const TextureUse&, const TextureUse&) = default;
};

// The size of a level of a chain whose level 0 has `size` texels along an axis: halved `level`
// times, rounded down, at least 1 (GL 4.6 core, 8.14.3).
int level_size(int size, int level);
// The number of levels of a whole chain: floor(log2(larger side)) + 1.
int level_count(int width, int height);

}  // namespace edgecase
