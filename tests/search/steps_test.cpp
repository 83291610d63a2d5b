// SPDX-License-Identifier: MIT
//
// Each step by itself: what it proposes where a renderer's fault leaves it one way only.
#include <gtest/gtest.h>

#include "model/scene.h"
#include "search/coordinate_steps.h"
#include "search/grid_search.h"
#include "search/scene_steps.h"
#include "search/shrinking.h"
#include "tests/search/faulty_renderer.h"

namespace edgecase {
namespace {

// A scene of which a fault shows, and what a step makes of it.
class Steps : public testing::Test {
 protected:
  using Condition = std::function<bool(const Scene&)>;
  using Step = bool (*)(Shrinking&);

  // The renderer crashes where the condition holds: a find that hangs on nothing else.
  Scene after(Step step, const Scene& scene, Condition condition, bool expect = true) {
    FaultyRenderer renderer(crash_where(std::move(condition)));
    return shrunk(step, scene, renderer, expect);
  }

  static Scene shrunk(Step step, const Scene& scene, Renderer& renderer, bool expect) {
    Trial trial(renderer, {});
    TrialAnswer answer = trial.ask(scene);
    const Signature signature = answer.signatures.at(0);
    Shrinking shrinking(scene, std::move(answer.result), signature, trial, 10'000);
    EXPECT_EQ(step(shrinking), expect);
    EXPECT_EQ(size_of(shrinking.scene()) < size_of(scene), expect);
    return shrinking.scene();
  }

  static Draw line(Point from, Point to) {
    return make_draw(Primitive::lines, std::array{from, to});
  }
  static bool has_point(const Scene& scene, Point point) {
    const auto points = points_of(scene);
    return std::ranges::find(points, point) != points.end();
  }
  static bool has_triangles(const Scene& scene, std::size_t count) {
    return primitives_of(scene).size() >= count;
  }
};

const Point kA = sixteenths(16, 16), kB = sixteenths(80, 16), kC = sixteenths(16, 80),
            kD = sixteenths(80, 80), kE = sixteenths(40, 100);

TEST_F(Steps, KeepsWhatTheFindIsOn) {
  // The third line alone is not drawn; nothing else is needed.
  Scene scene = scene_with(8, {line(kA, kB), line(kA, kC), line(kB, kD), line(kC, kE)});
  FaultyRenderer renderer(lose_line_from(kB, [](const Scene&) { return true; }));
  const Scene result = shrunk(keep_only_finds, scene, renderer, true);
  ASSERT_EQ(primitives_of(result).size(), 1u);
  EXPECT_EQ(result.draws[0].vertices[0].position, kB);
}

TEST_F(Steps, KeepsAFindWithTheOneThatItNeeds) {
  const Scene scene = scene_with(8, {line(kA, kE), line(kB, kD), line(kC, kA)});
  // The line from kB is lost while the one from kC is there, too.
  FaultyRenderer renderer(
      lose_line_from(kB, [](const Scene& drawn) { return has_point(drawn, kC); }));
  const Scene result = shrunk(keep_only_finds, scene, renderer, true);
  EXPECT_EQ(primitives_of(result).size(), 2u);
  EXPECT_FALSE(has_point(result, kE));
}

TEST_F(Steps, LeavesOutDraws) {
  std::vector<Draw> draws;
  for (int i = 0; i < 9; ++i) draws.push_back(line(sixteenths(16 + 4 * i, 16), kD));
  const Scene result = after(leave_out_draws, scene_with(8, draws), [](const Scene& scene) {
    return has_point(scene, sixteenths(20, 16)) && has_point(scene, sixteenths(48, 16));
  });
  EXPECT_EQ(result.draws.size(), 2u);
}

TEST_F(Steps, SeparatesStripsFansAndLoops) {
  for (const Primitive primitive : {Primitive::triangle_strip, Primitive::triangle_fan,
                                    Primitive::line_strip, Primitive::line_loop}) {
    const Scene scene = scene_with(8, {make_draw(primitive, std::array{kA, kB, kC, kD})});
    const std::size_t count = primitives_of(scene).size();
    const Scene result = after(separate_primitives, scene, [count](const Scene& drawn) {
      return primitives_of(drawn).size() == count;
    });
    EXPECT_EQ(result.draws[0].primitive,
              kind_of(primitive) == PrimitiveKind::line ? Primitive::lines : Primitive::triangles);
    // The same primitives, vertex by vertex.
    const auto before = primitives_of(scene);
    const auto now = primitives_of(result);
    ASSERT_EQ(before.size(), now.size());
    for (std::size_t i = 0; i < now.size(); ++i)
      for (int v = 0; v < vertices_of(now[i].kind); ++v)
        EXPECT_EQ(now[i].vertices[static_cast<std::size_t>(v)]->position,
                  before[i].vertices[static_cast<std::size_t>(v)]->position);
  }
}

TEST_F(Steps, LeavesAStripThatIsNeeded) {
  const Scene scene = scene_with(8, {make_draw(Primitive::line_strip, std::array{kA, kB, kC, kD})});
  const auto is_strip = [](const Scene& drawn) {
    return drawn.draws[0].primitive == Primitive::line_strip;
  };
  after(separate_primitives, scene, is_strip, false);
  const Scene result = after(leave_out_primitives, scene, is_strip);
  EXPECT_EQ(result.draws[0].vertices.size(), 2u) << "vertices of a strip";
}

TEST_F(Steps, LeavesOutPrimitivesOfADraw) {
  std::vector<Point> points;
  for (int i = 0; i < 11; ++i) {
    points.push_back(sixteenths(16 + 4 * i, 16));
    points.push_back(kD);
  }
  const Scene scene = scene_with(8, {make_draw(Primitive::lines, points)});
  const Scene result = after(leave_out_primitives, scene, [](const Scene& drawn) {
    return has_point(drawn, sixteenths(20, 16)) && has_point(drawn, sixteenths(56, 16));
  });
  EXPECT_EQ(primitives_of(result).size(), 2u);
}

TEST_F(Steps, JoinsDrawsThatAreAlike) {
  Scene scene = scene_with(8, {line(kA, kB), line(kC, kD), line(kB, kD)});
  scene.draws[2].line_width = Fixed::from_integer(2);
  const Scene result = after(join_draws, scene, [](const Scene&) { return true; });
  ASSERT_EQ(result.draws.size(), 2u);
  EXPECT_EQ(result.draws[0].vertices.size(), 4u);
}

TEST_F(Steps, CropsOnAllSides) {
  const Scene scene = scene_with(32, {line(sixteenths(176, 232), sixteenths(240, 232))});
  // The line's start must be on the target.
  const Scene result = after(crop_target, scene, [](const Scene& drawn) {
    const Point at = drawn.draws[0].vertices[0].position;
    return at.x >= Fixed() && at.x < Fixed::from_integer(drawn.target.width) && at.y >= Fixed() &&
           at.y < Fixed::from_integer(drawn.target.height);
  });
  SCOPED_TRACE(scene_text(result));
  EXPECT_EQ(result.target.width, 1);
  EXPECT_EQ(result.target.height, 1);
  EXPECT_LT(result.draws[0].vertices[0].position.y, Fixed::from_integer(1));
}

TEST_F(Steps, CropsToThePixelsOfTheFind) {
  // Three pixels are lost, in columns 11 to 13 of row 14.
  const Scene scene = scene_with(32, {line(sixteenths(176, 232), sixteenths(240, 232))});
  FaultyRenderer renderer([](const Scene& drawn, Rendering& rendering) {
    const auto start = drawn.draws[0].vertices[0].position.x.floor();
    lose(drawn, rendering, [&](const Fragment& fragment) { return fragment.x < start + 3; });
    return std::optional<Failure>();
  });
  const Scene result = shrunk(crop_target, scene, renderer, true);
  EXPECT_LE(result.target.width, 4) << scene_text(result);
  EXPECT_LE(result.target.height, 3) << scene_text(result);
}

TEST_F(Steps, CropsToWhatIsNeeded) {
  const Scene scene = scene_with(32, {line(kA, kB)});
  const Scene result = after(crop_target, scene, [](const Scene& drawn) {
    return drawn.target.width >= 5 && drawn.target.height >= 7;
  });
  EXPECT_EQ(result.target.width, 5);
  EXPECT_EQ(result.target.height, 7);
}

TEST_F(Steps, CutsColumnsBeforeTheFindMovingWhatIsDrawn) {
  Scene scene = scene_with(16, {line(sixteenths(168, 168), sixteenths(232, 168))});
  scene.draws[0].scissor = Viewport{10, 0, 6, 16};
  FaultyRenderer renderer(blank_where(
      [](const Scene& drawn) { return drawn.draws[0].scissor->x == drawn.target.width - 6; }));
  const Scene result = shrunk(crop_target, scene, renderer, true);
  EXPECT_EQ(result.draws[0].scissor->x, result.target.width - 6);
  EXPECT_LT(result.draws[0].scissor->x, 10);
}

TEST_F(Steps, MovesToTheOriginByWholePixels) {
  const Scene scene = scene_with(64, {line(sixteenths(613, 325), sixteenths(680, 421))});
  // Needed are the pixel's part and a distance of at least 3 pixels from the left.
  const Scene result = after(move_to_origin, scene, [](const Scene& drawn) {
    const Point at = drawn.draws[0].vertices[0].position;
    return at.x >= Fixed::from_integer(3) && (at.x.raw() & 0xffff) == 5 * Fixed::kOne / 16;
  });
  EXPECT_EQ(result.draws[0].vertices[0].position.x, sixteenths(53, 0).x);
  EXPECT_EQ(result.target.width, 64);
}

TEST_F(Steps, RoundsAllPointsAtOnce) {
  // All have the same fraction: none can be rounded by itself.
  const Scene scene = scene_with(8, {line(sixteenths(17, 33), sixteenths(49, 65))});
  const auto alike = [](const Scene& drawn) {
    const std::int64_t part = drawn.draws[0].vertices[0].position.x.raw() & 0xffff;
    for (const Point point : points_of(drawn))
      if ((point.x.raw() & 0xffff) != part || (point.y.raw() & 0xffff) != part) return false;
    return true;
  };
  EXPECT_EQ(fraction_bits_of(after(round_all, scene, alike)), 0);
  after(round_each, scene, alike, false);
}

TEST_F(Steps, RoundsEachCoordinateAsFarAsItGoes) {
  const Scene scene = scene_with(8, {line({Fixed::from_raw(70'001), kA.y},
                                          {Fixed::from_raw(300'001), Fixed::from_raw(99'999)})});
  // The first x needs 2 fraction bits, the second 5.
  const Scene result = after(round_each, scene, [](const Scene& drawn) {
    return fraction_bits_of(drawn.draws[0].vertices[0].position.x) >= 2 &&
           fraction_bits_of(drawn.draws[0].vertices[1].position.x) >= 5;
  });
  const auto& vertices = result.draws[0].vertices;
  EXPECT_EQ(fraction_bits_of(vertices[0].position.x), 2);
  EXPECT_EQ(fraction_bits_of(vertices[1].position.x), 5);
  EXPECT_EQ(fraction_bits_of(vertices[1].position.y), 0);
}

TEST_F(Steps, RoundsAPointWhoseCoordinatesGoTogether) {
  const Scene scene = scene_with(8, {line(sixteenths(21, 37), kD)});
  // x and y have the same fraction.
  const Scene result = after(round_each, scene, [](const Scene& drawn) {
    const Point at = drawn.draws[0].vertices[0].position;
    return ((at.x.raw() ^ at.y.raw()) & 0xffff) == 0;
  });
  EXPECT_EQ(fraction_bits_of(result), 0);
}

TEST_F(Steps, RoundsAnEdgeAsAWhole) {
  const Scene scene = scene_with(
      8, {make_draw(Primitive::triangles, std::array{sixteenths(37, 16), sixteenths(37, 80), kB})});
  // Its two ends share their x.
  const Scene result = after(round_each, scene, [](const Scene& drawn) {
    const auto& vertices = drawn.draws[0].vertices;
    return vertices[0].position.x == vertices[1].position.x;
  });
  EXPECT_EQ(fraction_bits_of(result), 0);
}

TEST_F(Steps, KeepsSharedPointsShared) {
  const Point shared = sixteenths(37, 53);
  const Scene scene = scene_with(8, {line(kA, shared), line(shared, kB)});
  const Scene result = after(round_each, scene, [](const Scene& drawn) {
    return drawn.draws[0].vertices[1].position == drawn.draws[1].vertices[0].position;
  });
  EXPECT_EQ(fraction_bits_of(result), 0);
}

TEST_F(Steps, AlignsPoints) {
  const Scene scene = scene_with(8, {line(kA, sixteenths(64, 32))});
  const Scene result = after(align, scene, [](const Scene& drawn) {
    return drawn.draws[0].vertices[1].position.x == sixteenths(64, 0).x;
  });
  EXPECT_EQ(result.draws[0].vertices[1].position.y, result.draws[0].vertices[0].position.y);
}

TEST_F(Steps, DrawsPointsIn) {
  const Scene scene = scene_with(32, {line(kA, sixteenths(409, 16))});
  // The end needs its fraction, and to lie right of the start.
  const Scene result = after(draw_in, scene, [](const Scene& drawn) {
    const auto& vertices = drawn.draws[0].vertices;
    return vertices[0].position.x < vertices[1].position.x &&
           (vertices[1].position.x.raw() & 0xffff) == 9 * Fixed::kOne / 16;
  });
  EXPECT_EQ(result.draws[0].vertices[1].position.x, sixteenths(9, 0).x);
  EXPECT_EQ(result.draws[0].vertices[0].position.x, Fixed());
}

TEST_F(Steps, ClosesGapsBetweenWhatMustKeepItsDistance) {
  const Scene scene = scene_with(
      32, {line(sixteenths(16, 32), kA), line(sixteenths(320, 80), sixteenths(400, 16))});
  const Scene result = after(draw_in, scene, [](const Scene& drawn) {
    const auto& second = drawn.draws[1].vertices;
    return (second[1].position.x - second[0].position.x) == Fixed::from_integer(5);
  });
  EXPECT_LE(result.draws[1].vertices[0].position.x, Fixed::from_integer(1));
}

TEST_F(Steps, RoundsDepths) {
  Scene scene = scene_with(8, {line(kA, kB)});
  scene.draws[0].vertices[0].z = Fixed::from_raw(20'001);
  const Scene result = after(round_depths, scene, [](const Scene& drawn) {
    return drawn.draws[0].vertices[0].z > Fixed();
  });
  EXPECT_EQ(fraction_bits_of(result.draws[0].vertices[0].z), 0) << "1, the far plane";
}

TEST_F(Steps, SearchesAmongNeighboursWhatMustMoveTogether) {
  // On sixteenths, the two ends must be an odd number apart along y and x, and their sum a whole
  // one: no coordinate can move alone.
  const Scene scene = scene_with(8, {line({Fixed::from_raw(70'001), Fixed::from_raw(80'003)},
                                          {Fixed::from_raw(200'003), Fixed::from_raw(251'111)})});
  const auto fits = [&scene](const Scene& drawn) {
    const auto points = points_of(drawn);
    if (points == points_of(scene)) return true;
    if (points.size() < 2) return false;
    for (const Point point : points)
      for (const Fixed value : {point.x, point.y})
        if (fraction_bits_of(value) != 4) return false;
    const std::int64_t across = (points[1].x - points[0].x).raw() / 4096;
    const std::int64_t up = (points[1].y - points[0].y).raw() / 4096;
    return across % 4 == 2 && up % 4 == 2;
  };
  after(round_all, scene, fits, false);
  after(round_each, scene, fits, false);
  const Scene result = after(search_neighbours, scene, fits);
  EXPECT_EQ(fraction_bits_of(result), 4);
  for (std::size_t v = 0; v < 2; ++v) {
    const Point from = scene.draws[0].vertices[v].position;
    const Point to = result.draws[0].vertices[v].position;
    EXPECT_LE(std::abs((to.x - from.x).raw()), 2 * 4096);
    EXPECT_LE(std::abs((to.y - from.y).raw()), 2 * 4096);
  }
}

TEST_F(Steps, SearchesAfar) {
  const Scene scene = scene_with(4, {line({Fixed::from_raw(70'001), Fixed::from_raw(80'003)}, kA)});
  const auto fits = [&scene](const Scene& drawn) {
    const auto points = points_of(drawn);
    return points == points_of(scene) ||
           (points[0].x < Fixed::from_integer(1) && fraction_bits_of(drawn) == 4);
  };
  after(search_neighbours, scene, fits, false);
  const Scene result =
      after([](Shrinking& shrinking) { return search_afar(shrinking, 1000); }, scene, fits);
  EXPECT_EQ(fraction_bits_of(result), 4);
}

TEST_F(Steps, MovesNoClipCoordinates) {
  Scene scene = scene_with(8, {line(kA, kB)});
  scene.draws[0].vertices[0].clip = ClipPosition{0, 0, 0, 1};
  EXPECT_FALSE(moved_scene(scene, {-1, 0}).has_value());
  EXPECT_EQ(points_of(scene), std::vector{kB});
}

}  // namespace
}  // namespace edgecase
