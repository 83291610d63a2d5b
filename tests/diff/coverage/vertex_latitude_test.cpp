// SPDX-License-Identifier: MIT
//
// Ruling 15: what a division by w may err is held against nobody, and no more than that.
#include "diff/coverage/vertex_latitude.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "diff/compare.h"
#include "diff/coverage/coverage_diff.h"
#include "diff/coverage/coverage_report.h"
#include "diff/coverage/legality.h"
#include "diff/coverage/sample_legality.h"
#include "diff/coverage/shared_edge_faults.h"
#include "diff/coverage/situation.h"
#include "raster/rasterizer.h"
#include "tests/diff/named_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

constexpr int kSize = 16;

Scene clip_scene(Primitive primitive, std::vector<ClipPosition> positions) {
  Scene scene;
  scene.target.width = kSize;
  scene.target.height = kSize;
  scene.viewport = {0, 0, kSize, kSize};
  Draw draw;
  draw.primitive = primitive;
  for (const ClipPosition& clip : positions) {
    Vertex vertex;
    vertex.position = nearest_point(window_position(clip, scene.viewport));
    vertex.clip = clip;
    vertex.w = clip.w;
    draw.vertices.push_back(vertex);
  }
  scene.draws = {draw};
  return scene;
}

// The same scene as a renderer sees it whose divisions erred by at most `units` of 2^-16 pixel.
class Erring {
 public:
  Scene operator()(Scene scene, std::int64_t units) {
    const auto move = [&](Fixed value) {
      const bool far = between(0, 2) != 0;
      return value +
             Fixed::from_raw(far ? units * (2 * between(0, 1) - 1) : between(-units, units));
    };
    // Bit-identical vertices err alike.
    std::vector<std::pair<ClipPosition, Point>> known;
    for (Vertex& vertex : scene.draws[0].vertices) {
      Point at{move(vertex.position.x), move(vertex.position.y)};
      for (const auto& [clip, placed] : known)
        if (clip == *vertex.clip) at = placed;
      known.emplace_back(*vertex.clip, at);
      vertex.position = at;
      vertex.clip.reset();
      vertex.w = 1;
    }
    return scene;
  }
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }
  // Often on the grid of 1/2 pixel, where ties are, with a w that hides it.
  ClipPosition position() {
    constexpr float kW[] = {2, 3, 5, 7, 0.375F};
    const float w = kW[between(0, 4)];
    const auto coordinate = [&] {
      return between(0, 3) == 0 ? static_cast<float>(between(-999, 999)) / 1000 * w
                                : static_cast<float>(between(-15, 15)) / 16 * w;
    };
    const float x = coordinate();
    return {x, coordinate(), 0, w};
  }

 private:
  std::mt19937_64 random_{29};
};

// What ruling 15 allows anywhere in a viewport of 16 pixels is at least 1/10^5 of 8 pixels.
constexpr std::int64_t kAllowed = 8 * Fixed::kOne / 100000;

Verdict verdict(const Scene& scene, const Scene& seen, const Policy& how, int bits) {
  return judged(scene, compose(scene, rasterize(seen, how).fragments), {}, bits).verdict;
}

TEST(DivisionError, IsThreePartsInTenToTheFifth) {
  const Viewport viewport{10, 0, 100, 200};
  Vertex vertex;
  EXPECT_EQ(division_error(vertex, {}, viewport), Fixed());
  vertex.w = 2;
  // x: (2 |30 - 60| + 30) = 90, y: (2 |150 - 100| + 150) = 250, in 10^5 parts, and a raw unit.
  const Point at{Fixed::from_integer(30), Fixed::from_integer(150)};
  const std::int64_t parts = 250 * Fixed::kOne;
  EXPECT_EQ(division_error(vertex, at, viewport).raw(), (parts + 99999) / 100000 + 1);
  const Point wide{Fixed::from_integer(-150), Fixed::from_integer(100)};
  EXPECT_EQ(division_error(vertex, wide, viewport).raw(),
            ((2 * 210 + 150) * Fixed::kOne + 99999) / 100000 + 1);
  vertex.w = 1;
  vertex.clip = ClipPosition{};
  EXPECT_GT(division_error(vertex, at, viewport), Fixed());
}

