// SPDX-License-Identifier: MIT
//
// Lines that leave the clip volume: what is seen of them, against a literal walk over all places
// where a line may enter or leave, and what they carry at their ends.
#include "model/clipped_line.h"

#include <gtest/gtest.h>

#include <set>

#include "raster/attributes.h"
#include "raster/rasterizer.h"
#include "rules/values/clipped_attributes.h"
#include "tests/raster/clipped_scenes.h"

namespace edgecase {
namespace {

constexpr Viewport kViewport{1, 2, 8, 4};

bool lies_inside(const RationalClip& p) {
  return p.w > 0 && abs(p.x) <= p.w && abs(p.y) <= p.w && abs(p.z) <= p.w;
}

// Every part of the way at which one of the six planes is crossed, 0 and 1.
std::set<Rational> crossings(const RationalClip& a, const RationalClip& b) {
  std::set<Rational> parts{0, 1};
  const auto add = [&](const Rational& from, const Rational& to) {
    if (from == to) return;
    const Rational part = from / (from - to);
    if (part > 0 && part < 1) parts.insert(part);
  };
  for (const int sign : {1, -1}) {
    add(a.w + sign * a.x, b.w + sign * b.x);
    add(a.w + sign * a.y, b.w + sign * b.y);
    add(a.w + sign * a.z, b.w + sign * b.z);
  }
  return parts;
}

TEST(ClippedLine, IsSeenBetweenTheCrossingsThatLieInside) {
  ClippedScenes scenes(3);
  int seen = 0, unseen = 0;
  for (int round = 0; round < 20000; ++round) {
    const RationalClip a = rational_clip(scenes.vertex(), kViewport);
    const RationalClip b = rational_clip(scenes.vertex(), kViewport);
    const auto part = visible_part(a, b);
    const std::set<Rational> parts = crossings(a, b);
    for (auto from = parts.begin(), to = std::next(from); to != parts.end(); ++from, ++to) {
      const Rational middle = (*from + *to) / 2;
      const bool inside = part && middle > part->from && middle < part->to;
      EXPECT_EQ(lies_inside(between(a, b, middle)), inside) << round;
    }
    ++(part ? seen : unseen);
    if (HasFailure()) return;
  }
  EXPECT_GT(seen, 2000);
  EXPECT_GT(unseen, 2000);
}

TEST(ClippedLine, HasItsEndsInTheWindowWhereTheyAreMapped) {
  ClippedScenes scenes(4);
  int cut = 0;
  for (int round = 0; round < 8000; ++round) {
    const Scene scene = scenes.scene(Primitive::lines, 2, kViewport);
    const ScenePrimitive line = primitives_of(scene).front();
    const RationalClip a = rational_clip(*line.vertices[0], kViewport);
    const RationalClip b = rational_clip(*line.vertices[1], kViewport);
    const auto part = visible_part(a, b);
    EXPECT_EQ(line.is_clipped, !part);
    if (!line.is_cut) continue;
    ++cut;
    for (const auto& [at, t] :
         {std::pair(line.positions[0], part->from), std::pair(line.positions[1], part->to)}) {
      const RationalClip end = between(a, b, t);
      EXPECT_EQ(Rational(at.x) / at.w, kViewport.x + kViewport.width * (end.x / end.w + 1) / 2);
      EXPECT_EQ(Rational(at.y) / at.w, kViewport.y + kViewport.height * (end.y / end.w + 1) / 2);
      EXPECT_GT(at.w, 0);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(cut, 500);
}

TEST(ClippedLine, CarriesTheValuesOfItsPlacesInClipSpace) {
  ClippedScenes scenes(5);
  int cut = 0;
  for (int round = 0; round < 8000; ++round) {
    const Scene scene = scenes.scene(Primitive::lines, 2, kViewport);
    const ScenePrimitive line = primitives_of(scene).front();
    if (!line.is_cut) continue;
    ++cut;
    const auto cut_line = CutLine::of(line);
    ASSERT_TRUE(cut_line.has_value());
    const RationalClip a = rational_clip(*line.vertices[0], kViewport);
    const RationalClip b = rational_clip(*line.vertices[1], kViewport);
    const auto part = visible_part(a, b);
    const Rational parts[] = {part->from, part->to};
    const auto smooth = cut_line->smooth({3, -5, 0});
    const auto window = cut_line->noperspective({3, -5, 0});
    for (std::size_t end = 0; end < 2; ++end) {
      const Rational& t = parts[end];
      const RationalClip clip = between(a, b, t);
      const auto holds = [](Interval interval, const Rational& value) {
        return rational_of(interval.low) <= value && value <= rational_of(interval.high) &&
               interval.high - interval.low < 1e-12;
      };
      EXPECT_TRUE(holds(smooth[end], 3 - 8 * t));
      EXPECT_TRUE(holds(cut_line->w()[end], clip.w));
      EXPECT_TRUE(holds(cut_line->depths()[end], clip.z / clip.w));
      if (a.w > 0 && b.w > 0) {
        // The part of the way in the window, by x or by y, where the ends differ.
        const auto part_of = [&](const Rational RationalClip::*axis) {
          return Rational((clip.*axis / clip.w - a.*axis / a.w) / (b.*axis / b.w - a.*axis / a.w));
        };
        if (a.x / a.w != b.x / b.w) {
          EXPECT_TRUE(holds(window[end], 3 - 8 * part_of(&RationalClip::x)));
        }
        if (a.y / a.w != b.y / b.w) {
          EXPECT_TRUE(holds(window[end], 3 - 8 * part_of(&RationalClip::y)));
        }
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(cut, 500);
}

// A line through the near plane draws what the line from there on draws.
TEST(ClippedLine, DrawsWhatTheLineBetweenItsEndsDraws) {
  ClippedScenes scenes(6);
  int cut = 0;
  for (int round = 0; round < 8000; ++round) {
    Scene scene = scenes.scene(Primitive::lines, 2, {0, 0, 8, 8});
    const ScenePrimitive line = primitives_of(scene).front();
    if (!line.is_cut) continue;
    Point ends[2];
    bool exact = true;
    for (std::size_t i = 0; i < 2; ++i) {
      ends[i] = nearest_point(line.positions[i]);
      exact = exact && same_point(homogeneous(ends[i]), line.positions[i]);
    }
    if (!exact) continue;
    ++cut;
    Scene given = scene;
    for (std::size_t i = 0; i < 2; ++i) {
      given.draws[0].vertices[i] = Vertex{};
      given.draws[0].vertices[i].position = ends[i];
    }
    const CoverageChoice choice = resolve({}, Surface::fbo).lines;
    EXPECT_EQ(covered_pixels(line, scene.target, choice),
              covered_pixels(primitives_of(given).front(), given.target, choice));
    if (HasFailure()) return;
  }
  EXPECT_GT(cut, 100);
}

TEST(ClippedLine, IsNotDrawnWhereNothingIsSeen) {
  Scene scene = ClippedScenes(1).scene(Primitive::lines, 2, {0, 0, 8, 8});
  scene.draws[0].vertices = {clip_vertex({2, 0, 0, 1}), clip_vertex({0, 2, 0, 1})};
  // They meet the corner (1, 1) of the volume in a single point.
  const ScenePrimitive line = primitives_of(scene).front();
  EXPECT_TRUE(line.is_clipped);
  EXPECT_FALSE(line.is_cut);
  EXPECT_TRUE(covered_pixels(line, scene.target, resolve({}, Surface::fbo).lines).empty());
  EXPECT_FALSE(CutLine::of(line).has_value());
}

// A line has two ends: what stands for a third vertex is 0, and its w 1.
TEST(ClippedLine, CarriesNothingAtAThirdEnd) {
  Scene scene = ClippedScenes(1).scene(Primitive::lines, 2, {0, 0, 8, 8});
  scene.draws[0].vertices = {clip_vertex({0, 0, 0, 1}), clip_vertex({4, 0, 0, 2})};
  const auto line = CutLine::of(primitives_of(scene).front());
  ASSERT_TRUE(line.has_value());
  for (const std::array<double, 3>& values : {std::array<double, 3>{3, 5, 7}, {4, 4, 7}})
    for (const auto& ends : {line->smooth(values), line->noperspective(values), line->depths()}) {
      EXPECT_EQ(ends[2].low, 0);
      EXPECT_EQ(ends[2].high, 0);
    }
  EXPECT_EQ(line->w()[2].low, 1);
  EXPECT_EQ(line->w()[2].high, 1);
}

}  // namespace
}  // namespace edgecase
