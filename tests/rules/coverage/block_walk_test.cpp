// SPDX-License-Identifier: MIT
//
// Block walks: what is said of a block must be so of each of its samples, edge by edge, and all
// blocks together must be the triangle.
#include "rules/coverage/block_walk.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "rules/samples/sample_placement.h"
#include "tests/support/points.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using Sizes = std::vector<int>;

// Which edges have a sample inside, bit e for edge e, sample by sample.
class Sides {
 public:
  static constexpr int kAll = 7;

  explicit Sides(const BlockGrid& grid)
      : bounds_(grid.bounds),
        samples_(grid.places.size()),
        bits_(samples_ * static_cast<std::size_t>((bounds_.x_max - bounds_.x_min + 1) *
                                                  (bounds_.y_max - bounds_.y_min + 1))) {}

  int& at(int x, int y, std::size_t s) {
    const int pixel = (y - bounds_.y_min) * (bounds_.x_max - bounds_.x_min + 1) + x - bounds_.x_min;
    return bits_[static_cast<std::size_t>(pixel) * samples_ + s];
  }
  template <class Visit>
  void for_each(const PixelBounds& pixels, Visit visit) {
    for (int y = pixels.y_min; y <= pixels.y_max; ++y)
      for (int x = pixels.x_min; x <= pixels.x_max; ++x)
        for (std::size_t s = 0; s < samples_; ++s) visit(x, y, s, at(x, y, s));
  }
  // What all edges have inside, row by row.
  std::vector<PixelSamples> covered(const PixelBounds& pixels) {
    std::vector<PixelSamples> result;
    for_each(pixels, [&](int x, int y, std::size_t s, int bits) {
      if (bits != kAll) return;
      if (result.empty() || result.back().pixel != PixelPosition{x, y})
        result.push_back({{x, y}, 0});
      result.back().covered |= std::uint32_t{1} << s;
    });
    return result;
  }

 private:
  PixelBounds bounds_;
  std::size_t samples_;
  std::vector<int> bits_;
};

// How often each decision was seen, and how many tested blocks covered nothing.
struct Seen {
  std::map<BlockDecision, long> decisions;
  long in_vain = 0;
};

// What its samples make of a block: the decision, and the edge that rejects it.
std::pair<BlockDecision, int> literal_decision(const PixelBounds& pixels, Sides& sides, bool last) {
  int some = 0, all = Sides::kAll;
  sides.for_each(pixels, [&](int, int, std::size_t, int bits) {
    some |= bits;
    all &= bits;
  });
  for (int e = 0; e < 3; ++e)
    if ((some >> e & 1) == 0) return {BlockDecision::rejected, e};
  if (all == Sides::kAll) return {BlockDecision::accepted, -1};
  return {last ? BlockDecision::tested : BlockDecision::divided, -1};
}

// Does the block start at multiples of its size, is it cut at the bounds alone, and does it meet
// the box?
bool lies_well(const WalkedBlock& block, const PixelBounds& bounds, const PixelBounds& box) {
  const PixelBounds& p = block.pixels;
  const int x = p.x_min - p.x_min % block.size, y = p.y_min - p.y_min % block.size;
  const PixelBounds whole{x, y, x + block.size - 1, y + block.size - 1};
  return p.x_min == std::max(whole.x_min, bounds.x_min) &&
         p.y_min == std::max(whole.y_min, bounds.y_min) &&
         p.x_max == std::min(whole.x_max, bounds.x_max) &&
         p.y_max == std::min(whole.y_max, bounds.y_max) && p.x_min <= box.x_max &&
         p.x_max >= box.x_min && p.y_min <= box.y_max && p.y_max >= box.y_min;
}