TEST(BitIdentity, IsOfWhatTheVertexIsGivenBy) {
  Vertex a;
  Vertex b;
  EXPECT_TRUE(is_bit_identical(a, b));
  b.color = {0, 0, 0, 1};
  EXPECT_TRUE(is_bit_identical(a, b));
  b.w = 2;
  EXPECT_FALSE(is_bit_identical(a, b));
  a.clip = ClipPosition{};
  EXPECT_FALSE(is_bit_identical(a, b));
  b.clip = ClipPosition{};
  EXPECT_TRUE(is_bit_identical(a, b)) << "clip coordinates are all that counts";
  b.clip->w = 2;
  EXPECT_FALSE(is_bit_identical(a, b));
}

// Whatever a renderer's divisions erred, and however it snaps and breaks ties: no violation.
TEST(Ruling15, ConvictsNoRendererWhoseDivisionErred) {
  Erring erring;
  std::map<Verdict, int> verdicts;
  for (int round = 0; round < 1500; ++round)
    for (Primitive kind : {Primitive::points, Primitive::line_strip, Primitive::triangle_strip}) {
      std::vector<ClipPosition> positions;
      for (int i = 0; i < 4; ++i) positions.push_back(erring.position());
      Scene scene = clip_scene(kind, positions);
      scene.draws[0].line_width = Fixed::from_integer(round % 5 == 0 ? 3 : 1);
      Policy how;
      constexpr const char* kSnaps[] = {"none", "8-half-even", "8-truncate", "12-half-up"};
      how.rules["subpixel.snap"] = kSnaps[erring.between(0, 3)];
      const int bits = how.rules["subpixel.snap"] == "12-half-up" ? 12 : 8;
      const Verdict found = verdict(scene, erring(scene, kAllowed), how, bits);
      ASSERT_NE(found, Verdict::violation) << name_of(kind) << " " << round;
      ++verdicts[found];
    }
  EXPECT_GT(verdicts[Verdict::convention] + verdicts[Verdict::permitted], 100);
}

// One rendering, and only w differs: a vertex that is not divided errs by less. Of x, at 3 of 16
// pixels, 13 parts with a division, and 8 without.
TEST(Ruling15, IsLargerForVerticesThatAreDivided) {
  const auto at = [](std::int64_t beside) {
    return Point{Fixed::from_raw(3 * Fixed::kOne + beside), Fixed::from_raw(17 * Fixed::kOne / 4)};
  };
  Scene given = clip_scene(Primitive::points, {{0, 0, 0, 1}});
  Vertex& vertex = given.draws[0].vertices[0];
  vertex.clip.reset();
  vertex.position = at(8);
  Scene seen = given;
  seen.draws[0].vertices[0].position = at(-8);
  EXPECT_EQ(verdict(given, seen, {}, 16), Verdict::violation);
  vertex.w = 3;
  EXPECT_NE(verdict(given, seen, {}, 16), Verdict::violation);
  // -0.625 of 8 pixels is 3, and 8 raw units of 2^-16 pixel are 8 * 2^-19 of them.
  vertex.clip = ClipPosition{-0.625F + 8.0F / (1 << 19), -0.46875F, 0, 1};
  ASSERT_EQ(nearest_point(primitives_of(given)[0].positions[0]), vertex.position);
  EXPECT_NE(verdict(given, seen, {}, 16), Verdict::violation);
}

// A pixel's centre 1/128 pixel inside the right edge, 1996 pixels from the left of the viewport.
Scene far_right_edge(float w) {
  Scene scene;
  scene.target.width = 2048;
  scene.target.height = 4;
  scene.viewport = {0, 0, 2048, 4};
  Draw draw;
  const Fixed x = Fixed::from_raw(1996 * Fixed::kOne + 65 * Fixed::kOne / 128);
  for (const Point at : {Point{Fixed::from_integer(1990), Fixed()}, Point{x, Fixed()},
                         Point{x, Fixed::from_integer(4)}}) {
    Vertex vertex;
    vertex.position = at;
    vertex.w = w;
    draw.vertices.push_back(vertex);
  }
  scene.draws = {draw};
  return scene;
}

