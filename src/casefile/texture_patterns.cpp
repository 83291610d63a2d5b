// SPDX-License-Identifier: MIT
#include "casefile/texture_patterns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "casefile/exact_quotient.h"
#include "casefile/split_mix.h"
#include "exact/elementary.h"

namespace edgecase {
namespace {

constexpr int kLargestCode = 255;

bool is_coded(TextureFormat format) {
  return format != TextureFormat::rgba32f;
}

TextureLevel blank(PatternSize size) {
  TextureLevel level{size.width, size.height, {}};
  level.texels.resize(4 * static_cast<std::size_t>(size.width) *
                      static_cast<std::size_t>(size.height));
  return level;
}

// An image whose texel (i, j) is texel_at(i, j).
template <class TexelAt>
TextureLevel image_of(PatternSize size, const TexelAt& texel_at) {
  TextureLevel level = blank(size);
  auto next = level.texels.begin();
  for (int j = 0; j < size.height; ++j) {
    for (int i = 0; i < size.width; ++i) {
      const StoredTexel texel = texel_at(i, j);
      next = std::copy(texel.begin(), texel.end(), next);
    }
  }
  return level;
}

// numerator / denominator, neither of them negative, to the nearest whole number, a tie to even.
int rounded_quotient(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t floor = numerator / denominator;
  const std::int64_t twice = 2 * (numerator % denominator);
  const bool up = twice > denominator || (twice == denominator && floor % 2 == 1);
  return static_cast<int>(floor + (up ? 1 : 0));
}

// The stored number nearest to the sum of values times weights, divided.
float weighted_mean(std::span<const float> values, std::span<const int> weights, int divisor,
                    TextureFormat format) {
  std::array<double, 4> terms{};
  std::int64_t codes = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    terms[i] = static_cast<double>(values[i]) * weights[i];
    if (is_coded(format)) codes += static_cast<std::int64_t>(values[i]) * weights[i];
  }
  if (is_coded(format)) return static_cast<float>(rounded_quotient(codes, divisor));
  return nearest_quotient({terms.data(), values.size()}, divisor);
}

// (1 + cos(angle)) / 2 of an angle of `turned` / `quarter` quarter turns: exactly where that is
// 0, 1/4, 3/4 or 1. Squares of texels' distances never make an odd number of quarter turns.
double raised_cosine(std::int64_t turned, std::int64_t quarter) {
  std::int64_t at = turned % (4 * quarter);
  if (at > 2 * quarter) at = 4 * quarter - at;
  const double sign = at > quarter ? -1 : 1;
  if (at > quarter) at = 2 * quarter - at;
  if (3 * at == 2 * quarter) return 0.5 + 0.25 * sign;
  const double angle =
      std::numbers::pi * static_cast<double>(at) / (2 * static_cast<double>(quarter));
  return 0.5 + 0.5 * sign * cosine(angle);
}

}  // namespace

StoredTexel stored_texel(const std::array<float, 4>& color, TextureFormat format) {
  if (!is_coded(format)) return color;
  StoredTexel texel{};
  for (std::size_t c = 0; c < texel.size(); ++c)  // 24 bits times 8: exact in a double
    texel[c] = static_cast<float>(std::nearbyint(static_cast<double>(color[c]) * kLargestCode));
  return texel;
}

StoredTexel white_texel(TextureFormat format) {
  return stored_texel({1, 1, 1, 1}, format);
}

StoredTexel black_texel(TextureFormat format) {
  return stored_texel({0, 0, 0, 1}, format);
}

TextureLevel checker_image(PatternSize size, int cell, const std::array<StoredTexel, 2>& colors) {
  return image_of(size, [&](int i, int j) {
    return colors[static_cast<std::size_t>((i / cell + j / cell) % 2)];
  });
}

