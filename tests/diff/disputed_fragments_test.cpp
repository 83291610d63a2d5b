// SPDX-License-Identifier: MIT
//
// Of small comparisons all fragments are told, of others those at the pixels that are disputed.
#include "diff/display_data.h"

#include <gtest/gtest.h>

#include <tuple>
#include <vector>

namespace edgecase {
namespace {

using Reported = Result::ReportedFragment;
using Places = std::vector<std::tuple<int, int, int>>;  // y, x, pass

// Each pixel of a square drawn once, by primitive 2.
Rendering square(int size) {
  Rendering rendering;
  rendering.width = rendering.height = size;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) rendering.fragments.push_back({x, y, 2});
  return rendering;
}

Places places_of(const std::vector<Reported>& reported) {
  Places places;
  for (const Reported& one : reported)
    places.emplace_back(one.fragment.y, one.fragment.x, one.pass);
  return places;
}

Result with_disagreement_at(int x, int y) {
  Result result;
  result.disagreements.resize(1);
  result.disagreements[0].x = x;
  result.disagreements[0].y = y;
  return result;
}

TEST(DisputedFragments, AreNoneWhereNothingDiffers) {
  Result result;
  report_fragments(square(4), square(4), result);
  EXPECT_TRUE(result.exact_fragments.empty());
  EXPECT_TRUE(result.rendered_fragments.empty());
}

TEST(DisputedFragments, AreAllOfASmallComparison) {
  Result result = with_disagreement_at(1, 0);
  report_fragments(square(5), square(5), result);
  EXPECT_EQ(result.exact_fragments.size(), 25u);
  EXPECT_EQ(result.rendered_fragments.size(), 25u);
}

TEST(DisputedFragments, AreThoseAtDisputedPixelsOfALargeOne) {
  Result result = with_disagreement_at(3, 5);
  result.values.resize(2);
  result.values[0].worst = {6, 1, 2};
  result.values[0].differing = {{0, 0, 2}, {6, 1, 2}};
  result.values[1].worst = {7, 7, 2};  // nothing differs: it is no place
  const Rendering exact = square(8);
  Rendering rendered = exact;
  std::erase_if(rendered.fragments, [](const Fragment& f) { return f.x == 3 && f.y == 5; });
  rendered.fragments.front().detail = 4;
  report_fragments(exact, rendered, result);
  EXPECT_EQ(places_of(result.exact_fragments), (Places{{1, 6, -1}, {5, 3, -1}}));
  EXPECT_EQ(places_of(result.rendered_fragments), (Places{{1, 6, -1}}));
  EXPECT_EQ(result.exact_fragments[0].fragment.primitive, 2);
}

// The limit counts both sides, and the fragments of all passes.
TEST(DisputedFragments, AreSmallUpToTheLimit) {
  Rendering exact = square(8);
  Rendering rendered = exact;
  rendered.fragments.clear();
  ASSERT_EQ(exact.fragments.size(), kMostOfSmall);
  Result small = with_disagreement_at(0, 0);
  report_fragments(exact, rendered, small);
  EXPECT_EQ(small.exact_fragments.size(), kMostOfSmall);
  rendered.passes = {exact};
  rendered.passes[0].fragments.resize(1);
  Result large = with_disagreement_at(0, 0);
  report_fragments(exact, rendered, large);
  EXPECT_EQ(large.exact_fragments.size(), 1u);
  EXPECT_EQ(large.rendered_fragments.size(), 1u);
}

TEST(DisputedFragments, NameTheirPass) {
  Rendering exact = square(2);
  exact.passes = {exact, exact};
  exact.fragments.clear();
  exact.passes[0].fragments.resize(1);
  exact.passes[1].fragments[0].detail = 3;
  Result result = with_disagreement_at(0, 0);
  report_fragments(exact, exact, result);
  EXPECT_EQ(places_of(result.exact_fragments),
            (Places{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}}));
  EXPECT_EQ(result.exact_fragments[1].fragment.detail, -1) << "details stay behind";
}

}  // namespace
}  // namespace edgecase
