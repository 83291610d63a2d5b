// SPDX-License-Identifier: MIT
//
// Probes of neighbours: segments that follow each other, triangles with common edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "profile/coverage/coverage.h"
#include "rules/coverage/line_joints.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"
#include "tests/generate/scene_checks.h"

namespace edgecase {
namespace {

std::vector<Segment> segments_of(const Scene& scene) {
  std::vector<Segment> result;
  for (const ScenePrimitive& primitive : primitives_of(scene))
    result.push_back({primitive.vertices[0]->position, primitive.vertices[1]->position});
  return result;
}

std::vector<Triangle> triangles_of(const Scene& scene) {
  std::vector<Triangle> result;
  for (const ScenePrimitive& primitive : primitives_of(scene))
    result.push_back({primitive.vertices[0]->position, primitive.vertices[1]->position,
                      primitive.vertices[2]->position});
  return result;
}

PixelPosition pixel_at(Point p) {
  return {static_cast<int>(p.x.floor()), static_cast<int>(p.y.floor())};
}

// Corners on the right and top belong to the pixel left of and below them, too.
bool has_place(Point p, DiamondPlace place) {
  const PixelPosition pixel = pixel_at(p);
  return place_in_pixel(p, pixel) == place || place_in_pixel(p, {pixel.x - 1, pixel.y}) == place ||
         place_in_pixel(p, {pixel.x, pixel.y - 1}) == place;
}

TEST(JointProbes, GoOnOrTurnAsTheySay) {
  std::map<std::tuple<LineDirection, DiamondPlace, Primitive>, int> placed;
  std::map<std::size_t, int> lengths;
  std::set<DiamondPlace> anywhere;
  int turning = 0;
  const std::vector<JointProbe> probes = joint_probes(Surface::fbo);
  for (const JointProbe& probe : probes) {
    ASSERT_EQ(fault_of(probe.scene), "");
    const std::vector<Segment> segments = segments_of(probe.scene);
    ASSERT_TRUE(segments.size() >= 2 && segments.size() <= 6);
    ++lengths[segments.size()];
    int turns = 0;
    for (std::size_t i = 1; i < segments.size(); ++i) {
      ASSERT_EQ(segments[i - 1].b, segments[i].a);
      if (!goes_on(segments[i - 1], segments[i])) ++turns;
    }
    ASSERT_EQ(turns, probe.goes_on ? 0 : 1);
    ASSERT_TRUE(!probe.place || has_place(segments[0].b, *probe.place));
    if (!probe.goes_on) ++turning;
    if (probe.direction) {
      for (const Segment& segment : segments) ASSERT_EQ(direction_of(segment), *probe.direction);
      ++placed[{*probe.direction, *probe.place, probe.scene.draws[0].primitive}];
    } else if (probe.goes_on) {
      for (std::size_t i = 1; i < segments.size(); ++i)
        if (const auto place = place_in_pixel(segments[i].a, pixel_at(segments[i].a)))
          anywhere.insert(*place);
    }
  }
  EXPECT_EQ(placed.size(), 16u * 13 * 2);
  for (const auto& [key, count] : placed) EXPECT_EQ(count, 2);
  EXPECT_GE(anywhere.size(), 9u);
  for (std::size_t n = 2; n <= 6; ++n) EXPECT_GE(lengths[n], 60) << n;
  EXPECT_GE(turning, 150);
  std::printf("%zu joint probes, %d of them turning\n", probes.size(), turning);
}

// Some numbers of these come from a generator with a fixed seed.
TEST(JointAndClipProbes, AreTheSameOnEveryMachine) {
  std::uint64_t joints = 0;
  for (const JointProbe& probe : joint_probes(Surface::fbo))
    joints = joints * 31 + fingerprint_of(probe.scene);
  EXPECT_EQ(joints, 8217141386090967156u);
  std::uint64_t clips = 0;
  for (const ClipProbe& probe : clip_probes(Surface::fbo))
    clips = clips * 31 + fingerprint_of(probe.scene);
  EXPECT_EQ(clips, 10738949259881803298u);
}

bool lies_between(Point a, Point b, Point p) {
  if (cross(a, b, p) != 0 || p == a || p == b) return false;
  const auto [left, right] = std::minmax({a.x, b.x});
  const auto [low, high] = std::minmax({a.y, b.y});
  return p.x >= left && p.x <= right && p.y >= low && p.y <= high;
}

// Is a vertex of one triangle inside another, or on its edge but for the edge's ends?
bool meets_elsewhere(const Triangle& triangle, const Triangle& other) {
  const Triangle t = counter_clockwise(triangle);
  for (Point p : other) {
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      if (lies_between(t[i], t[(i + 1) % 3], p)) return true;
      inside = inside && cross(t[i], t[(i + 1) % 3], p) > 0;
    }
    if (inside) return true;
  }
  return false;
}

// How many samples lie on an edge that triangles share, where ruling 5 wants one hit exactly.
int bound_samples(const std::vector<Triangle>& triangles, int size, bool closed) {
  int count = 0;
  const std::size_t n = triangles.size();
  for (std::size_t i = 0; i < (closed ? n : n - 1); ++i) {
    const auto edge = shared_edge(triangles[i], triangles[(i + 1) % n]);
    for (int y = 0; edge && y < size; ++y)
      for (int x = 0; x < size; ++x)
        if (const Point p = pixel_centre(x, y);
            lies_between(edge->a, edge->b, p) && must_hit_once(*edge, p, grid_step(8)))
          ++count;
  }
  return count;
}

TEST(SharedEdgeProbes, ShareEdgesAndNothingElse) {
  std::map<SharedEdgeShape, int> shapes;
  std::set<std::size_t> fans;
  std::size_t pairs = 0;
  long samples = 0;
  const std::vector<SharedEdgeProbe> probes = shared_edge_probes(Surface::fbo);
  for (const SharedEdgeProbe& probe : probes) {
    ASSERT_EQ(fault_of(probe.scene), "");
    const std::vector<Triangle> triangles = triangles_of(probe.scene);
    const std::size_t n = triangles.size();
    ++shapes[probe.shape];
    if (probe.shape == SharedEdgeShape::fan) fans.insert(n);
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_NE(doubled_area(triangles[i]), 0);
      if (i + 1 == n && !probe.closed) continue;
      ASSERT_TRUE(shared_edge(triangles[i], triangles[(i + 1) % n]))
          << name_of(probe.shape) << " of " << n << ", " << i;
      ++pairs;
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        ASSERT_FALSE(i != j && meets_elsewhere(triangles[i], triangles[j]))
            << name_of(probe.shape) << " of " << n << ", " << i << " and " << j;
    if (n <= 12) samples += bound_samples(triangles, probe.scene.target.width, probe.closed);
  }
  for (const SharedEdgeShape shape :
       {SharedEdgeShape::quad, SharedEdgeShape::strip, SharedEdgeShape::fan})
    EXPECT_GE(shapes[shape], 100) << name_of(shape);
  EXPECT_EQ(*fans.begin(), 3u);
  EXPECT_EQ(*fans.rbegin(), 64u);
  EXPECT_GT(samples, 500);
  std::printf(
      "%zu shared-edge probes, %zu common edges, %ld samples on edges of shapes of up to "
      "12 triangles that must be hit once\n",
      probes.size(), pairs, samples);
}

// The angles of a closed fan's triangles add up to one turn: as many rim vertices rise through the
// hub's row on its right as the fan has rounds.
TEST(SharedEdgeProbes, FansGoRoundOnce) {
  int closed = 0;
  for (const SharedEdgeProbe& probe : shared_edge_probes(Surface::fbo)) {
    const std::vector<Vertex>& v = probe.scene.draws[0].vertices;
    if (!probe.closed || probe.scene.draws[0].primitive != Primitive::triangle_fan) continue;
    ++closed;
    ASSERT_EQ(v[1].position, v.back().position);
    const Point hub = v[0].position;
    int rounds = 0;
    for (std::size_t i = 2; i < v.size(); ++i) {
      const Point p = v[i - 1].position;
      const Point q = v[i].position;
      ASSERT_GT(cross(hub, p, q), 0);
      if (p.y < hub.y && q.y >= hub.y) ++rounds;
    }
    ASSERT_EQ(rounds, 1);
  }
  EXPECT_GE(closed, 200);
}

}  // namespace
}  // namespace edgecase
