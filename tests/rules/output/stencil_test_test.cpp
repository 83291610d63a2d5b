// SPDX-License-Identifier: MIT
#include "rules/output/fragment_tests.h"

#include <gtest/gtest.h>

#include <array>
#include <bitset>

namespace edgecase {
namespace {

constexpr CompareFunction kFunctions[] = {CompareFunction::never,   CompareFunction::less,
                                          CompareFunction::equal,   CompareFunction::lequal,
                                          CompareFunction::greater, CompareFunction::notequal,
                                          CompareFunction::gequal,  CompareFunction::always};
constexpr StencilOperation kOperations[] = {StencilOperation::keep,      StencilOperation::zero,
                                            StencilOperation::replace,   StencilOperation::incr,
                                            StencilOperation::incr_wrap, StencilOperation::decr,
                                            StencilOperation::decr_wrap, StencilOperation::invert};
constexpr std::uint8_t kMasks[] = {0x00, 0x01, 0x0f, 0x80, 0xa5, 0xfe, 0xff};
constexpr std::uint8_t kReferences[] = {0, 1, 2, 0x0f, 0x7f, 0x80, 0xa5, 0xfe, 0xff};

using Bits = std::bitset<8>;

// The oracle: bit by bit, as the specification words it.
Bits masked(std::uint8_t value, std::uint8_t mask) {
  Bits result;
  for (std::size_t bit = 0; bit < 8; ++bit) result[bit] = Bits(value)[bit] && Bits(mask)[bit];
  return result;
}

// -1, 0 or 1: by the highest bit in which they differ.
int order_of(Bits a, Bits b) {
  for (std::size_t bit = 8; bit-- > 0;)
    if (a[bit] != b[bit]) return a[bit] ? 1 : -1;
  return 0;
}

bool literally_passes(CompareFunction function, int order) {
  constexpr std::array<std::array<bool, 3>, 8> kTable = {{{false, false, false},
                                                          {true, false, false},
                                                          {false, true, false},
                                                          {true, true, false},
                                                          {false, false, true},
                                                          {true, false, true},
                                                          {false, true, true},
                                                          {true, true, true}}};
  return kTable[static_cast<std::size_t>(function)][static_cast<std::size_t>(order + 1)];
}

unsigned literal_result(StencilOperation operation, unsigned reference, unsigned stored) {
  constexpr unsigned kValues = 256;
  const std::array<unsigned, 8> results = {stored,
                                           0,
                                           reference,
                                           stored == 255 ? 255 : stored + 1,
                                           (stored + 1) % kValues,
                                           stored == 0 ? 0 : stored - 1,
                                           (stored + kValues - 1) % kValues,
                                           255 - stored};
  return results[static_cast<std::size_t>(operation)];
}

std::uint8_t literally_written(unsigned result, std::uint8_t stored, std::uint8_t mask) {
  Bits bits(stored);
  for (std::size_t bit = 0; bit < 8; ++bit)
    if (Bits(mask)[bit]) bits[bit] = Bits(result)[bit];
  return static_cast<std::uint8_t>(bits.to_ulong());
}

std::uint8_t byte(int value) {
  return static_cast<std::uint8_t>(value);
}

TEST(StencilTest, ComparesTheMaskedReferenceWithTheMaskedValue) {
  int passed = 0, failed = 0;
  for (const CompareFunction function : kFunctions)
    for (const std::uint8_t reference : kReferences)
      for (const std::uint8_t mask : kMasks)
        for (int stored = 0; stored < 256; ++stored) {
          StencilFace face{.function = function, .reference = reference, .read_mask = mask};
          const int order = order_of(masked(reference, mask), masked(byte(stored), mask));
          const bool expected = literally_passes(function, order);
          ASSERT_EQ(passes_stencil_test(face, byte(stored), StencilMethod::as_set), expected)
              << name_of(function) << " " << int{reference} << " " << int{mask} << " " << stored;
          ++(expected ? passed : failed);
        }
  EXPECT_GT(passed, 10000);
  EXPECT_GT(failed, 10000);
}

TEST(StencilTest, OperationsChangeWhatTheWriteMaskLets) {
  for (const StencilOperation operation : kOperations)
    for (const std::uint8_t reference : kReferences)
      for (const std::uint8_t mask : kMasks)
        for (int stored = 0; stored < 256; ++stored) {
          // The read mask is of the comparison alone.
          StencilFace face{.reference = reference, .read_mask = 0x0f, .write_mask = mask};
          const unsigned result =
              literal_result(operation, reference, static_cast<unsigned>(stored));
          ASSERT_EQ(int{after(operation, face, byte(stored), StencilMethod::as_set)},
                    int{literally_written(result, byte(stored), mask)})
              << name_of(operation) << " " << int{reference} << " " << int{mask} << " " << stored;
        }
}

TEST(StencilTest, FacesHaveTheirOwnStates) {
  StencilTest test;
  test.front.reference = 1;
  test.back.reference = 2;
  for (const StencilMethod method : values_of<StencilMethod>()) {
    const bool one_sided = method == StencilMethod::one_sided;
    EXPECT_EQ(&face_of(test, true, method), &test.front);
    EXPECT_EQ(&face_of(test, false, method), one_sided ? &test.front : &test.back);
  }
}

TEST(StencilTest, IgnoredNeitherTestsNorWrites) {
  const StencilFace face{.function = CompareFunction::never, .reference = 9};
  EXPECT_TRUE(passes_stencil_test(face, 7, StencilMethod::ignored));
  for (const StencilOperation operation : kOperations)
    EXPECT_EQ(after(operation, face, 7, StencilMethod::ignored), 7);
}

TEST(StencilTest, UnmaskedComparesAllBits) {
  const StencilFace face{.function = CompareFunction::equal, .reference = 0xf1, .read_mask = 0x0f};
  EXPECT_TRUE(passes_stencil_test(face, 0x01, StencilMethod::as_set));
  EXPECT_FALSE(passes_stencil_test(face, 0x01, StencilMethod::unmasked));
  EXPECT_TRUE(passes_stencil_test(face, 0xf1, StencilMethod::unmasked));
}

TEST(StencilTest, StoredFirstExchangesLessAndGreater) {
  StencilFace face{.function = CompareFunction::less, .reference = 3};
  EXPECT_TRUE(passes_stencil_test(face, 4, StencilMethod::as_set));
  EXPECT_FALSE(passes_stencil_test(face, 2, StencilMethod::as_set));
  EXPECT_FALSE(passes_stencil_test(face, 4, StencilMethod::stored_first));
  EXPECT_TRUE(passes_stencil_test(face, 2, StencilMethod::stored_first));
  EXPECT_FALSE(passes_stencil_test(face, 3, StencilMethod::stored_first));
  face.function = CompareFunction::gequal;
  for (const int stored : {2, 3, 4})
    EXPECT_EQ(passes_stencil_test(face, byte(stored), StencilMethod::stored_first), stored >= 3);
}

TEST(StencilTest, WrappingAndSaturatingTakeOneForTheOther) {
  const StencilFace face;
  using enum StencilOperation;
  const auto by = [&](StencilOperation operation, int stored, StencilMethod method) {
    return int{after(operation, face, byte(stored), method)};
  };
  for (const auto& [saturates, wraps, end, beyond] :
       {std::tuple{incr, incr_wrap, 255, 0}, std::tuple{decr, decr_wrap, 0, 255}}) {
    EXPECT_EQ(by(saturates, end, StencilMethod::as_set), end);
    EXPECT_EQ(by(saturates, end, StencilMethod::wrapping), beyond);
    EXPECT_EQ(by(saturates, end, StencilMethod::saturating), end);
    EXPECT_EQ(by(wraps, end, StencilMethod::as_set), beyond);
    EXPECT_EQ(by(wraps, end, StencilMethod::wrapping), beyond);
    EXPECT_EQ(by(wraps, end, StencilMethod::saturating), end);
    for (int stored = 1; stored < 255; ++stored)
      for (const StencilMethod method : {StencilMethod::wrapping, StencilMethod::saturating}) {
        EXPECT_EQ(by(saturates, stored, method), by(saturates, stored, StencilMethod::as_set));
        EXPECT_EQ(by(wraps, stored, method), by(wraps, stored, StencilMethod::as_set));
      }
  }
}

TEST(StencilTest, AnIgnoredWriteMaskChangesAllBits) {
  const StencilFace face{.reference = 0xab, .write_mask = 0x0f};
  const auto by = [&](StencilMethod method) {
    return int{after(StencilOperation::replace, face, 0x12, method)};
  };
  EXPECT_EQ(by(StencilMethod::as_set), 0x1b);
  EXPECT_EQ(by(StencilMethod::write_mask_ignored), 0xab);
}

}  // namespace
}  // namespace edgecase
