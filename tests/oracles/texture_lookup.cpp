// SPDX-License-Identifier: MIT
#include "tests/oracles/texture_lookup.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace edgecase::oracle {
namespace {

using Whole = boost::multiprecision::cpp_int;
using Digits = boost::multiprecision::cpp_bin_float_50;

Whole floor_of(const Fraction& value) {
  Whole result = numerator(value) / denominator(value);
  if (result * denominator(value) > numerator(value)) result -= 1;
  return result;
}

Whole ceil_of(const Fraction& value) {
  return -floor_of(-value);
}

// 50 digits of a number that is none.
Fraction fraction_of(const Digits& value) {
  int exponent = 0;
  const Digits mantissa = frexp(value, &exponent);
  const Whole digits(ldexp(mantissa, 180));
  const Whole one = 1;
  exponent -= 180;
  return exponent >= 0 ? Fraction(digits << exponent) : Fraction(digits, one << -exponent);
}

Fraction fraction_of(float value) {
  return Fraction(value);
}

// 8.24: red, green and blue of an sRGB code.
Fraction computed_linear(int code) {
  const Fraction c(code, 255);
  if (c <= Fraction(4045, 100000)) return c / Fraction(1292, 100);
  const Digits base = (Digits(c) + Digits("0.055")) / Digits("1.055");
  return fraction_of(pow(base, Digits("2.4")));
}

const Fraction& linear_of_srgb(int code) {
  static const std::vector<Fraction> kTable = [] {
    std::vector<Fraction> table;
    for (int c = 0; c < 256; ++c) table.push_back(computed_linear(c));
    return table;
  }();
  return kTable.at(static_cast<std::size_t>(code));
}

FractionColor texel_at(const TextureQuery& query, int level, int i, int j) {
  const TextureLevel& image = query.levels[static_cast<std::size_t>(level)];
  FractionColor color;
  for (std::size_t c = 0; c < 4; ++c) {
    const float stored = image.texels[image.index(i, j) + c];
    if (query.texture.format == TextureFormat::rgba32f)
      color[c] = fraction_of(stored);
    else if (query.texture.format == TextureFormat::srgb8 && c < 3)
      color[c] = linear_of_srgb(static_cast<int>(stored));
    else
      color[c] = fraction_of(stored) / 255;
  }
  return color;
}

// 8.14.2: "values of TEXTURE_BORDER_COLOR are interpreted to match the texture's format".
FractionColor border_of(const TextureQuery& query) {
  FractionColor color;
  for (std::size_t c = 0; c < 4; ++c) {
    color[c] = fraction_of(query.sampler.border[c]);
    if (query.texture.format == TextureFormat::rgba32f) continue;
    if (color[c] < 0) color[c] = 0;
    if (color[c] > 1) color[c] = 1;
  }
  return color;
}

Whole modulo(const Whole& value, int by) {
  const Whole rest = value % by;
  return rest < 0 ? rest + by : rest;
}

// Table 8.20.
Whole wrapped(Wrap mode, const Whole& coordinate, int size) {
  switch (mode) {
    case Wrap::clamp_to_edge:
      return coordinate < 0 ? Whole(0) : coordinate > size - 1 ? Whole(size - 1) : coordinate;
    case Wrap::clamp_to_border:
      return coordinate < -1 ? Whole(-1) : coordinate > size ? Whole(size) : coordinate;
    case Wrap::repeat:
      return modulo(coordinate, size);
    case Wrap::mirrored_repeat: {
      const Whole a = modulo(coordinate, 2 * size) - size;
      return (size - 1) - (a >= 0 ? a : Whole(-(1 + a)));
    }
  }
  return 0;
}

FractionColor fetched(const TextureQuery& query, int level, const Whole& i, const Whole& j) {
  const TextureLevel& image = query.levels[static_cast<std::size_t>(level)];
  const Whole column = wrapped(query.sampler.wrap[0], i, image.width);
  const Whole row =
      query.texture.dimensions == 1 ? Whole(0) : wrapped(query.sampler.wrap[1], j, image.height);
  if (column < 0 || row < 0 || column >= image.width || row >= image.height)
    return border_of(query);
  return texel_at(query, level, static_cast<int>(column), static_cast<int>(row));
}

FractionColor weighted(const FractionColor& a, const FractionColor& b, const Fraction& weight) {
  FractionColor result;
  for (std::size_t c = 0; c < 4; ++c) result[c] = (1 - weight) * a[c] + weight * b[c];
  return result;
}

// 8.14.3: equations for NEAREST and LINEAR within one image.
FractionColor within_level(const TextureQuery& query, int level, Filter filter,
                           const std::array<Fraction, 2>& coordinates) {
  const TextureLevel& image = query.levels[static_cast<std::size_t>(level)];
  const Fraction u = coordinates[0] * image.width, v = coordinates[1] * image.height;
  if (filter == Filter::nearest) return fetched(query, level, floor_of(u), floor_of(v));
  const Fraction half(1, 2);
  const Whole i = floor_of(u - half), j = floor_of(v - half);
  const Fraction alpha = u - half - i, beta = v - half - j;
  const auto row = [&](const Whole& at) {
    return weighted(fetched(query, level, i, at), fetched(query, level, i + 1, at), alpha);
  };
  if (query.texture.dimensions == 1) return row(0);
  return weighted(row(j), row(j + 1), beta);
}

// 8.14.3: p = floor(log2(maxsize)) + level_base, q = min(p, level_max).
int last_level(const TextureQuery& query) {
  const int base = query.sampler.base_level;
  if (query.levels.size() == 1) return base;
  const TextureLevel& image = query.levels[static_cast<std::size_t>(base)];
  int p = base;
  for (int size = std::max(image.width, image.height); size > 1; size /= 2) ++p;
  return std::min(p, query.sampler.max_level);
}

int nearest_level(const TextureQuery& query, const Fraction& lambda) {
  const int base = query.sampler.base_level, q = last_level(query);
  const Fraction half(1, 2);
  if (query.ways.up_at_ties) {
    if (lambda < half) return base;
    const Whole level = floor_of(base + lambda + half);
    return level > q ? q : static_cast<int>(level);
  }
  if (lambda <= half) return base;
  if (base + lambda > q + half) return q;
  return static_cast<int>(ceil_of(base + lambda + half)) - 1;
}

}  // namespace

