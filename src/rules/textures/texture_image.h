// SPDX-License-Identifier: MIT
//
// Wrap modes choose the texel where coordinates leave the image (GL 4.6 core, 8.14.2, table 8.20).
// They act on whole texels, after the filter has chosen them:
//
//                    -2 -1  0  1  2  3  4  5    of an image of 4; b is the border
//   repeat            2  3  0  1  2  3  0  1
//   mirrored repeat   1  0  0  1  2  3  3  2
//   clamp to edge     0  0  0  1  2  3  3  3
//   clamp to border   b  b  0  1  2  3  b  b
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "exact/interval.h"
#include "model/texture.h"
#include "rules/rule.h"

namespace edgecase {

Rule wrap_rule();  // texture.wrap

enum class WrapChoice {
  as_set,
  mirrored_as_repeat,  // known from renderers without mirrored repetition
};
template <>
inline constexpr auto kNames<WrapChoice> = std::to_array<TabledAlternative<WrapChoice>>(
    {{WrapChoice::as_set, "as-set", Openness::mandated, "each axis wraps as its own mode says"},
     {WrapChoice::mirrored_as_repeat, "mirrored-as-repeat", Openness::illegal,
      "mirrored repetition repeats the image without mirroring it"}});

// The mode in effect when a mode is set.
Wrap effective(Wrap wrap, WrapChoice choice);

// The texel of 0 to size - 1 at `texel`, any 64-bit number; none: the border.
std::optional<int> wrapped(std::int64_t texel, int size, Wrap wrap, WrapChoice choice);

// The meaning of texels: numbers of which filters take means (GL 4.6 core, 8.24 for sRGB, 2.3.5 for
// normalized integers). A code of 8 bits is c/255, which is no double: intervals contain it.

// Red, green, blue and alpha; linear.
using Texel = std::array<Interval, 4>;
using Texels = boost::container::small_vector<Texel, 2>;  // what a lookup may yield

struct DecodedLevel {
  int width;
  int height;
  std::vector<Texel> texels;  // row by row from the bottom

  const Texel& at(int i, int j) const {
    return texels[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(i)];
  }
};

struct DecodedTexture {
  int dimensions;
  TextureFormat format;
  std::vector<DecodedLevel> levels;  // level 0 first
};

// c/255, for a code of 0 to 255: the narrowest interval of doubles; exact for 0 and 1.
Interval unorm8_to_number(int code);

// The linear number of an sRGB code of 0 to 255 (8.24), s = code/255: s/12.92 up to 0.04045, else
// ((s + 0.055)/1.055)^2.4. Less than 2^-48 of itself wide; exact for 0 and 1.
Interval srgb_to_linear(int code);

// The same functions for any number of 0 to 1: from an sRGB number to the linear one and back. Off
// by less than 2^-48 of the result; numbers outside are clamped. Both are increasing.
double srgb_to_linear_number(double coded);
double linear_to_srgb_number(double linear);

// A border colour of four float32 numbers in a texture of this format: 0 to 1 unless the format is
// of floats, and linear, even if texels are coded. NaN becomes 0 there, and anything in a texture
// of floats.
Texel decode_border(const std::array<float, 4>& border, TextureFormat format);

// Red, green and blue of a linear colour, converted to sRGB, and back: a renderer may filter the
// former and decode the result (8.24).
Texel srgb_coded(const Texel& linear);
Texel srgb_decoded(const Texel& coded);
DecodedTexture srgb_coded(const DecodedTexture& linear);

DecodedLevel decode(const TextureLevel& level, TextureFormat format);
// `levels`: a chain to use instead of the texture's own; empty: the texture's own.
DecodedTexture decode(const Texture& texture, const std::vector<TextureLevel>& levels);

}  // namespace edgecase