void check(const BlockWalk& walk, const BlockGrid& grid, Sides& sides, Seen& seen) {
  ASSERT_EQ(covered_samples(walk, static_cast<int>(grid.places.size())),
            sides.covered(grid.bounds));
  std::vector<PixelPosition> decided;
  for (const WalkedBlock& block : walk.blocks) {
    ASSERT_TRUE(lies_well(block, grid.bounds, walk.box));
    const bool last = block.size == grid.sizes.back();
    ASSERT_EQ(std::pair(block.decision, block.edge), literal_decision(block.pixels, sides, last));
    ++seen.decisions[block.decision];
    const bool tested = block.decision == BlockDecision::tested;
    ASSERT_EQ(block.covered, tested ? sides.covered(block.pixels) : std::vector<PixelSamples>());
    if (tested && block.covered.empty()) ++seen.in_vain;
    if (block.decision == BlockDecision::divided) continue;
    for (int y = block.pixels.y_min; y <= block.pixels.y_max; ++y)
      for (int x = block.pixels.x_min; x <= block.pixels.x_max; ++x) decided.push_back({x, y});
  }
  // No pixel is decided twice, and all of the box are but where there is no area.
  std::sort(decided.begin(), decided.end());
  ASSERT_EQ(std::adjacent_find(decided.begin(), decided.end()), decided.end());
  if (walk.blocks.empty()) return;
  const auto in_box = std::count_if(decided.begin(), decided.end(),
                                    [&](PixelPosition p) { return walk.box.contains(p); });
  ASSERT_EQ(in_box, (walk.box.x_max - walk.box.x_min + 1) * (walk.box.y_max - walk.box.y_min + 1));
}

void expect_all_kinds(const Seen& seen, long least) {
  for (BlockDecision decision : {BlockDecision::rejected, BlockDecision::accepted,
                                 BlockDecision::divided, BlockDecision::tested}) {
    const auto found = seen.decisions.find(decision);
    EXPECT_TRUE(found != seen.decisions.end() && found->second >= least) << name_of(decision);
  }
  EXPECT_GE(seen.in_vain, least) << "the test of three edges must be seen to be too careful";
}

// The sample as it lies after a tie rule's move, by e = 2^-8 and e^2 = 2^-16: on a grid of half
// pixels, no larger than 4, a cross product that is not 0 is at least 1/4 and changes by less than
// 2^-5, and e times a component of an edge, at least 2^-9, outweighs e^2 times the other, 2^-14.
Point literally_moved(Point sample, const TieRule& ties) {
  const auto by = [](int first, int second) { return Fixed::from_raw(first * 256 + second); };
  return {sample.x + by(ties.first_x, ties.second_x), sample.y + by(ties.first_y, ties.second_y)};
}

Sides literal_sides(const Triangle& triangle, const BlockGrid& grid, const TieRule& ties) {
  Sides sides(grid);
  const bool left = doubled_area(triangle) > 0;
  const Triangle& t = triangle;
  for (int y = grid.bounds.y_min; y <= grid.bounds.y_max; ++y)
    for (int x = grid.bounds.x_min; x <= grid.bounds.x_max; ++x) {
      const Point sample = literally_moved(pixel_centre(x, y), ties);
      for (std::size_t e = 0; e < 3; ++e) {
        const std::int64_t side = cross(t[e], t[(e + 1) % 3], sample);
        if (left ? side > 0 : side < 0) sides.at(x, y, 0) |= 1 << e;
      }
    }
  return sides;
}

// Every triangle of the half-pixel grid of 4 x 4 pixels, every order of ties, in blocks of 4, of 2
// and of 4 and then 2. Which vertex is first, and which way they run, goes round.
TEST(BlockWalk, SaysOfEveryBlockOfASmallGridWhatIsSoOfItsSamples) {
  const Sizes walks[] = {{4}, {2}, {4, 2}};
  std::vector<Point> grid;
  for (int i = 0; i < 81; ++i) grid.push_back(at(i % 9 / 2.0, i / 9 / 2.0));
  Seen seen;
  long triangles = 0;
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        Triangle t = {grid[i], grid[j], grid[k]};
        if (doubled_area(t) == 0) continue;
        std::rotate(t.begin(), t.begin() + triangles % 3, t.end());
        if (++triangles % 2 == 0) std::swap(t[0], t[1]);
        if (!is_in_share(static_cast<std::uint64_t>(triangles))) continue;
        for (const TieRule& ties : all_tie_rules()) {
          if (ties.kind != TieRule::Kind::perturbed) continue;
          Sides sides = literal_sides(t, {{0, 0, 3, 3}, walks[0]}, ties);
          for (const Sizes& sizes : walks) {
            const BlockGrid blocks{{0, 0, 3, 3}, sizes};
            check(walk_blocks(t, blocks, ties), blocks, sides, seen);
            if (HasFatalFailure())
              FAIL() << ties.name << " " << format_point(t[0]) << " " << format_point(t[1]) << " "
                     << format_point(t[2]) << " blocks of " << sizes[0];
          }
        }
      }
  EXPECT_GT(triangles, 80000);
  expect_all_kinds(seen, least_of(10000));
}