// 2.3.4.1 speaks of each operation: the position of a vertex is a product and a sum whatever w is.
// Where that is less than the step of ruling 4, w = 1 adds nothing to it.
TEST(Ruling15, IsForEveryWFarFromTheCentre) {
  for (const float w : {1.0F, 2.0F}) {
    const Scene given = far_right_edge(w);
    const auto moved_left_by = [&](std::int64_t raw) {
      Scene seen = given;
      for (std::size_t i : {1U, 2U}) {
        Point& at = seen.draws[0].vertices[i].position;
        at.x = at.x - Fixed::from_raw(raw);
      }
      return verdict(given, seen, {}, 8);
    };
    // 9 parts in 10^6 of the 972 pixels from the viewport's centre are 1/114 pixel.
    EXPECT_NE(moved_left_by(9 * 972 * Fixed::kOne / 1000000), Verdict::violation) << w;
    EXPECT_EQ(moved_left_by(Fixed::kOne / 2), Verdict::violation) << w;
  }
  const ScenePrimitive far = primitives_of(far_right_edge(1))[0];
  // (972.5 + 1996.5) parts in 10^5, and a little more for 1/128.
  EXPECT_NEAR(scaling_error(far).to_double(), 0.02969, 0.00002);
  EXPECT_EQ(reach_of(far, 8), scaling_error(far));
  EXPECT_EQ(reach_of(far, 4), grid_step(4));
}

// Far more than a division may err: points and triangles beyond a step of 8 bits and ruling 15.
TEST(Ruling15, ConvictsWhatErrsByMore) {
  const Scene scene = clip_scene(Primitive::triangles,
                                 {{-2.5F, -2.5F, 0, 3}, {2.5F, -2.5F, 0, 3}, {-2.5F, 2.5F, 0, 3}});
  // The diagonal from (14.67, 1.33) to (1.33, 14.67) runs through the centres with x + y = 15.
  Scene seen = scene;
  const auto moved_by = [&](std::int64_t raw) {
    for (std::size_t i = 0; i < 3; ++i) {
      Vertex& vertex = seen.draws[0].vertices[i];
      vertex = scene.draws[0].vertices[i];
      vertex.position.x = vertex.position.x - Fixed::from_raw(raw);
      vertex.position.y = vertex.position.y - Fixed::from_raw(raw);
      vertex.clip.reset();
      vertex.w = 1;
    }
    return verdict(scene, seen, {}, 8);
  };
  const Fixed error = division_error(primitives_of(scene)[0]);
  EXPECT_GT(error, Fixed());
  // A sample on the edge may always go either way; those one row further are 1/2 pixel off.
  EXPECT_NE(moved_by(Fixed::kOne / 256 + error.raw() - 1), Verdict::violation);
  EXPECT_EQ(moved_by(3 * Fixed::kOne / 4), Verdict::violation);
}

// A sample just beyond the step of ruling 4 is still within ruling 15, and beyond both it is not.
TEST(Ruling15, AddsToTheStepOfRuling4) {
  const auto judged = [&](std::int64_t beyond) {
    // A point of size 1 whose right side lies `beyond` raw units left of the centre (8.5, 4.5).
    Scene scene = clip_scene(Primitive::points, {{0, 0, 0, 2}});
    Vertex& vertex = scene.draws[0].vertices[0];
    vertex.clip.reset();
    vertex.position = {Fixed::from_raw(8 * Fixed::kOne - beyond),
                       Fixed::from_raw(9 * Fixed::kOne / 2)};
    const ScenePrimitive point = primitives_of(scene)[0];
    return judge_sample(point, {{8, 4}, 0, 0, 1}, centre_of_pixel(), 8);
  };
  // Of y: 2 |4.5 - 8| + 4.5 = 11.5 parts; of x 8 and a little.
  const std::int64_t reach = Fixed::kOne / 256 + (23 * Fixed::kOne / 2 + 99999) / 100000 + 1;
  EXPECT_TRUE(judged(reach - 1).legal);
  EXPECT_FALSE(judged(reach).legal);
  EXPECT_EQ(judged(reach).reason,
            "no move of the vertex by less than 1/256 pixel and 0.00014 by the division by w "
            "(ruling 15) could put the sample inside or on the boundary");
}

