// SPDX-License-Identifier: MIT
#include "casefile/scene/scene_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "model/rendering.h"

namespace edgecase {
namespace {

constexpr int kCases = 1000;

std::string id(int i) {
  return "lines/case-" + std::to_string(i);
}

TEST(SaltedColors, ClearIsDarkAndPrimitivesAreBright) {
  for (int i = 0; i < kCases; ++i) {
    const std::uint64_t hash = hash_of_id(id(i));
    const Color clear = salted_clear(hash);
    EXPECT_LE(*std::max_element(clear.begin(), clear.begin() + 3), 63 / 255.0F);
    EXPECT_EQ(clear[3], 1);
    for (std::uint64_t p = 0; p < 20; ++p) {
      const Color color = salted_primitive(hash, p);
      EXPECT_GE(*std::max_element(color.begin(), color.begin() + 3), 192 / 255.0F);
      EXPECT_LE(*std::min_element(color.begin(), color.begin() + 3), 71 / 255.0F);
      EXPECT_EQ(color[3], 1);
      // Neighbours in drawing order differ by a quarter of the range in some channel.
      const Color next = salted_primitive(hash, p + 1);
      float difference = 0;
      for (std::size_t k = 0; k < 3; ++k)
        difference = std::max(difference, std::abs(color[k] - next[k]));
      EXPECT_GE(difference, 0.25F);
    }
  }
}

TEST(SaltedColors, AreBytesThatComeBackUnchanged) {
  const Color color = salted_primitive(hash_of_id("a"), 3);
  for (const float component : color) {
    const int level = to_unorm8(component);
    EXPECT_EQ(static_cast<float>(level) / 255.0F, component);
  }
}

TEST(SaltedColors, DifferFromCaseToCase) {
  std::set<Color> clears;
  std::set<std::pair<Color, Color>> both;
  for (int i = 0; i < kCases; ++i) {
    const std::uint64_t hash = hash_of_id(id(i));
    clears.insert(salted_clear(hash));
    both.insert({salted_clear(hash), salted_primitive(hash, 0)});
  }
  // 1000 draws out of 2^18 colours: two pairs of equal ones are to be expected.
  EXPECT_GE(clears.size(), 990U);
  EXPECT_EQ(both.size(), static_cast<std::size_t>(kCases));
}

TEST(SaltedColors, SharedVerticesHaveOneEach) {
  using Indices = std::vector<std::uint64_t>;
  EXPECT_EQ(salted_indices(Primitive::points, 3), (Indices{0, 1, 2}));
  EXPECT_EQ(salted_indices(Primitive::lines, 4), (Indices{0, 0, 1, 1}));
  EXPECT_EQ(salted_indices(Primitive::triangles, 6), (Indices{0, 0, 0, 1, 1, 1}));
  for (const Primitive primitive :
       {Primitive::line_strip, Primitive::triangle_strip, Primitive::triangle_fan})
    EXPECT_EQ(salted_indices(primitive, 4), (Indices{0, 1, 2, 3})) << name_of(primitive);
}

// Three steps on is a hue too near to the first.
TEST(SaltedColors, ALoopsLastVertexAvoidsTheFirst) {
  EXPECT_EQ(salted_indices(Primitive::line_loop, 4), (std::vector<std::uint64_t>{0, 1, 2, 4}));
}

// The provoking vertices of a loop's segments go round it: each differs from the next.
TEST(SaltedColors, NeighboursInALoopDiffer) {
  const std::uint64_t hash = hash_of_id("a");
  for (std::size_t count = 2; count < 300; ++count) {
    const auto indices = salted_indices(Primitive::line_loop, count);
    for (std::size_t i = 0; i < count; ++i) {
      const Color color = salted_primitive(hash, indices[i]);
      const Color next = salted_primitive(hash, indices[(i + 1) % count]);
      float difference = 0;
      for (std::size_t k = 0; k < 3; ++k)
        difference = std::max(difference, std::abs(color[k] - next[k]));
      EXPECT_GE(difference, 0.25F) << count << " " << i;
    }
  }
}

// Pins the colours, computed by hand from the published constants: committed fingerprints and
// recordings depend on them.
TEST(SaltedColors, NeverChange) {
  EXPECT_EQ(hash_of_id("a"), 198367012849983736U);
  EXPECT_EQ(hash_of_id("lines/horizontal"), 3922459699852321852U);
  const Color clear = salted_clear(hash_of_id("a"));
  EXPECT_EQ(clear, (Color{56 / 255.0F, 3 / 255.0F, 2 / 255.0F, 1}));
}

}  // namespace
}  // namespace edgecase