TextureLevel gradient_image(PatternSize size, const std::array<StoredTexel, 4>& corners,
                            TextureFormat format) {
  const int columns = std::max(1, size.width - 1);
  const int rows = std::max(1, size.height - 1);
  return image_of(size, [&](int i, int j) {
    const std::array<int, 4> weights{(columns - i) * (rows - j), i * (rows - j), (columns - i) * j,
                                     i * j};
    StoredTexel texel{};
    for (std::size_t c = 0; c < texel.size(); ++c) {
      const std::array<float, 4> values{corners[0][c], corners[1][c], corners[2][c], corners[3][c]};
      texel[c] = weighted_mean(values, weights, columns * rows, format);
    }
    return texel;
  });
}

TextureLevel zone_plate_image(PatternSize size, TextureFormat format) {
  const std::int64_t larger = std::max(size.width, size.height);
  return image_of(size, [&](int i, int j) {
    // Twice the distances from the centre.
    const std::int64_t x = 2 * i + 1 - size.width;
    const std::int64_t y = 2 * j + 1 - size.height;
    const double grey = raised_cosine(x * x + y * y, 2 * larger);
    if (!is_coded(format)) {
      const auto value = static_cast<float>(grey);
      return StoredTexel{value, value, value, 1};
    }
    const auto code = static_cast<float>(std::nearbyint(grey * kLargestCode));
    return StoredTexel{code, code, code, kLargestCode};
  });
}

TextureLevel noise_image(PatternSize size, TextureFormat format, std::uint64_t seed) {
  TextureLevel level = blank(size);
  for (float& number : level.texels) {
    const std::uint64_t word = next_word(seed);
    number = is_coded(format) ? static_cast<float>(word >> 56)
                              : std::ldexp(static_cast<float>(word >> 40), -24);
  }
  return level;
}

TextureLevel flat_image(PatternSize size, const StoredTexel& texel) {
  return image_of(size, [&](int, int) { return texel; });
}

std::vector<TextureLevel> flat_levels(PatternSize size, std::span<const StoredTexel> colors) {
  std::vector<TextureLevel> levels;
  for (const StoredTexel& color : colors) {
    const auto level = static_cast<int>(levels.size());
    levels.push_back(
        flat_image({level_size(size.width, level), level_size(size.height, level)}, color));
  }
  return levels;
}

std::vector<StoredTexel> level_colors(int count, TextureFormat format) {
  constexpr StoredTexel kCodes[] = {{255, 0, 0, 255},     {0, 255, 0, 255},   {0, 0, 255, 255},
                                    {255, 255, 0, 255},   {0, 255, 255, 255}, {255, 0, 255, 255},
                                    {255, 128, 0, 255},   {0, 128, 255, 255}, {128, 255, 0, 255},
                                    {255, 255, 255, 255}, {0, 0, 0, 255}};
  static_assert(std::size(kCodes) == 11);  // log2(kMaxTextureSize) + 1
  std::vector<StoredTexel> colors;
  for (int k = 0; k < count; ++k) {
    const auto level = static_cast<float>(k);
    colors.push_back(is_coded(format) ? kCodes[k] : StoredTexel{level, level / 2, 0.25F, 1});
  }
  return colors;
}

TextureLevel box_level(const TextureLevel& level, TextureFormat format) {
  const PatternSize size{level_size(level.width, 1), level_size(level.height, 1)};
  const int across = std::min(level.width, 2);
  const int up = std::min(level.height, 2);
  constexpr std::array<int, 4> kOnce{1, 1, 1, 1};
  const auto count = static_cast<std::size_t>(across * up);
  return image_of(size, [&](int i, int j) {
    StoredTexel texel{};
    for (std::size_t c = 0; c < texel.size(); ++c) {
      std::array<float, 4> values{};
      for (int k = 0; k < across * up; ++k)
        values[static_cast<std::size_t>(k)] =
            level.texels[level.index(2 * i + k % across, 2 * j + k / across) + c];
      texel[c] = weighted_mean({values.data(), count}, kOnce, across * up, format);
    }
    return texel;
  });
}

std::vector<TextureLevel> box_chain(TextureLevel base, TextureFormat format) {
  std::vector<TextureLevel> levels{std::move(base)};
  while (levels.back().width > 1 || levels.back().height > 1)
    levels.push_back(box_level(levels.back(), format));
  return levels;
}

}  // namespace edgecase