LevelOfDetail log2_of_scale(const TextureQuery& query, const Gradients& gradients) {
  const TextureLevel& base = query.levels[static_cast<std::size_t>(query.sampler.base_level)];
  const bool flat = query.texture.dimensions == 1;
  const auto squared_length = [&](const std::array<Fraction, 2>& d) -> Fraction {
    const Fraction u = d[0] * base.width, v = flat ? Fraction(0) : Fraction(d[1] * base.height);
    return u * u + v * v;
  };
  const Fraction x = squared_length(gradients.dx), y = squared_length(gradients.dy);
  Fraction squared = x > y ? x : y;
  if (squared == 0) return {true, 0};
  // Halved or doubled until it is 1 or not a power of two.
  int exponent = 0;
  while (squared >= 2) squared /= 2, ++exponent;
  while (squared < 1) squared *= 2, --exponent;
  Fraction logarithm = exponent;
  if (squared != 1) logarithm += fraction_of(log(Digits(squared)) / log(Digits(2)));
  return {false, logarithm / 2};
}

LevelOfDetail with_bias(LevelOfDetail base, const Sampler& sampler, float shader_bias) {
  Fraction bias = fraction_of(sampler.lod_bias) + fraction_of(shader_bias);
  if (bias > 16) bias = 16;
  if (bias < -16) bias = -16;
  base.value += bias;
  return base;
}

Fraction clamped(const LevelOfDetail& lambda_prime, const Sampler& sampler) {
  const Fraction least = fraction_of(sampler.min_lod), most = fraction_of(sampler.max_lod);
  if (lambda_prime.is_infinite || lambda_prime.value < least) return least;
  return lambda_prime.value > most ? most : lambda_prime.value;
}

Fraction accessed(const TextureQuery& query, const Fraction& lambda) {
  const int base = query.sampler.base_level;
  if (query.sampler.mipmap == MipFilter::none) return 0;
  if (query.sampler.mipmap == MipFilter::nearest) return nearest_level(query, lambda) - base;
  const Fraction most = last_level(query) - base;
  return lambda < 0 ? Fraction(0) : lambda > most ? most : lambda;
}

FractionColor look_up(const TextureQuery& query, const std::array<Fraction, 2>& coordinates,
                      const Fraction& lambda) {
  const Sampler& sampler = query.sampler;
  const int base = sampler.base_level, q = last_level(query);
  const bool by_half = query.ways.crossover_at_half && sampler.magnify == Filter::linear &&
                       sampler.minify == Filter::nearest && sampler.mipmap != MipFilter::none;
  const Fraction crossover = by_half ? Fraction(1, 2) : Fraction(0);
  const auto level = [&](int d, Filter filter) {
    return within_level(query, d, filter, coordinates);
  };
  if (lambda <= crossover) return level(base, sampler.magnify);
  if (sampler.mipmap == MipFilter::none) return level(base, sampler.minify);
  if (sampler.mipmap == MipFilter::nearest)
    return level(nearest_level(query, lambda), sampler.minify);
  if (base + lambda >= q) return level(q, sampler.minify);
  const int first = static_cast<int>(floor_of(base + lambda));
  return weighted(level(first, sampler.minify), level(first + 1, sampler.minify),
                  lambda - floor_of(lambda));
}

}  // namespace edgecase::oracle
