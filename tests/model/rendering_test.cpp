// SPDX-License-Identifier: MIT
#include "model/rendering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

namespace edgecase {
namespace {

TEST(Rendering, FragmentsAreSortedByRowColumnPrimitive) {
  std::mt19937_64 engine(5);
  Rendering rendering;
  for (int i = 0; i < 500; ++i) {
    Fragment f;
    f.x = static_cast<int>(engine() % 5);
    f.y = static_cast<int>(engine() % 5);
    f.primitive = static_cast<int>(engine() % 4);
    f.depth = i;  // remembers the order in which they came
    rendering.fragments.push_back(f);
  }
  sort_fragments(rendering);
  const auto key = [](const Fragment& f) { return std::tuple(f.y, f.x, f.primitive, f.depth); };
  for (std::size_t i = 1; i < rendering.fragments.size(); ++i)
    ASSERT_LT(key(rendering.fragments[i - 1]), key(rendering.fragments[i]))
        << "equal fragments must keep the order in which they came";
}

// As most come: primitive by primitive, each sorted by itself; from one to more than are merged.
TEST(Rendering, SortedRunsOfFragmentsAreSortedAsAWhole) {
  std::mt19937_64 engine(6);
  const auto are_equal = [](const Fragment& a, const Fragment& b) {
    return std::tie(a.y, a.x, a.primitive, a.depth) == std::tie(b.y, b.x, b.primitive, b.depth);
  };
  for (int round = 0; round < 200; ++round) {
    Rendering rendering;
    rendering.width = rendering.height = 40;
    int reported = 0;
    for (int primitive = 0; primitive < 1 + round % 12; ++primitive) {
      std::vector<Fragment> run(1 + engine() % 30);
      for (Fragment& f : run) {
        f.x = static_cast<int>(engine() % 6);
        f.y = static_cast<int>(engine() % 6);
        f.primitive = primitive % 3;
        f.depth = ++reported;
      }
      std::stable_sort(run.begin(), run.end(), precedes);
      rendering.fragments.insert(rendering.fragments.end(), run.begin(), run.end());
    }
    std::vector<Fragment> expected = rendering.fragments;
    std::stable_sort(expected.begin(), expected.end(), precedes);
    sort_fragments(rendering);
    ASSERT_TRUE(std::ranges::equal(rendering.fragments, expected, are_equal)) << round;
  }
}

TEST(Rendering, PixelsAreIndexedRowByRowFromTheBottom) {
  Rendering rendering;
  rendering.width = 7;
  rendering.height = 3;
  std::size_t expected = 0;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 7; ++x) EXPECT_EQ(rendering.pixel_index(x, y), expected++);
}

// GL 4.6 core, 2.3.5.2 at its word, in integers: c = k/510, so 255 c = k/2.
TEST(ToUnorm8, IsTheNearestIntegerTiesToEven) {
  for (int k = 0; k <= 510; ++k) {
    const int below = k / 2;
    const int expected = k % 2 == 0 ? below : below + below % 2;
    EXPECT_EQ(to_unorm8(k / 510.0), expected) << k;
  }
}

TEST(ToUnorm8, ClampsAndMakesZeroOfNaN) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(to_unorm8(std::numeric_limits<double>::quiet_NaN()), 0);
  for (double below : {-0.0, -1e-300, -1.0, -kInfinity}) EXPECT_EQ(to_unorm8(below), 0);
  for (double above : {1.0, 1.0000001, 300.0, kInfinity}) EXPECT_EQ(to_unorm8(above), 255);
}

// Every stored value survives the way through float32, as colours take it.
TEST(ToUnorm8, ReadsBackEveryByteFromItsFloat) {
  for (int byte = 0; byte <= 255; ++byte)
    EXPECT_EQ(to_unorm8(static_cast<double>(static_cast<float>(byte) / 255.0f)), byte);
}

}  // namespace
}  // namespace edgecase
