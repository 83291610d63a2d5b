// SPDX-License-Identifier: MIT
//
// What the framebuffer stores: colours and depths.
#pragma once

#include <cstdint>

#include "exact/interval.h"
#include "model/scene.h"
#include "rules/rule.h"

namespace edgecase {

// Essay: Pixels
//
// The value that a pixel ends up with (GL 4.6 core, 2.3.5.2, 2.1 and 17.3).
//
// Without blending and depth test the last fragment drawn wins. Its colour is converted to the
// target's format. Each component is clamped to [0, 1], scaled by 255, and rounded to one of the
// two nearest integers. The nearest is preferred. A pixel without a fragment keeps the clear
// colour.

Rule unorm8_rule();
Rule order_rule();

struct Unorm8Range {
  int low = 0;   // inclusive
  int high = 0;  // inclusive
  friend bool operator==(const Unorm8Range&, const Unorm8Range&) = default;
};

// Values that the conversion of any number in `value` may yield: either neighbour of an
// intermediate value.
Unorm8Range unorm8_permitted(Interval value);

// Essay: The depth buffer
//
// The value that the depth buffer ends up with (GL 4.6 core, 2.3.5.2 and 13.8.1).
//
// A depth is clamped to 0 to 1, in a floating-point buffer too (14.6.5, 15.2.3). It becomes an
// integer of 16 or 24 bits, depth times (2^bits - 1), or a float32 number. A pixel without a
// fragment keeps the clear value, 1.

Rule depth_buffer_rule();  // framebuffer.depth
Rule depth_bits_rule();    // framebuffer.depth-bits

// The bits that a depth buffer of integers keeps. Of a narrower buffer the largest integer is 1; of
// one that loses bits, each integer is rounded to a multiple of 2 or 4.
enum class DepthBits { as_set, fewer, sixteen, lowest_lost };
template <>
inline constexpr auto kNames<DepthBits> = std::to_array<TabledAlternative<DepthBits>>(
    {{DepthBits::as_set, "as-set", Openness::mandated, "those of the format: 16 or 24"},
     {DepthBits::fewer, "fewer", Openness::illegal, "15 of 16, 22 of 24"},
     {DepthBits::sixteen, "sixteen", Openness::illegal, "16 of 24"},
     {DepthBits::lowest_lost, "lowest-lost", Openness::illegal,
      "integers of 16 bits are rounded to multiples of 2, those of 24 bits to multiples of 4"}});

// Bits of an unsigned format; 0 for depth32f and none.
int bits_of(DepthFormat format);

// The stored value nearest to a depth, which is first clamped to 0 to 1; of two equally near ones,
// the one with the even integer. NaN is stored as 0.
double to_depth(double depth, DepthFormat format, DepthBits bits = DepthBits::as_set);

// True if the format contains this number. A float32 buffer contains numbers beyond 0 to 1, too.
bool is_depth_of(double stored, DepthFormat format);

// Stored values that the conversion of any number in `depth` may yield: either neighbour. A float32
// buffer may keep a depth beyond 0 to 1 unless a polygon offset made it so: 14.6.5 requires
// clamping only for the offset.
Interval depth_permitted(Interval depth, DepthFormat format);
// True for a stored value of an unsigned format among these, or one integer beyond (ruling 59).
bool is_within_one_code(double stored, Interval permitted, DepthFormat format);
inline constexpr int kRulingOnDepthCodes = 59;

}  // namespace edgecase
