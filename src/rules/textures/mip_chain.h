// SPDX-License-Identifier: MIT
//
// Mip chains: images of half the size, each made from the one before (GL 4.6 core, 8.14.3 and
// 8.14.4). OpenGL fixes the number of levels and their sizes. It leaves the filter open.
//
//   levels     floor(log2(larger side of level 0)) + 1
//   level k    each side is max(1, floor(side of level 0 / 2^k))
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "model/texture.h"
#include "rules/rule.h"

namespace edgecase {

Rule level_count_rule();      // mipmap.level-count
Rule mipmap_filter_rule();    // mipmap.filter
Rule mipmap_rounding_rule();  // mipmap.rounding
Rule mipmap_srgb_rule();      // mipmap.srgb: linear or codes, see MipmapMethod

enum class LevelCount {
  larger_side,   // down to 1x1: OpenGL
  smaller_side,  // until the smaller side is 1: a course's
};
const char* name_of(LevelCount choice);
bool parse_name(std::string_view name, LevelCount& choice);

enum class MipmapFilter {
  box,              // texels 2i and 2i + 1 along each axis, the last of an odd size left out
  bilinear_centre,  // a linear lookup at the destination texel's centre, which is the box of even
                    // sizes; of odd ones it lies between
  nearest,          // texel 2i
};
std::span<const MipmapFilter> all_mipmap_filters();
const char* name_of(MipmapFilter choice);
bool parse_name(std::string_view name, MipmapFilter& choice);

enum class MipmapRounding {
  nearest_even,
  half_up,
  down,
  half_up_by_rows,  // of codes: each row's mean by itself, then the mean of both, with weights of 8
                    // bits; sRGB texels in linear light, and floats, as nearest_even
};
std::span<const MipmapRounding> all_mipmap_roundings();
const char* name_of(MipmapRounding choice);
bool parse_name(std::string_view name, MipmapRounding& choice);

int levels_of_chain(int width, int height, LevelCount choice);

// The next smaller image. sRGB texels are decoded, averaged and coded again where `linear_srgb`,
// else their codes are.
struct MipmapMethod {
  MipmapFilter filter = MipmapFilter::box;
  MipmapRounding rounding = MipmapRounding::nearest_even;
  bool linear_srgb = true;

  friend bool operator==(const MipmapMethod&, const MipmapMethod&) = default;
};
TextureLevel reduced(const TextureLevel& level, TextureFormat format, const MipmapMethod& method);

// Level 0 and all that follow.
std::vector<TextureLevel> mip_chain(const TextureLevel& base, TextureFormat format,
                                    LevelCount count, const MipmapMethod& method);

}  // namespace edgecase