// Where nothing is near the middle between two grid lines, snapping hides what the division erred.
TEST(SnappedSegment, ReachesTheGridLinesThatAnErrorReaches) {
  const Scene scene = clip_scene(Primitive::lines, {{0.25F, 0, 0, 3}, {0.5F, 1, 0, 1.5F}});
  const ScenePrimitive line = primitives_of(scene)[0];
  // (8 + 2/3, 8) and (13 + 1/3, 13 + 1/3): thirds of a step of 4 bits lie far from the middle.
  const LooseSegment coarse = snapped_segment(line, *find_snap("4-half-even"), end_errors(line));
  EXPECT_EQ(coarse.reach, Fixed());
  EXPECT_EQ(coarse.segment.a.x, Fixed::from_raw(139 * Fixed::kOne / 16));
  // Truncated, the coordinate that lies on a grid line may fall below it.
  EXPECT_EQ(snapped_segment(line, *find_snap("4-truncate"), end_errors(line)).reach, grid_step(4));
  const LooseSegment given = snapped_segment(line, Snap{}, end_errors(line));
  EXPECT_EQ(given.reach, division_error(line));
}

// Two triangles share an edge when its ends are given by the same clip coordinates.
TEST(SharedEdge, IsOneOfBitIdenticalVertices) {
  const ClipPosition a{-1.5F, -1.5F, 0, 2};
  const ClipPosition b{1.5F, 1.5F, 0, 2};
  const auto holes = [&](const ClipPosition& other) {
    const Scene scene = clip_scene(Primitive::triangles,
                                   {a, b, {-1.5F, 1.5F, 0, 2}, other, b, {1.5F, -1.5F, 0, 2}});
    const auto primitives = primitives_of(scene);
    Rendering drawn = rasterize(scene, {});
    std::erase_if(drawn.fragments, [](const Fragment& f) { return f.x == 7 && f.y == 7; });
    return shared_edge_faults(primitives, match_coverage(2, drawn, drawn), scene, 8).size();
  };
  EXPECT_EQ(holes(a), 1u);
  EXPECT_EQ(holes({-0.75F, -0.75F, 0, 1}), 0u) << "one point, but not the same numbers";
}

TEST(ClipCoordinates, AreExplainedAsQuotients) {
  const Scene scene = clip_scene(Primitive::points, {{-0.75F, 0.46875F, 0, 3}});
  const ScenePrimitive point = primitives_of(scene)[0];
  const RuleChoices choices = resolve({}, Surface::fbo);
  const std::string note =
      "; vertices given as clip coordinates are quotients by w, here given to the nearest 1/65536 "
      "pixel";
  const std::string tie = explain(point, pixel_centre(5, 9), scene.target, choices.points).text;
  EXPECT_TRUE(tie.ends_with(note)) << tie;
  // A bit to the left the nearest multiple still ties, and the quotient does not.
  Scene off = scene;
  off.draws[0].vertices[0].clip->x = std::nextafter(-0.75F, -1.0F);
  const std::string other =
      explain(primitives_of(off)[0], pixel_centre(5, 9), off.target, choices.points).text;
  EXPECT_TRUE(other.ends_with(note + ", and as quotients they cover the pixel")) << other;
  Policy snapping;
  snapping.rules["subpixel.snap"] = "8-half-even";
  const auto snapped =
      explain(point, pixel_centre(5, 9), scene.target, resolve(snapping, Surface::fbo).points).text;
  EXPECT_EQ(snapped.find("quotient"), std::string::npos);
  EXPECT_EQ(situation_of(point, pixel_centre(5, 9), scene.target),
            "point of size 1, centre exactly on the left side, to the nearest 1/65536 pixel");
}

}  // namespace
}  // namespace edgecase
