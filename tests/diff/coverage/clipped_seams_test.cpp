// SPDX-License-Identifier: MIT
//
// Ruling 5 of triangles that reach out of the clip volume: random pairs beside one seam, each with
// a hole or a double hit that is planted where a few lines of rational arithmetic say that it
// counts; and drawings of lawful renderers, which have none.
#include "diff/coverage/clipped_seams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

#include "tests/support/judging.h"

namespace edgecase {
namespace {

constexpr int kSide = 16;  // pixels
constexpr int kScale = 256;

struct Place {
  int x = 0;  // in 1/256 pixel
  int y = 0;
};

Vertex vertex_at(Place p) {
  const auto to_clip = [](int v) { return 2 * static_cast<float>(v) / (kScale * kSide) - 1; };
  Vertex vertex;
  vertex.clip = ClipPosition{to_clip(p.x), to_clip(p.y), 0, 1};
  return vertex;
}

std::int64_t turn(Place a, Place b, Place c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

// The seam from a to b, and a third vertex on each side; that of the first triangle lies outside.
struct Pair {
  Place a, b, left, right;

  Scene scene() const {
    Scene scene;
    scene.target.width = scene.target.height = kSide;
    scene.viewport = {0, 0, kSide, kSide};
    Draw draw;
    for (const Place p : {a, b, left, b, a, right}) draw.vertices.push_back(vertex_at(p));
    scene.draws.push_back(std::move(draw));
    return scene;
  }

  // Whether a centre is further than an eighth of a pixel, along both axes, inside the edges beside
  // the seam.
  bool is_clear(PixelPosition pixel) const {
    const Place s{pixel.x * kScale + kScale / 2, pixel.y * kScale + kScale / 2};
    const auto is_inside = [&](Place from, Place to, Place third) {
      const std::int64_t sign = turn(from, to, third) > 0 ? 1 : -1;
      const std::int64_t margin =
          (std::abs(to.x - from.x) + std::abs(to.y - from.y)) * std::int64_t{kScale / 8};
      return sign * turn(from, to, s) > margin;
    };
    return is_inside(a, left, b) && is_inside(b, left, a) && is_inside(a, right, b) &&
           is_inside(b, right, a);
  }
};

class Pairs {
 public:
  explicit Pairs(unsigned seed) : random_(seed) {}

  Pair next() {
    for (;;) {
      const bool is_through_centres = random_() % 2 == 0;
      const bool is_cut = random_() % 3 == 0;
      const auto end = [&](int low, int high) {
        const Place p = place(low, high);
        const auto centre = [](int v) { return v / kScale * kScale + kScale / 2; };
        return is_through_centres ? Place{centre(p.x), centre(p.y)} : p;
      };
      const Pair pair{end(1, 15), is_cut ? end(-20, 36) : end(1, 15), place(-40, 56), place(0, 16)};
      const bool leaves = pair.left.x < 0 || pair.left.x > kSide * kScale || pair.left.y < 0 ||
                          pair.left.y > kSide * kScale;
      const std::int64_t one = turn(pair.a, pair.b, pair.left);
      const std::int64_t other = turn(pair.a, pair.b, pair.right);
      if (leaves && ((one > 0 && other < 0) || (one < 0 && other > 0))) return pair;
    }
  }

 private:
  Place place(int low, int high) {
    std::uniform_int_distribution<int> in(low * kScale, high * kScale - 1);
    return {in(random_), in(random_)};
  }
  std::mt19937 random_;
};

std::vector<SharedEdgeFault> faults_of(const Scene& scene, const Rendering& drawn) {
  const auto primitives = primitives_of(scene);
  return clipped_seam_faults(primitives, match_coverage(primitives.size(), drawn, drawn), scene, 8,
                             {centre_of_pixel()}, false);
}

// However ties are broken, vertices snapped and polygons cut.
TEST(ClippedSeams, LawfulDrawingsHaveNone) {
  Pairs pairs(1);
  for (int i = 0; i < 300; ++i) {
    const Scene scene = pairs.next().scene();
    for (const Choices& rules :
         {Choices{}, Choices{{"triangle.fill-rule", "right-top"}},
          Choices{{"clip.volume", "polygon"}, {"triangle.snap", "8-half-even"}},
          Choices{{"clip.volume", "polygon"}, {"triangle.snap", "8-truncate"}},
          Choices{{"clip.volume", "guard-band"}, {"triangle.snap", "8-half-up"}}})
      ASSERT_EQ(faults_of(scene, rasterize(scene, policy_of(rules))).size(), 0u) << i;
  }
}

TEST(ClippedSeams, AHoleAndADoubleHitAreFaultsWhereTheyAreClear) {
  Pairs pairs(2);
  int holes = 0;
  for (int i = 0; i < 300; ++i) {
    const Pair pair = pairs.next();
    const Scene scene = pair.scene();
    const Rendering exact = rasterize(scene, {});
    for (std::size_t f = 0; f < exact.fragments.size(); ++f) {
      const Fragment& fragment = exact.fragments[f];
      const PixelPosition pixel{fragment.x, fragment.y};
      const Place centre{pixel.x * kScale + kScale / 2, pixel.y * kScale + kScale / 2};
      if (turn(pair.a, pair.b, centre) != 0 || !pair.is_clear(pixel)) continue;
      Rendering holed = exact;
      holed.fragments.erase(holed.fragments.begin() + static_cast<std::ptrdiff_t>(f));
      EXPECT_EQ(faults_of(scene, holed).size(), 1u) << i;
      Rendering doubled = exact;
      Fragment again = fragment;
      again.primitive = 1 - again.primitive;
      doubled.fragments.push_back(again);
      std::ranges::sort(doubled.fragments, {}, [](const Fragment& one) {
        return std::tuple(one.primitive, one.y, one.x);
      });
      EXPECT_EQ(faults_of(scene, doubled).size(), 1u) << i;
      ++holes;
    }
  }
  EXPECT_GT(holes, 100);
}

TEST(ClippedSeams, AreViolationsOfRuling5) {
  // From (4.5, -4) to (4.5, 12), through the centres of column 4.
  const Pair pair{{1152, -1024}, {1152, 3072}, {-2048, 1024}, {5120, 1024}};
  Scene scene = pair.scene();
  Rendering drawn = rasterize(scene, {});
  std::erase_if(drawn.fragments, [](const Fragment& f) { return f.x == 4 && f.y == 5; });
  const Result result = judged(scene, drawn);
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_TRUE(broken_rulings(result).contains(5));
}

}  // namespace
}  // namespace edgecase
