// SPDX-License-Identifier: MIT
#include "rules/textures/mip_chain.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "rules/textures/texel_mean.h"

namespace edgecase {
namespace {

// Neighbouring texels of the larger image along an axis, and their whole weights.
struct Taps {
  int first = 0;
  TwoWeights weights{1, 0};
};

// In texels of the larger image the centre of texel i is (i + 1/2) size/halved; less 1/2, that is
// ((2i + 1) size - halved)/(2 halved).
Taps centre_taps(int i, int size, int halved) {
  const int centre = (2 * i + 1) * size - halved;
  const int weight = centre % (2 * halved);
  return {centre / (2 * halved), {2 * halved - weight, weight}};
}

// For texel i of the smaller image.
Taps taps_of(int i, int size, MipmapFilter filter) {
  if (size == 1) return {};
  switch (filter) {
    case MipmapFilter::box:
      return {2 * i, {1, 1}};
    case MipmapFilter::bilinear_centre:
      return centre_taps(i, size, size / 2);
    case MipmapFilter::nearest:
      return {2 * i, {1, 0}};
  }
  return {};
}

// The texels that make one texel of the smaller image: two from each of two rows. A texel without
// weight may lie outside the image, and is replaced by the first.
class Footing {
 public:
  Footing(const TextureLevel& level, Taps columns, Taps rows) : columns_(columns), rows_(rows) {
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t i = 0; i < 2; ++i)
        indices_[2 * j + i] = level.index(texel_of(columns, i), texel_of(rows, j));
  }

  float mean(const TextureLevel& level, TextureFormat format, std::size_t component,
             const MipmapMethod& method) const {
    std::array<float, 4> values;
    for (std::size_t i = 0; i < 4; ++i) values[i] = level.texels[indices_[i] + component];
    constexpr std::size_t kAlpha = 3;
    const bool by_rows = method.rounding == MipmapRounding::half_up_by_rows;
    const MipmapRounding rounding = by_rows ? MipmapRounding::nearest_even : method.rounding;
    if (holds_floats(format)) return weighted(values, mean_of_floats, rounding);
    if (format == TextureFormat::srgb8 && method.srgb == MipmapSrgb::linear)
      return weighted(values, component == kAlpha ? mean_of_codes : mean_of_srgb, rounding);
    if (by_rows) return mean_of_rows(values, columns_.weights, rows_.weights);
    return weighted(values, mean_of_codes, rounding);
  }

 private:
  static int texel_of(const Taps& taps, std::size_t which) {
    return taps.first + (which == 1 && taps.weights[1] != 0 ? 1 : 0);
  }

  float weighted(const std::array<float, 4>& values, float (*rule)(WeightedNumbers, MipmapRounding),
                 MipmapRounding rounding) const {
    std::array<WeightedNumber, 4> numbers;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const int weight = columns_.weights[i % 2] * rows_.weights[i / 2];
      if (weight != 0) numbers[count++] = {values[i], weight};
    }
    return rule({numbers.data(), count}, rounding);
  }

  Taps columns_;
  Taps rows_;
  std::array<std::size_t, 4> indices_{};
};

}  // namespace

int levels_of_chain(int width, int height, LevelCount choice) {
  if (choice == LevelCount::larger_side) return level_count(width, height);
  const int smaller = std::min(width, height);
  return level_count(smaller, smaller);
}

TextureLevel reduced(const TextureLevel& level, TextureFormat format, const MipmapMethod& method) {
  TextureLevel result{level_size(level.width, 1), level_size(level.height, 1), {}};
  for (int j = 0; j < result.height; ++j)
    for (int i = 0; i < result.width; ++i) {
      const Footing footing(level, taps_of(i, level.width, method.filter),
                            taps_of(j, level.height, method.filter));
      for (std::size_t k = 0; k < 4; ++k)
        result.texels.push_back(footing.mean(level, format, k, method));
    }
  return result;
}

std::vector<TextureLevel> mip_chain(const TextureLevel& base, TextureFormat format,
                                    LevelCount count, const MipmapMethod& method) {
  std::vector<TextureLevel> chain = {base};
  const auto levels = static_cast<std::size_t>(levels_of_chain(base.width, base.height, count));
  while (chain.size() < levels) chain.push_back(reduced(chain.back(), format, method));
  return chain;
}

Rule level_count_rule() {
  return {RuleId::mipmap_level_count,
          "A mip chain goes down to one texel",
          "8.14.3 (mipmapping)",
          "none (ruling 25)",
          "larger-side",
          alternatives_of<LevelCount>(),
          {}};
}

Rule mipmap_filter_rule() {
  return {
      RuleId::mipmap_filter,
      "A generated level is a filtered reduction of the one before",
      "8.14.4 (manual mipmap generation)",
      "any filter; a box filter is recommended (rulings 25 and 48)",
      "box",
      alternatives_of<MipmapFilter>(),
      {{25,
        "Generated mip chains: the number of levels and their sizes can be wrong, and so can "
        "level 0, which is given and stays. OpenGL leaves the filter open, and with it rounding "
        "and whether sRGB texels are decoded before they are averaged. But levels are filtered "
        "reductions of the image: a component that is the same in all of level 0 stays the same, "
        "within one code of 8 bits or 1 part in 10^5."},
       {48,
        "A generated level that leaves what lies between the least and the largest of the level "
        "above, by more than one code of 8 bits or 1 part in 10^5, is contested: no mean does, but "
        "filters with negative weights do, and no particular filter is required (8.14.4)."}}};
}

Rule mipmap_rounding_rule() {
  return {RuleId::mipmap_rounding,
          "Texels of a generated level are rounded to the texture's format",
          "8.14.4 (manual mipmap generation)",
          "any rounding (ruling 25)",
          "nearest-even",
          alternatives_of<MipmapRounding>(),
          {}};
}

Rule mipmap_srgb_rule() {
  return {RuleId::mipmap_srgb,
          "sRGB texels are averaged as light",
          "8.14.4 (manual mipmap generation) and 8.24 (sRGB texture color conversion)",
          "whether texels are decoded before they are averaged (ruling 25)",
          "linear",
          alternatives_of<MipmapSrgb>(),
          {}};
}

}  // namespace edgecase
