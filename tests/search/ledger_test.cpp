// SPDX-License-Identifier: MIT
//
// The ledger: each find once, and again where a scene shows it that people read more easily.
#include "search/ledger.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "diff/compare.h"
#include "generate/random_shapes.h"
#include "raster/rasterizer.h"
#include "search/scene_size.h"

namespace edgecase {
namespace {

// A horizontal line that starts at so many 256ths.
Scene line_from(std::int64_t x) {
  const Fixed y = Fixed::from_raw(5 * Fixed::kOne / 2);
  const std::vector<Point> ends{{Fixed::from_raw(x * Fixed::kOne / 256), y},
                                {Fixed::from_integer(7), y}};
  return scene_of(Surface::fbo, 8, Primitive::lines, ends);
}

// Its answer has one fragment more, far away.
Result with_a_stray(const Scene& scene) {
  const Rendering exact = rasterize(scene, {});
  Rendering wrong = exact;
  Fragment stray = exact.fragments.front();
  stray.x = 0;
  stray.y = 7;
  wrong.fragments.push_back(stray);
  wrong.hits[exact.pixel_index(0, 7)] = 1;
  return compare(scene, {}, exact, wrong, {8});
}

void add(Ledger& ledger, std::int64_t x) {
  ledger.add({line_from(x), {}}, with_a_stray(line_from(x)));
}

Find find_of(const Candidate& candidate) {
  Find find;
  find.key = candidate.key;
  find.verdict = candidate.verdict;
  find.scene = candidate.sourced.scene;
  if (candidate.result) find.result = *candidate.result;
  return find;
}

// The candidate about the stray.
const Candidate& stray_of(const std::vector<Candidate>& candidates) {
  for (const Candidate& candidate : candidates)
    if (candidate.key.signature.kind == "extra") return candidate;
  ADD_FAILURE() << candidates.size() << " candidates";
  return candidates.front();
}

TEST(Ledger, TakesAFindAgainFromASceneThatPeopleRead) {
  Ledger ledger(Latitude::opengl, Verdict::convention);
  add(ledger, 256 + 3);
  const auto fine = ledger.take_candidates();
  ASSERT_EQ(fraction_bits_of(stray_of(fine).sourced.scene), 8);
  EXPECT_TRUE(ledger.add_find(find_of(stray_of(fine))));
  add(ledger, 256 + 5);  // no better
  EXPECT_TRUE(ledger.take_candidates().empty());
  add(ledger, 256 + 48);
  const auto readable = ledger.take_candidates();
  ASSERT_EQ(fraction_bits_of(stray_of(readable).sourced.scene), 4);
  EXPECT_EQ(stray_of(readable).key, stray_of(fine).key);
  EXPECT_FALSE(ledger.add_find(find_of(stray_of(readable)))) << "it is known";
  EXPECT_FALSE(ledger.add_find(find_of(stray_of(fine)))) << "it does not come back";
  add(ledger, 256 + 64);
  EXPECT_TRUE(ledger.take_candidates().empty()) << "once is enough";
  const std::vector<Find> finds = ledger.take_finds();
  ASSERT_EQ(finds.size(), 1u);
  EXPECT_EQ(fraction_bits_of(finds[0].scene), 4);
}

TEST(Ledger, PrefersReadableScenesAmongThoseOfARound) {
  Ledger ledger(Latitude::opengl, Verdict::convention);
  add(ledger, 256 + 48);
  add(ledger, 256 + 3);
  const auto candidates = ledger.take_candidates();
  EXPECT_EQ(fraction_bits_of(stray_of(candidates).sourced.scene), 4);
}

TEST(Ledger, HasOtherScenesOfAFindThatIsHardToRead) {
  Ledger ledger(Latitude::opengl, Verdict::convention);
  add(ledger, 256 + 3);
  ledger.add_find(find_of(stray_of(ledger.take_candidates())));
  add(ledger, 256 + 5);
  add(ledger, 256 + 6);
  EXPECT_TRUE(ledger.take_candidates().empty());
  const auto others = ledger.take_others();
  ASSERT_EQ(others.size(), 1u) << "one at a time";
  EXPECT_FALSE(others[0].result) << "many are kept, and results are large";
  EXPECT_EQ(fraction_bits_of(others[0].sourced.scene), 8);
  EXPECT_FALSE(ledger.add_find(find_of(others[0]))) << "no easier";
  const auto better = ledger.take_others();
  ASSERT_EQ(better.size(), 1u);
  EXPECT_EQ(fraction_bits_of(better[0].sourced.scene), 7);
  EXPECT_FALSE(ledger.add_find(find_of(better[0]))) << "it is known";
  EXPECT_TRUE(ledger.take_others().empty()) << "all were taken";
  const std::vector<Find> finds = ledger.take_finds();
  ASSERT_EQ(finds.size(), 1u);
  EXPECT_EQ(fraction_bits_of(finds[0].scene), 7);
}

TEST(Ledger, LooksForNothingEasierThanNeeded) {
  Ledger ledger(Latitude::opengl, Verdict::convention);
  add(ledger, 256 + 3);
  Find find = find_of(stray_of(ledger.take_candidates()));
  find.least_bits = 8;
  ledger.add_find(std::move(find));
  add(ledger, 256 + 5);
  ledger.take_candidates();
  EXPECT_TRUE(ledger.take_others().empty());
}

}  // namespace
}  // namespace edgecase