class Random {
 public:
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  // A multiple of 1/4 from -4 to 44 pixels, with any w.
  HomogeneousPoint quarter() {
    const std::int64_t by = 1 + (static_cast<std::int64_t>(random_()) >> below(32));
    return {(below(193) - 16) * by, (below(193) - 16) * by, 4 * by};
  }
  // Any quotient in the window, near the target or not.
  HomogeneousPoint quotient() {
    const std::int64_t w = 1 + (static_cast<std::int64_t>(random_()) >> below(32));
    const int reach = below(3) == 0 ? 1 << 14 : 48;
    const auto coordinate = [&] {
      const Int128 steps = Int128{random_()} - (std::int64_t{1} << 30);
      return static_cast<std::int64_t>(steps * w / (1 << 26) * reach / 64);
    };
    const std::int64_t x = coordinate();
    return {x, coordinate(), w};
  }
  SamplePositions places() {
    if (below(3) == 0) return {centre_of_pixel()};
    if (below(2) == 0) return standard_pattern(4);
    SamplePositions places(static_cast<std::size_t>(1 + below(kMaxSamples)));
    for (Point& place : places)
      place = {Fixed::from_raw(below(8) * Fixed::kOne / 8),
               Fixed::from_raw(below(8) * Fixed::kOne / 8)};
    return places;
  }

 private:
  std::mt19937 random_{static_cast<std::uint32_t>(share_seed(23))};
};

Sides sides_of(const HomogeneousTriangle& triangle, const BlockGrid& grid, const TieRule& ties) {
  Sides sides(grid);
  const bool left = cross(triangle[0], triangle[1], triangle[2]) > 0;
  sides.for_each(grid.bounds, [&](int x, int y, std::size_t s, int) {
    const HomogeneousPoint sample = homogeneous(place_in({x, y}, grid.places[s]));
    for (std::size_t e = 0; e < 3; ++e) {
      const HomogeneousPoint& a = triangle[left ? e : (e + 1) % 3];
      const HomogeneousPoint& b = triangle[left ? (e + 1) % 3 : e];
      const Int128 right = Int128{a.y} * b.w - Int128{b.y} * a.w;
      const Int128 up = Int128{b.x} * a.w - Int128{a.x} * b.w;
      if (ties.positive(cross(a, b, sample), right, up)) sides.at(x, y, s) |= 1 << e;
    }
    ASSERT_EQ(sides.at(x, y, s) == Sides::kAll, triangle_covers(triangle, sample, ties));
  });
  return sides;
}

// Quotients on and off the grid of samples, blocks of all sizes and cut at the bounds, samples
// anywhere in their pixels.
TEST(BlockWalk, SaysWhatIsSoOfQuotientsAndOfAllSamples) {
  const Sizes walks[] = {{2}, {4}, {8}, {16}, {32}, {32, 8}, {8, 2}, {16, 8, 4, 2}};
  Random random;
  Seen seen;
  for (int round = 0; round < share_of(8000, 1500); ++round) {
    HomogeneousTriangle triangle;
    for (HomogeneousPoint& p : triangle) p = round % 2 == 0 ? random.quarter() : random.quotient();
    const Int128 area = cross(triangle[0], triangle[1], triangle[2]);
    if (area == 0) continue;
    const SamplePositions places = random.places();
    const Sizes& sizes = walks[random.below(8)];
    const int x = random.below(9), y = random.below(9);
    const BlockGrid grid{{x, y, x + random.below(34), y + random.below(34)}, sizes, places};
    const TieRule& ties = all_tie_rules()[static_cast<std::size_t>(random.below(10))];
    Sides sides = sides_of(triangle, grid, ties);
    check(walk_blocks(triangle, grid, ties), grid, sides, seen);
    if (HasFatalFailure()) FAIL() << round << " " << ties.name;
  }
  expect_all_kinds(seen, least_of(300));
}

