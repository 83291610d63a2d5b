// SPDX-License-Identifier: MIT
//
// Texels and rationals of tests: short forms, random images, and a literal filter that computes in
// rationals.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "rules/textures/texel_filter.h"

namespace edgecase {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

constexpr Wrap kAllWraps[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                              Wrap::clamp_to_border};

using Ends = std::pair<double, double>;

inline Ends ends_of(Interval interval) {
  return {interval.low, interval.high};
}

inline Rational power(const Rational& base, int exponent) {
  Rational result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

inline Integer floor_of(const Rational& value) {
  Integer quotient;
  Integer rest;
  divide_qr(numerator(value), denominator(value), quotient, rest);
  if (rest < 0) --quotient;
  return quotient;
}

// Have two boxes a colour in common?
inline bool meets(const Texel& a, const Texel& b) {
  for (std::size_t k = 0; k < 4; ++k)
    if (a[k].low > b[k].high || b[k].low > a[k].high) return false;
  return true;
}

// Texels whose red is j * width + i, and whose green, blue and alpha are 0.
inline DecodedLevel numbered(int width, int height) {
  DecodedLevel level{width, height, {}};
  for (int i = 0; i < width * height; ++i) level.texels.push_back({Interval(i), 0, 0, 0});
  return level;
}

// Floats: red, and nothing else.
inline TextureLevel red_level(int width, int height, const std::vector<float>& reds) {
  TextureLevel level{width, height, std::vector<float>(4 * reds.size())};
  for (std::size_t i = 0; i < reds.size(); ++i) level.texels[4 * i] = reds[i];
  return level;
}

inline TextureLevel random_level(std::mt19937& random, int width, int height,
                                 TextureFormat format) {
  TextureLevel level{width, height, {}};
  level.texels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::uniform_int_distribution<int> code(0, 255);
  std::uniform_real_distribution<float> number(-4, 4);
  for (float& texel : level.texels)
    texel = format == TextureFormat::rgba32f ? number(random) : static_cast<float>(code(random));
  return level;
}

// Table 8.20 on whole numbers of any size; none: the border.
inline int literal_wrap(const Integer& texel, int size, Wrap wrap) {
  const auto mod = [&](const Integer& by) {
    return Integer(texel - by * floor_of(Rational(texel, by)));
  };
  switch (wrap) {
    case Wrap::repeat:
      return static_cast<int>(mod(size));
    case Wrap::mirrored_repeat: {
      const int a = static_cast<int>(mod(2 * size)) - size;
      return (size - 1) - (a >= 0 ? a : -(1 + a));
    }
    case Wrap::clamp_to_edge:
      return texel < 0 ? 0 : texel >= size ? size - 1 : static_cast<int>(texel);
    case Wrap::clamp_to_border:
      return texel < 0 || texel >= size ? -1 : static_cast<int>(texel);
  }
  return -1;
}

// A texel of one axis, -1 for the border, and its weight.
struct LiteralTap {
  int texel = 0;
  Rational weight;
};

// The two texels around a coordinate, or the one that holds it.
inline std::array<LiteralTap, 2> literal_taps(const Rational& s, int size, Wrap wrap,
                                              Filter filter) {
  if (filter == Filter::nearest)
    return {LiteralTap{literal_wrap(floor_of(s * size), size, wrap), 1}, LiteralTap{0, 0}};
  const Rational v = s * size - Rational(1, 2);
  const Integer first = floor_of(v);
  return {LiteralTap{literal_wrap(first, size, wrap), 1 - (v - first)},
          LiteralTap{literal_wrap(first + 1, size, wrap), v - first}};
}

// One component of a lookup: the means of its texels' lower and of their upper ends.
inline std::pair<Rational, Rational> literal_lookup(const DecodedLevel& level, const Texel& border,
                                                    const std::array<LiteralTap, 2>& columns,
                                                    const std::array<LiteralTap, 2>& rows,
                                                    std::size_t component) {
  std::pair<Rational, Rational> mean{0, 0};
  for (const LiteralTap& row : rows)
    for (const LiteralTap& column : columns) {
      const Rational weight = row.weight * column.weight;
      if (weight == 0) continue;
      const bool outside = row.texel < 0 || column.texel < 0;
      const Interval texel = (outside ? border : level.at(column.texel, row.texel))[component];
      mean.first += weight * Rational(texel.low);
      mean.second += weight * Rational(texel.high);
    }
  return mean;
}

}  // namespace edgecase
