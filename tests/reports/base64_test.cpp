// SPDX-License-Identifier: MIT
#include "reports/base64.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace edgecase {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(Base64, WritesGroupsOfFour) {
  const auto encoded = [](const std::string& text) {
    return to_base64({text.begin(), text.end()});
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(to_base64({255, 254, 253}), "//79");
}

TEST(Base64, ReadsBackBytesOfEveryLength) {
  std::mt19937 random(1);
  for (std::size_t size = 0; size < 70; ++size) {
    Bytes bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    EXPECT_EQ(from_base64(to_base64(bytes)), bytes);
  }
  // RFC 4648, section 10.
  EXPECT_EQ(from_base64("Zm9vYg=="), (Bytes{'f', 'o', 'o', 'b'}));
  for (const char* bad : {"Zm9", "Zm9*", "Z===", "Zm=v", "Zm9vYg==Zm9v", "Zm9v\n"})
    EXPECT_THROW(from_base64(bad), std::runtime_error) << bad;
}

}  // namespace
}  // namespace edgecase