BlockWalk walked(const Triangle& triangle, const Sizes& sizes, const PixelBounds& bounds,
                 const char* ties = "left-top") {
  return walk_blocks(triangle, {bounds, sizes}, *find_tie_rule(ties));
}

// The half of a square below its diagonal: 8 x 8 pixels in four blocks of 4.
TEST(BlockWalk, CountsWhatItAsks) {
  const BlockWalk walk = walked({at(0, 0), at(8, 0), at(8, 8)}, {4}, {0, 0, 7, 7});
  ASSERT_EQ(walk.blocks.size(), 4u);
  EXPECT_EQ(walk.blocks[0].decision, BlockDecision::tested);
  EXPECT_EQ(walk.blocks[0].covered.size(), 10u);  // the diagonal is its left edge
  EXPECT_EQ(walk.blocks[1].decision, BlockDecision::accepted);
  EXPECT_EQ(walk.blocks[2].decision, BlockDecision::rejected);
  EXPECT_EQ(walk.blocks[2].edge, 2);
  EXPECT_EQ(walk.blocks[3].decision, BlockDecision::tested);
  // Three corners most inside and three most outside for each, but for the rejected one; and the
  // samples of two blocks, of the diagonal alone.
  EXPECT_EQ(walk.evaluations, 3 * 6 + 3 + 2 * 16);
  // All three edges of each of the 64 samples: only the last can have one outside.
  EXPECT_EQ(walk.plain_evaluations, 3 * 64);
  // In a block of 8 first, which two edges have wholly inside: the third alone is asked further.
  EXPECT_EQ(walked({at(0, 0), at(8, 0), at(8, 8)}, {8, 4}, {0, 0, 7, 7}).evaluations,
            6 + 3 * 2 + 1 + 2 * 16);
}

// Pixels whose centres lie on the diagonal decide what becomes of the blocks beside it.
TEST(BlockWalk, TiesDecideOverCorners) {
  const Triangle triangle = {at(0, 0), at(4, 0), at(4, 4)};
  const PixelBounds one{0, 0, 0, 0};
  for (const char* ties : {"left-top", "left-bottom", "top-left", "top-right", "closed"})
    EXPECT_EQ(walked(triangle, {2}, one, ties).blocks[0].decision, BlockDecision::accepted) << ties;
  for (const char* ties : {"right-top", "right-bottom", "bottom-left", "bottom-right", "open"})
    EXPECT_EQ(walked(triangle, {2}, one, ties).blocks[0].decision, BlockDecision::rejected) << ties;
}

// A wedge that opens to the right: of the lower left block its upper edge has samples inside, its
// lower edge has others, and between the two there is none.
TEST(BlockWalk, MayTestABlockInVain) {
  const BlockWalk walk = walked({at(3.25, 2), at(8, 1.25), at(8, 3)}, {4}, {0, 0, 7, 7});
  ASSERT_FALSE(walk.blocks.empty());
  EXPECT_EQ(walk.blocks[0].decision, BlockDecision::tested);
  EXPECT_TRUE(walk.blocks[0].covered.empty());
}

TEST(BlockWalk, LeavesWhatHasNoAreaOrNoSampleAlone) {
  const PixelBounds bounds{0, 0, 7, 7};
  EXPECT_TRUE(walked({at(1, 1), at(3, 3), at(5, 5)}, {8}, bounds).blocks.empty());
  EXPECT_TRUE(walked({at(9, 1), at(12, 3), at(9, 5)}, {8}, bounds).blocks.empty());
  EXPECT_TRUE(walked({at(-4, -4), at(0, -4), at(0, 0)}, {8}, bounds).blocks.empty());
  // Between two columns of centres, and within the bounds.
  EXPECT_TRUE(walked({at(5.625, 1), at(6.375, 3), at(5.75, 5)}, {8}, bounds).blocks.empty());
}

}  // namespace
}  // namespace edgecase
