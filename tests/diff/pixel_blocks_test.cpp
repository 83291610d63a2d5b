// SPDX-License-Identifier: MIT
#include "diff/compare.h"

#include <gtest/gtest.h>

#include <vector>

namespace edgecase {
namespace {

using Picture = std::vector<std::uint8_t>;

// Bytes that differ from their neighbours and from those of other blocks.
Picture picture_of(std::size_t pixels) {
  Picture picture;
  for (std::size_t i = 0; i < 4 * pixels; ++i)
    picture.push_back(static_cast<std::uint8_t>(i * 37 + i / 4096));
  return picture;
}

// As plainly as can be.
std::size_t counted_one_by_one(const Picture& a, const Picture& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 4 <= a.size() && i + 4 <= b.size(); i += 4)
    if (a[i] == b[i] && a[i + 1] == b[i + 1] && a[i + 2] == b[i + 2] && a[i + 3] == b[i + 3])
      ++count;
  return count;
}

TEST(SamePixels, AreAllOfAPictureAndItself) {
  for (const std::size_t pixels : {0U, 1U, 1023U, 1024U, 1025U, 2048U, 5000U})
    EXPECT_EQ(count_same_pixels(picture_of(pixels), picture_of(pixels)), pixels);
}

TEST(SamePixels, AreAllButThatWhoseByteDiffers) {
  const Picture picture = picture_of(2500);
  for (std::size_t at = 0; at < picture.size(); ++at) {
    Picture other = picture;
    other[at] ^= 1;
    EXPECT_EQ(count_same_pixels(picture, other), 2499U) << at;
  }
}

TEST(SamePixels, AreCountedWhereManyDiffer) {
  const Picture picture = picture_of(9000);
  for (std::size_t step = 1; step < 40; ++step) {
    Picture other = picture;
    for (std::size_t at = step / 2; at < other.size(); at += step) other[at] ^= 128;
    EXPECT_EQ(count_same_pixels(picture, other), counted_one_by_one(picture, other)) << step;
  }
}

TEST(SamePixels, AreNoneBeyondTheSmallerPicture) {
  EXPECT_EQ(count_same_pixels(picture_of(3000), picture_of(10)), 10U);
  EXPECT_EQ(count_same_pixels({}, picture_of(10)), 0U);
  Picture cut = picture_of(10);
  cut.pop_back();
  EXPECT_EQ(count_same_pixels(cut, picture_of(10)), 9U);
}

}  // namespace
}  // namespace edgecase
