// SPDX-License-Identifier: MIT
#include "casefile/scene/patterns.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <utility>

#include "casefile/json/numbers.h"
#include "exact/elementary.h"

namespace edgecase {

std::uint64_t mix(std::uint64_t word) {
  word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9U;
  word = (word ^ (word >> 27)) * 0x94D049BB133111EBU;
  return word ^ (word >> 31);
}

namespace {

// SplitMix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, 2014): results of
// a seed are the same on every machine. Returns 64 random bits; `state` starts as the seed.
std::uint64_t next_word(std::uint64_t& state) {
  state += 0x9E3779B97F4A7C15U;
  return mix(state);
}

constexpr std::int64_t kUnitWeight = std::int64_t{1} << 16;

// A number from 0 to count - 1; `count` is at most 2^16.
std::int64_t below(std::int64_t count, std::uint64_t& state) {
  assert(0 < count && count <= std::int64_t{1} << 16);
  const std::uint64_t word = next_word(state) >> 32;
  return static_cast<std::int64_t>((word * static_cast<std::uint64_t>(count)) >> 32);
}

// The first multiple of 2^-16, as raw units, at or above i / n.
std::int64_t start_of_cell(std::int64_t i, int n) {
  return (i * Fixed::kOne + n - 1) / n;
}

Fixed within_cell(int i, int n, std::uint64_t& state) {
  const std::int64_t start = start_of_cell(i, n);
  return Fixed::from_raw(start + below(start_of_cell(i + 1, n) - start, state));
}

Point point_of_cell(int column, int row, int n, std::uint64_t& state) {
  const Fixed x = within_cell(column, n, state);
  return {x, within_cell(row, n, state)};
}

// numerator / denominator, both nonnegative, rounded to nearest, ties to even.
std::int64_t rounded_quotient(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t floor = numerator / denominator;
  const std::int64_t twice = 2 * (numerator % denominator);
  return twice > denominator || (twice == denominator && floor % 2 == 1) ? floor + 1 : floor;
}

std::int64_t weight_of(Point at, const ReconstructionFilter& filter) {
  const std::int64_t x = std::abs((at.x - Fixed::centre_of(0)).raw());
  const std::int64_t y = std::abs((at.y - Fixed::centre_of(0)).raw());
  const std::int64_t r = filter.radius.raw();
  if (x > r || y > r) return 0;
  switch (filter.kernel) {
    case Kernel::box:
      return 1;
    case Kernel::tent:  // at most 2^17 2^17 2^16
      return rounded_quotient((r - x) * (r - y) * kUnitWeight, r * r);
    case Kernel::gaussian:
      return std::llrint(
          exponential(-2 * static_cast<double>(x * x + y * y) / static_cast<double>(r * r)) *
          static_cast<double>(kUnitWeight));
  }
  return 0;
}

}  // namespace

Pattern grid_pattern(int n) {
  const auto centre = [&](int i) {
    return Fixed::from_raw(rounded_quotient((2 * i + 1) * Fixed::kOne, 2 * n));
  };
  Pattern pattern;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) pattern.push_back({centre(column), centre(row)});
  return pattern;
}

Pattern jittered_pattern(int n, std::uint64_t seed) {
  Pattern pattern;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
      pattern.push_back(point_of_cell(column, row, n, seed));
  return pattern;
}

Pattern n_rooks_pattern(int n, std::uint64_t seed) {
  std::vector<int> rows(static_cast<std::size_t>(n));
  std::iota(rows.begin(), rows.end(), 0);
  for (std::size_t left = rows.size(); left > 1; --left) {
    const std::int64_t chosen = below(static_cast<std::int64_t>(left), seed);
    std::swap(rows[left - 1], rows[static_cast<std::size_t>(chosen)]);
  }
  Pattern pattern;
  for (int column = 0; column < n; ++column)
    pattern.push_back(point_of_cell(column, rows[static_cast<std::size_t>(column)], n, seed));
  return pattern;
}

Pattern random_pattern(int n, std::uint64_t seed) {
  Pattern pattern;
  for (int i = 0; i < n; ++i) pattern.push_back(point_of_cell(0, 0, 1, seed));
  return pattern;
}

Supersampling filtered(const Pattern& pattern, const ReconstructionFilter& filter) {
  const int reach = filter.radius > Fixed::from_raw(Fixed::kOne / 2) ? 1 : 0;
  Supersampling passes;
  for (int row = -reach; row <= reach; ++row)
    for (int column = -reach; column <= reach; ++column)
      for (const Point within : pattern) {
        const Point at{within.x + Fixed::from_integer(column), within.y + Fixed::from_integer(row)};
        const std::int64_t weight = weight_of(at, filter);
        if (weight > 0) passes.push_back({at, weight});
      }
  return passes;
}

namespace {

constexpr int kLargestCode = 255;

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

// The stored number nearest to the weighted sum of values over the divisor.
float weighted_mean(std::span<const float> values, std::span<const int> weights, int divisor,
                    TextureFormat format) {
  std::array<double, 4> terms{};
  std::int64_t codes = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    terms[i] = static_cast<double>(values[i]) * weights[i];
    if (!holds_floats(format)) codes += static_cast<std::int64_t>(values[i]) * weights[i];
  }
  if (!holds_floats(format)) return static_cast<float>(rounded_quotient(codes, divisor));
  return nearest_quotient({terms.data(), values.size()}, divisor);
}

// (1 + cos(angle)) / 2, where the angle is `turned` / `quarter` quarter turns. 0, 1/4, 3/4 and 1
// are exact. Squared distances of texels never give an odd number of quarter turns.
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
  if (holds_floats(format)) return color;
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
    if (holds_floats(format)) {
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
    number = !holds_floats(format) ? static_cast<float>(word >> 56)
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
    colors.push_back(!holds_floats(format) ? kCodes[k] : StoredTexel{level, level / 2, 0.25F, 1});
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
