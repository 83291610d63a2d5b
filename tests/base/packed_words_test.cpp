// SPDX-License-Identifier: MIT
#include "base/packed_words.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace edgecase {
namespace {

using Words = std::vector<std::uint32_t>;

// Of every list of up to nine words of two values.
TEST(PackedWords, GiveBackWhatTheyWereMadeOf) {
  for (std::size_t size = 0; size <= 9; ++size)
    for (std::uint32_t bits = 0; bits < 1U << size; ++bits) {
      Words words;
      for (std::size_t i = 0; i < size; ++i) words.push_back(bits >> i & 1);
      const PackedWords packed = words;
      ASSERT_EQ(packed.words(), words);
      ASSERT_EQ(packed.size(), size);
      ASSERT_EQ(packed.empty(), size == 0);
      ASSERT_LE(packed.kept(), size);
    }
}

TEST(PackedWords, BytesAreWordsOfFour) {
  const std::vector<std::uint8_t> bytes{1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 5, 0, 0, 0, 0};
  const PackedWords packed = bytes;
  EXPECT_EQ(packed.bytes(), bytes);
  EXPECT_EQ(packed.size(), 5u);
  EXPECT_EQ(packed, PackedWords(packed.words()));
  EXPECT_THROW(PackedWords(std::vector<std::uint8_t>(6)), std::invalid_argument);
}

TEST(PackedWords, AreEqualWhereTheirWordsAre) {
  const Words words(100, 7);
  Words other = words;
  EXPECT_EQ(PackedWords(words), PackedWords(other));
  other[99] = 8;
  EXPECT_NE(PackedWords(words), PackedWords(other));
  other.pop_back();
  EXPECT_NE(PackedWords(words), PackedWords(other));
}

TEST(PackedWords, OfFewRunsLittleIsKeptAndOfManyNoMoreThanTheWords) {
  EXPECT_EQ(PackedWords(Words(4096, 7)).kept(), 2u);
  Words two(4096, 7);
  two.back() = 8;
  EXPECT_EQ(PackedWords(two).kept(), 4u);
  Words all;
  for (std::uint32_t i = 0; i < 4096; ++i) all.push_back(i);
  EXPECT_EQ(PackedWords(all).kept(), 4096u);
  EXPECT_EQ(PackedWords(all).words(), all);
}

// Runs whose lengths are words that occur, too: which is which is told by the place alone.
TEST(PackedWords, OfLongRunsInAnyOrder) {
  Words words;
  for (std::uint32_t run = 1; run <= 60; ++run)
    words.insert(words.end(), run * 7 % 61, run * 11 % 61);
  const PackedWords packed = words;
  EXPECT_EQ(packed.words(), words);
  EXPECT_EQ(packed.kept(), 120u);
}

}  // namespace
}  // namespace edgecase
