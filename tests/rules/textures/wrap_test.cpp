// SPDX-License-Identifier: MIT
//
// Wrap modes, held against the formulas of table 8.20 as OpenGL writes them.
#include "rules/textures/texture_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "exact/fixed.h"

namespace edgecase {
namespace {

constexpr Wrap kWraps[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                           Wrap::clamp_to_border};

// "(a mod b) = a - b floor(a/b)".
Int128 mod(Int128 a, Int128 b) {
  Int128 quotient = a / b;
  if (quotient * b > a) --quotient;
  return a - b * quotient;
}

// "mirror(a) = a if a >= 0, and -(1 + a) otherwise".
Int128 mirror(Int128 a) {
  return a >= 0 ? a : -(1 + a);
}

std::optional<int> by_table(Int128 coord, Int128 size, Wrap wrap) {
  Int128 texel = 0;
  switch (wrap) {
    case Wrap::repeat:
      texel = mod(coord, size);
      break;
    case Wrap::mirrored_repeat:
      texel = (size - 1) - mirror(mod(coord, 2 * size) - size);
      break;
    case Wrap::clamp_to_edge:
      texel = std::clamp<Int128>(coord, 0, size - 1);
      break;
    case Wrap::clamp_to_border:
      texel = std::clamp<Int128>(coord, -1, size);
      break;
  }
  if (texel < 0 || texel >= size) return std::nullopt;
  return static_cast<int>(texel);
}

TEST(Wrapped, FollowsTheTable) {
  for (int size = 1; size <= 7; ++size)
    for (std::int64_t texel = -50; texel <= 50; ++texel)
      for (const Wrap wrap : kWraps)
        EXPECT_EQ(wrapped(texel, size, wrap, WrapChoice::as_set), by_table(texel, size, wrap))
            << texel << " of " << size << " " << name_of(wrap);
}

TEST(Wrapped, FollowsTheTableToTheEndsOf64Bits) {
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  for (const int size : {1, 2, 3, 7, 1023, 1024})
    for (std::int64_t k = 0; k < 3000; ++k)
      for (const Wrap wrap : kWraps) {
        EXPECT_EQ(wrapped(kLeast + k, size, wrap, WrapChoice::as_set),
                  by_table(kLeast + k, size, wrap));
        EXPECT_EQ(wrapped(kMost - k, size, wrap, WrapChoice::as_set),
                  by_table(kMost - k, size, wrap));
      }
}

TEST(Wrapped, MirroredRepetitionMayBeTakenForRepetitionAndNothingElse) {
  constexpr WrapChoice kChoice = WrapChoice::mirrored_as_repeat;
  for (std::int64_t texel = -20; texel <= 20; ++texel)
    for (const Wrap wrap : kWraps)
      EXPECT_EQ(wrapped(texel, 5, wrap, kChoice),
                by_table(texel, 5, wrap == Wrap::mirrored_repeat ? Wrap::repeat : wrap));
}

TEST(WrapChoiceNames, AreThoseOfTheCatalogue) {
  for (const Alternative& alternative : wrap_rule().alternatives) {
    WrapChoice choice{};
    ASSERT_TRUE(parse_name(alternative.name, choice));
    EXPECT_EQ(name_of(choice), alternative.name);
  }
  WrapChoice choice = WrapChoice::mirrored_as_repeat;
  EXPECT_FALSE(parse_name("mirrored", choice));
  EXPECT_EQ(choice, WrapChoice::mirrored_as_repeat);
}

}  // namespace
}  // namespace edgecase
