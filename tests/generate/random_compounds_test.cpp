// SPDX-License-Identifier: MIT
//
// Joints, fans and vertices round sub-pixel steps: the same every time, exact on their way to
// OpenGL, with ties enough, and of all the forms that they promise.
#include "generate/random_scenes.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "generate/random_shapes.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/triangle_fill.h"
#include "tests/generate/scene_checks.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kScenes = 4'000;
constexpr std::uint64_t kSeed = 7;

using MakeScene = Scene (*)(std::uint64_t, Surface, std::uint64_t);

struct Generator {
  const char* name;
  MakeScene make;
};
constexpr Generator kGenerators[] = {
    {"joints", random_joint_scene}, {"fans", random_fan_scene}, {"snapping", random_snap_scene}};

TEST(RandomCompounds, AreAFunctionOfSeedAndIndex) {
  for (const Generator& generator : kGenerators) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t index = 0; index < 500; ++index) {
      const std::uint64_t print = fingerprint_of(generator.make(kSeed, Surface::fbo, index));
      ASSERT_EQ(print, fingerprint_of(generator.make(kSeed, Surface::fbo, index)));
      ASSERT_NE(print, fingerprint_of(generator.make(kSeed + 1, Surface::fbo, index)));
      Scene on_window = generator.make(kSeed, Surface::window, index);
      ASSERT_EQ(on_window.target.surface, Surface::window);
      on_window.target.surface = Surface::fbo;
      ASSERT_EQ(print, fingerprint_of(on_window));
      seen.insert(print);
    }
    EXPECT_GT(seen.size(), 490u) << generator.name;
  }
}

// Finds are named by seed and index: these scenes change on purpose or not at all.
TEST(RandomCompounds, AreTheSameOnEveryMachine) {
  std::uint64_t sum = 0;
  for (const Generator& generator : kGenerators)
    for (std::uint64_t index = 0; index < 2'000; ++index)
      sum = sum * 31 + fingerprint_of(generator.make(kSeed, Surface::fbo, index));
  EXPECT_EQ(sum, 3121418614995933358u);
}

TEST(RandomCompounds, ReachOpenGlExactlyAndAThirdHoldsATie) {
  for (const Generator& generator : kGenerators) {
    std::uint64_t ties = 0;
    for (std::uint64_t index = 0; index < kScenes; ++index) {
      const Scene scene = generator.make(kSeed, Surface::fbo, index);
      ASSERT_EQ(fault_of(scene), "") << generator.name << " " << index;
      ASSERT_EQ(scene.draws.size(), 1u);
      if (has_tie(scene)) ++ties;
    }
    std::printf("%s: %.1f %% hold a tie\n", generator.name,
                100.0 * static_cast<double>(ties) / static_cast<double>(kScenes));
    EXPECT_GE(3 * ties, kScenes) << generator.name;
  }
}

TEST(RandomJoints, AreStripsLoopsAndLinesWhoseSegmentsMeet) {
  std::map<Primitive, int> primitives;
  int wide = 0;
  int going_on = 0;
  int joints = 0;
  for (std::uint64_t index = 0; index < kScenes; ++index) {
    const Scene scene = random_joint_scene(kSeed, Surface::fbo, index);
    ++primitives[scene.draws[0].primitive];
    if (scene.draws[0].line_width != Fixed::from_integer(1)) ++wide;
    const auto lines = primitives_of(scene);
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const Point end = lines[i - 1].vertices[1]->position;
      ASSERT_EQ(end, lines[i].vertices[0]->position);
      ++joints;
      const Segment before{lines[i - 1].vertices[0]->position, end};
      const Segment after{end, lines[i].vertices[1]->position};
      if (before.x_major() != after.x_major()) continue;
      const auto along = [](const Segment& s) {
        return s.x_major() ? s.b.x > s.a.x : s.b.y > s.a.y;
      };
      if (along(before) == along(after)) ++going_on;
    }
  }
  EXPECT_EQ(primitives.size(), 3u);
  for (const auto& [primitive, count] : primitives)
    EXPECT_GT(count, static_cast<int>(kScenes) / 6) << name_of(primitive);
  EXPECT_GT(wide, static_cast<int>(kScenes) / 16);
  EXPECT_GT(3 * going_on, joints);
  EXPECT_LT(4 * going_on, 3 * joints);
}

TEST(RandomFans, AreFansStripsAndTrianglesThatShareEdges) {
  std::map<Primitive, int> primitives;
  int closed = 0;
  int sharing = 0;
  for (std::uint64_t index = 0; index < kScenes; ++index) {
    const Scene scene = random_fan_scene(kSeed, Surface::fbo, index);
    const Draw& draw = scene.draws[0];
    ++primitives[draw.primitive];
    if (draw.primitive == Primitive::triangle_fan && draw.vertices.size() > 3 &&
        draw.vertices[1].position == draw.vertices.back().position)
      ++closed;
    const auto triangles = primitives_of(scene);
    ASSERT_GE(triangles.size(), 1u);
    bool shares = false;
    for (std::size_t i = 0; i < triangles.size() && !shares; ++i)
      for (std::size_t j = 0; j < i && !shares; ++j) {
        const auto of = [&](std::size_t t) {
          return Triangle{triangles[t].vertices[0]->position, triangles[t].vertices[1]->position,
                          triangles[t].vertices[2]->position};
        };
        shares = shared_edge(of(i), of(j)).has_value();
      }
    if (shares) ++sharing;
  }
  EXPECT_EQ(primitives.size(), 3u);
  for (const auto& [primitive, count] : primitives)
    EXPECT_GT(count, static_cast<int>(kScenes) / 12) << name_of(primitive);
  EXPECT_GT(closed, static_cast<int>(kScenes) / 12);
  EXPECT_GT(sharing, static_cast<int>(kScenes) / 2);
}

TEST(RandomSnaps, LieOnStepsHalfwayAndBeside) {
  std::map<PrimitiveKind, int> kinds;
  int on_sixteenths = 0;
  int beside = 0;
  int halfway = 0;
  for (std::uint64_t index = 0; index < kScenes; ++index) {
    const Scene scene = random_snap_scene(kSeed, Surface::fbo, index);
    ++kinds[kind_of(scene.draws[0].primitive)];
    for (const Vertex& vertex : scene.draws[0].vertices) {
      const std::int64_t raw = vertex.position.x.raw();
      if (raw % 4096 == 0) ++on_sixteenths;
      if (raw % 2 != 0) ++beside;
      if (raw % 4096 == 2048) ++halfway;
    }
  }
  EXPECT_EQ(kinds.size(), 3u);
  for (const auto& [kind, count] : kinds) EXPECT_GT(count, static_cast<int>(kScenes) / 8);
  EXPECT_GT(on_sixteenths, 1'000);
  EXPECT_GT(beside, 1'000);
  EXPECT_GT(halfway, 200);
}

}  // namespace
}  // namespace edgecase
