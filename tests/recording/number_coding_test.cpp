// SPDX-License-Identifier: MIT
#include "recording/bytes.h"

#include <gmock/gmock.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace edgecase::recording {
namespace {

using Numbers = std::vector<double>;

constexpr std::uint64_t kPlenty = 1000;  // numbers or bytes

std::string written(const Numbers& column) {
  std::string bytes;
  write_column(column, bytes);
  return bytes;
}

// The column as it comes back, which must use up all that was written of it and no more.
Numbers again(const Numbers& column) {
  const std::string bytes = written(column) + "x";
  std::string_view rest = bytes;
  Numbers result = read_column(rest, column.size());
  EXPECT_EQ(rest, "x");
  return result;
}

// float32 values without any order.
Numbers mixed_floats(std::size_t count) {
  Numbers column;
  std::uint32_t state = 1;
  while (column.size() < count) {
    state = state * 1664525u + 1013904223u;
    // No NaN, no infinity.
    const auto value = std::bit_cast<float>(state & 0xbfffffffu);
    if (value != 0) column.push_back(static_cast<double>(value));
  }
  return column;
}

TEST(NumberCoding, EveryKindOfColumnComesBack) {
  const double largest = 9007199254740991.0;
  for (const Numbers& column :
       {Numbers{}, Numbers{0}, Numbers{255, 0, 128, 255}, Numbers{256, 0}, Numbers{-1, 1, -300},
        Numbers{largest, -largest, 0}, Numbers{0.5, -0.25, 3}, Numbers{1e-40, 1e300},
        Numbers{std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()},
        Numbers{static_cast<double>(std::numeric_limits<float>::max()),
                static_cast<double>(std::numeric_limits<float>::denorm_min())},
        Numbers{0.1, 0.2, 0.3}, mixed_floats(1000)})
    EXPECT_EQ(again(column), column);
}

TEST(NumberCoding, EveryByteComesBack) {
  Numbers column;
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second) {
      column.push_back(first);
      column.push_back(second);
    }
  EXPECT_EQ(again(column), column);
}

TEST(NumberCoding, StepsAreTakenWhereTheyAreSmaller) {
  Numbers rising;
  for (int i = 0; i < 20000; ++i) rising.push_back(1000 + 3 * i);
  EXPECT_LT(written(rising).size(), 200u);
  EXPECT_EQ(again(rising), rising);
  Numbers ramp;
  // A line within a binade has equal steps of bits.
  for (int i = 0; i < 4096; ++i) ramp.push_back(1 + i / 4096.0);
  EXPECT_LT(written(ramp).size(), 200u);
  EXPECT_EQ(again(ramp), ramp);
}

TEST(NumberCoding, FloatsTakeFourBytesAtMost) {
  const Numbers floats = mixed_floats(10000);
  EXPECT_LT(written(floats).size(), 4 * floats.size() + 100);
}

TEST(NumberCoding, WhatIsNoColumnIsRefused) {
  const std::string good = written({0.5, 0.75, 1000});
  for (std::size_t size = 0; size < good.size(); ++size) {
    std::string_view cut = std::string_view(good).substr(0, size);
    EXPECT_THROW(read_column(cut, kPlenty), std::runtime_error) << size;
  }
  std::string unknown = good;
  unknown[0] = 8;
  std::string_view bytes = unknown;
  EXPECT_THROW(read_column(bytes, kPlenty), std::runtime_error);
  // Three bytes are no float32.
  std::string odd(1, 4);
  write_deflated("abc", odd);
  bytes = odd;
  EXPECT_THROW(read_column(bytes, kPlenty), std::runtime_error);
}

TEST(NumberCoding, MoreNumbersThanThereMayBeAreRefused) {
  for (const Numbers& column :
       {Numbers(9, 7.0), Numbers(9, 7000.0), Numbers(9, 0.5), Numbers(9, 0.1)}) {
    const std::string bytes = written(column);
    std::string_view rest = bytes;
    EXPECT_THROW(read_column(rest, 8), std::runtime_error) << column[0];
  }
}

TEST(Bytes, SizesAreRefusedWhereTheyPromiseTooMuch) {
  std::string huge;
  write_stretch(std::size_t{1} << 62, "short", huge);
  std::string_view bytes = huge;
  EXPECT_THROW(read_deflated(bytes, ~std::uint64_t{0}), std::runtime_error);
  // As much as deflate could make of these, and no memory is taken for it.
  std::string large;
  write_stretch(kPlenty + 1, std::string(std::size_t{1} << 21, 'x'), large);
  bytes = large;
  EXPECT_THAT([&] { read_deflated(bytes, kPlenty); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  ::testing::HasSubstr("1001 bytes, and its scenes can need 1000")));
  std::string endless(12, '\xff');
  bytes = endless;
  EXPECT_THROW(read_size(bytes), std::runtime_error);
}

}  // namespace
}  // namespace edgecase::recording
