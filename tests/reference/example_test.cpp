// SPDX-License-Identifier: MIT
//
// reference/examples/rasterizer.py on drawings worked out by hand, ties above all: it is an oracle
// for other tests, so it needs one of its own.
#include <gmock/gmock.h>

#include <map>

#include "tests/reference/example.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;

std::string drawing(int width, int height, const Draw& draw) {
  Scene scene = blank_scene(width, height);
  scene.draws = {draw};
  return coverage(render(example(), scene));
}

std::string line(int width, int height, int ax, int ay, int bx, int by) {
  return drawing(width, height, make_draw(Primitive::lines, {{ax, ay}, {bx, by}}));
}

// Halves of pixels.
constexpr int kHalf = 128;

TEST(Example, PointsBelongToThePixelOfTheirFloor) {
  const auto point = [](int x, int y) {
    return drawing(3, 2, make_draw(Primitive::points, {{x, y}}));
  };
  EXPECT_EQ(point(kHalf, kHalf), "...\n#..\n");
  EXPECT_EQ(point(256, 256), ".#.\n...\n");
  EXPECT_EQ(point(255, 255), "...\n#..\n");
  EXPECT_EQ(point(3 * 256, 0), "...\n...\n");
}

TEST(Example, LinesLeaveOutThePixelTheyEndIn) {
  EXPECT_EQ(line(6, 1, kHalf, kHalf, 9 * kHalf, kHalf), "####..\n");
  EXPECT_EQ(line(6, 1, 9 * kHalf, kHalf, kHalf, kHalf), ".####.\n");
  EXPECT_EQ(line(1, 4, kHalf, kHalf, kHalf, 5 * kHalf), ".\n.\n#\n#\n");
  EXPECT_EQ(line(3, 1, kHalf, kHalf, kHalf, kHalf), "...\n");
  // Both ends in one diamond: it is never left.
  EXPECT_EQ(line(3, 1, kHalf - 32, kHalf, kHalf + 32, kHalf), "...\n");
}

TEST(Example, LinesOnPixelBordersMoveLeftAndDown) {
  EXPECT_EQ(line(6, 3, 256, 256, 4 * 256, 256), "......\n......\n.###..\n");
  EXPECT_EQ(line(3, 4, 256, 0, 256, 3 * 256), "...\n#..\n#..\n#..\n");
}

TEST(Example, DiamondCornersAndEdges) {
  // Along the row's centre line from one border between pixels to another, moved left by e and down
  // by the far smaller e^2. The start moves into the right corner of column 0's diamond, which the
  // line leaves; its end moves into the right corner of column 2's, which it does not leave.
  EXPECT_EQ(line(5, 1, 256, kHalf, 3 * 256, kHalf), "##...\n");
  // The other way round it leaves column 2's diamond and ends in column 0's.
  EXPECT_EQ(line(5, 1, 3 * 256, kHalf, 256, kHalf), ".##..\n");
  // Along the diamond's lower left edge, moved down and left: just outside.
  EXPECT_EQ(line(2, 2, 0, kHalf, kHalf, 0), "..\n..\n");
  // Along its upper right edge: moved into the diamond. It ends inside its right corner.
  EXPECT_EQ(line(2, 2, kHalf, 256, 256, kHalf), "..\n..\n");
  // Beyond that corner it leaves.
  EXPECT_EQ(line(2, 2, kHalf, 256, 256 + 64, kHalf - 64), "..\n#.\n");
}

TEST(Example, DiagonalsHitEachColumnOnce) {
  EXPECT_EQ(line(5, 5, kHalf, kHalf, 9 * kHalf, 9 * kHalf), ".....\n...#.\n..#..\n.#...\n#....\n");
  EXPECT_EQ(line(4, 4, 0, 4 * 256, 4 * 256, 0), "#...\n.#..\n..#.\n...#\n");
}

TEST(Example, TrianglesOwnTheirLeftAndThenTheirTopEdges) {
  // Edges through the centres of columns 0 and 2, rows 0 and 2: left and top centres are owned.
  EXPECT_EQ(drawing(4, 4, rectangle(kHalf, kHalf, 5 * kHalf, 5 * kHalf)),
            "....\n##..\n##..\n....\n");
  // The same clockwise, and a shared diagonal through centres: nothing twice, nothing missing.
  EXPECT_EQ(drawing(4, 4,
                    make_draw(Primitive::triangles, {{kHalf, kHalf},
                                                     {kHalf, 5 * kHalf},
                                                     {5 * kHalf, 5 * kHalf},
                                                     {kHalf, kHalf},
                                                     {5 * kHalf, 5 * kHalf},
                                                     {5 * kHalf, kHalf}})),
            "....\n##..\n##..\n....\n");
  EXPECT_EQ(drawing(2, 2, make_draw(Primitive::triangles, {{0, 0}, {256, 256}, {512, 512}})),
            "..\n..\n");
}

TEST(Example, FansRoundACentreHitItOnce) {
  Scene scene = blank_scene(3, 3);
  const std::pair<int, int> centre(3 * kHalf, 3 * kHalf);
  const std::vector<std::pair<int, int>> rim = {{0, 0}, {768, 0}, {768, 768}, {0, 768}};
  for (std::size_t i = 0; i < 4; ++i)
    scene.draws.push_back(make_draw(Primitive::triangles, {centre, rim[i], rim[(i + 1) % 4]}));
  EXPECT_EQ(coverage(render(example(), scene)), "###\n###\n###\n");
}

// The primitives of a drawing that is one row high, as letters; '.' where there is none.
std::string numbers(const Scene& scene) {
  const Rendering rendering = render(example(), scene);
  std::string text(static_cast<std::size_t>(rendering.width), '.');
  for (const Fragment& fragment : rendering.fragments)
    text[static_cast<std::size_t>(fragment.x)] = static_cast<char>('a' + fragment.primitive);
  return text;
}

TEST(Example, StripsLoopsAndFans) {
  const auto along = [](Primitive primitive) {
    Scene scene = blank_scene(7, 1);
    scene.draws = {make_draw(primitive, {{kHalf, kHalf}, {5 * kHalf, kHalf}, {9 * kHalf, kHalf}}),
                   make_draw(Primitive::points, {{11 * kHalf, kHalf}})};
    return scene;
  };
  EXPECT_EQ(numbers(along(Primitive::line_strip)), "aabb.c.");
  // Back from the end to the start: over the others, and without the first pixel.
  EXPECT_EQ(numbers(along(Primitive::line_loop)), "accccd.");
  // Two squares, each cut in two; the diagonals run off the centres.
  Scene scene = blank_scene(3, 1);
  scene.draws = {make_draw(Primitive::triangle_strip,
                           {{0, 300}, {0, -10}, {512, 300}, {512, -10}, {1024, 300}})};
  EXPECT_EQ(numbers(scene), "abc");
  scene.draws = {
      make_draw(Primitive::triangle_fan, {{0, 2560}, {0, 0}, {300, 0}, {600, 0}, {768, 0}})};
  EXPECT_EQ(numbers(scene), "abc");
}

TEST(Example, ProvokingVerticesOfStripsLoopsAndFans) {
  const auto colours = [](Primitive primitive, ProvokingVertex provoking) {
    Scene scene = blank_scene(8, 8);
    scene.draws = {
        make_draw(primitive, {{40, 1024}, {30, 10}, {1034, 1024}, {1034, 0}, {2048, 2000}})};
    scene.draws[0].provoking_vertex = provoking;
    for (std::size_t i = 0; i < 5; ++i)
      scene.draws[0].vertices[i].color = {static_cast<float>(i) / 8, 0, 0, 1};
    std::map<int, int> sources;
    for (const Fragment& fragment : render(example(), scene).fragments)
      sources[fragment.primitive] = static_cast<int>(fragment.color[0] * 8);
    std::vector<int> result;
    for (const auto& [primitive_number, source] : sources) result.push_back(source);
    return result;
  };
  constexpr auto kFirst = ProvokingVertex::first;
  constexpr auto kLast = ProvokingVertex::last;
  EXPECT_THAT(colours(Primitive::line_strip, kFirst), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(colours(Primitive::line_strip, kLast), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(colours(Primitive::line_loop, kFirst), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(colours(Primitive::line_loop, kLast), ElementsAre(1, 2, 3, 4, 0));
  EXPECT_THAT(colours(Primitive::triangle_strip, kFirst), ElementsAre(0, 1, 2));
  EXPECT_THAT(colours(Primitive::triangle_strip, kLast), ElementsAre(2, 3, 4));
  EXPECT_THAT(colours(Primitive::triangle_fan, kFirst), ElementsAre(1, 2, 3));
  EXPECT_THAT(colours(Primitive::triangle_fan, kLast), ElementsAre(2, 3, 4));
}

TEST(Example, SizesOfPoints) {
  const auto point = [](Fixed size, int x, int y) {
    Draw draw = make_draw(Primitive::points, {{x, y}});
    draw.point_size = size;
    return drawing(4, 3, draw);
  };
  const Fixed two = Fixed::from_integer(2);
  EXPECT_EQ(point(two, 512, 256), "....\n.##.\n.##.\n");
  // Centres on all four sides: those on the right and on top belong to the square.
  EXPECT_EQ(point(two, 3 * kHalf, 3 * kHalf), ".##.\n.##.\n....\n");
  EXPECT_EQ(point(Fixed::from_raw(7 * Fixed::kOne / 2), 512, 256), "####\n####\n####\n");
  EXPECT_EQ(point(Fixed::from_raw(Fixed::kOne / 2), kHalf + 64, kHalf), "....\n....\n....\n");
  EXPECT_EQ(point(Fixed::from_raw(Fixed::kOne / 2), kHalf - 64, kHalf), "....\n....\n#...\n");
}

TEST(Example, ScissorsAndViewportsCut) {
  Scene scene = blank_scene(5, 3);
  scene.draws = {rectangle(0, 0, 5 * 256, 3 * 256)};
  scene.draws[0].scissor = Viewport{1, -1, 2, 3};
  EXPECT_EQ(coverage(render(example(), scene)), ".....\n.##..\n.##..\n");
  scene.viewport = {2, 0, 8, 8};
  EXPECT_EQ(coverage(render(example(), scene)), ".....\n..#..\n..#..\n");
  // A point whose vertex is inside reaches out of the viewport; one outside does not reach in.
  scene.draws = {make_draw(Primitive::points, {{2 * 256 + 40, 300}, {2 * 256 - 40, 700}})};
  scene.draws[0].point_size = Fixed::from_integer(2);
  EXPECT_EQ(coverage(render(example(), scene)), ".....\n.##..\n.##..\n");
}

TEST(Example, RefusesWideLines) {
  Scene scene = blank_scene(4, 1);
  scene.draws = {make_draw(Primitive::line_loop, {{kHalf, kHalf}, {5 * kHalf, kHalf}})};
  scene.draws[0].line_width = Fixed::from_raw(3 * Fixed::kOne / 2);
  const Outcome outcome = render_outcome(example(), scene);
  ASSERT_TRUE(std::holds_alternative<Failure>(outcome));
  EXPECT_EQ(std::get<Failure>(outcome).reason, "this example draws lines of width 1");
  scene.draws[0].line_width = Fixed::from_raw(3 * Fixed::kOne / 2 - 1);
  EXPECT_TRUE(std::holds_alternative<Rendering>(render_outcome(example(), scene)));
}

TEST(Example, NoperspectiveIsSmooth) {
  Scene scene = blank_scene(4, 1);
  scene.draws = {make_draw(Primitive::lines, {{kHalf, kHalf}, {5 * kHalf, kHalf}})};
  scene.draws[0].vertices[0].color = {0, 0, 0, 1};
  scene.draws[0].interpolation = Interpolation::noperspective;
  EXPECT_THAT(render(example(), scene).fragments[1].color, ElementsAre(0.5, 0.5, 0.5, 1));
}

TEST(Example, ColoursAndDepth) {
  Scene scene = blank_scene(4, 1);
  scene.target.clear = {0, 0, 0.5f, 1};
  scene.draws = {make_draw(Primitive::lines, {{kHalf, kHalf}, {5 * kHalf, kHalf}})};
  scene.draws[0].vertices[0].color = {1, 0, 0, 1};
  scene.draws[0].vertices[1].color = {0, 1, 0, 1};
  scene.draws[0].vertices[1].z = Fixed::from_integer(1);
  Rendering rendering = render(example(), scene);
  EXPECT_THAT(pixel(rendering, 0, 0), ElementsAre(0, 255, 0, 255));
  // 127.5 goes to the even neighbour.
  EXPECT_THAT(pixel(rendering, 3, 0), ElementsAre(0, 0, 128, 255));
  EXPECT_EQ(rendering.fragments[1].depth, 0.75);

  scene.draws[0].provoking_vertex = ProvokingVertex::first;
  EXPECT_THAT(pixel(render(example(), scene), 1, 0), ElementsAre(255, 0, 0, 255));
  scene.draws[0].interpolation = Interpolation::smooth;
  rendering = render(example(), scene);
  EXPECT_THAT(rendering.fragments[1].color, ElementsAre(0.5, 0.5, 0, 1));
  EXPECT_THAT(pixel(rendering, 0, 0), ElementsAre(255, 0, 0, 255));
}

// A line of eight pixels, the first end's w 1 and the other's 3, from 0 to 1 in red and in depth.
Scene perspective_line(Interpolation interpolation) {
  Scene scene = blank_scene(8, 1);
  scene.details.coordinates = true;
  scene.draws = {make_draw(Primitive::lines, {{0, kHalf}, {16 * kHalf, kHalf}})};
  Draw& draw = scene.draws[0];
  draw.interpolation = interpolation;
  draw.vertices[0].z = Fixed::from_integer(-1);
  draw.vertices[1].z = Fixed::from_integer(1);
  draw.vertices[1].w = 3;
  draw.vertices[0].color = {0, 0, 0, 1};
  draw.vertices[1].color = {1, 0, 0, 1};
  return scene;
}

TEST(Example, SmoothIsDividedByWAndNoperspectiveIsNot) {
  // At 3/16 of the way, 1/w is 13/16 + 3/16 / 3 = 7/8, and (3/16 / 3) / (7/8) is 1/14. The line
  // ends in the diamond of its last pixel, moved left.
  Rendering rendering = render(example(), perspective_line(Interpolation::smooth));
  ASSERT_EQ(rendering.fragments.size(), 7u);
  EXPECT_EQ(rendering.fragments[1].color[0], 1.0 / 14);
  EXPECT_EQ(rendering.fragments[1].depth, 3.0 / 16);
  EXPECT_THAT(rendering.details.at(1).coordinates.value(),
              ElementsAre(1.5, 0.5, 3.0 / 16, 7.0 / 8));
  rendering = render(example(), perspective_line(Interpolation::noperspective));
  EXPECT_EQ(rendering.fragments[1].color[0], 3.0 / 16);
  rendering = render(example(), perspective_line(Interpolation::flat));
  EXPECT_EQ(rendering.fragments[1].color[0], 1);
}

// Its left edge runs from (8/3, 0) to (16/3, 8), through the centres (3.5, 2.5) and (4.5, 5.5), and
// its right one through (7.5, 1.5), (6.5, 4.5) and (5.5, 7.5). Between the nearest multiples of
// 2^-16, the left edge would pass (3.5, 2.5) on the right.
TEST(Example, ClipCoordinatesAreDividedExactly) {
  Scene scene = blank_scene(8, 8);
  scene.draws = {make_draw(Primitive::triangles, {{0, 0}, {0, 0}, {0, 0}})};
  const ClipPosition corners[] = {{-1, -3, 0, 3}, {3, -3, 0, 3}, {1, 3, 0, 3}};
  for (std::size_t i = 0; i < 3; ++i) {
    Vertex& vertex = scene.draws[0].vertices[i];
    vertex.clip = corners[i];
    vertex.w = corners[i].w;
    vertex.position = nearest_point(window_position(corners[i], scene.viewport));
  }
  EXPECT_EQ(coverage(render(example(), scene)),
            "........\n.....#..\n....##..\n....##..\n....###.\n...####.\n...####.\n...#####\n");
  for (Vertex& vertex : scene.draws[0].vertices) {
    vertex.clip.reset();
    vertex.w = 1;
  }
  const std::string rounded = coverage(render(example(), scene));
  EXPECT_EQ(rounded.substr(5 * 9, 8), "....###.");
}

TEST(Example, DepthBuffersRoundToTheirFormat) {
  Scene scene = perspective_line(Interpolation::smooth);
  scene.target.width = 9;
  scene.target.depth = DepthFormat::depth16;
  // 3/16 * 65535 = 12287.8125.
  std::vector<double> depths = render(example(), scene).depths;
  ASSERT_EQ(depths.size(), 9u);
  EXPECT_EQ(depths[1], 12288 / 65535.0);
  EXPECT_EQ(depths[8], 1);
  scene.target.depth = DepthFormat::depth24;
  // 3/16 * 16777215 = 3145727.8125.
  EXPECT_EQ(render(example(), scene).depths[1], 3145728 / 16777215.0);
  scene.target.depth = DepthFormat::depth32f;
  scene.draws[0].vertices[1].z = Fixed::from_raw(1);
  const double exact = 3.0 / 32 * (1 + 1.0 / 65536);
  depths = render(example(), scene).depths;
  EXPECT_EQ(depths[1], static_cast<double>(static_cast<float>(exact)));
  scene.target.depth = DepthFormat::none;
  EXPECT_TRUE(render(example(), scene).depths.empty());
}

TEST(Example, LaterPrimitivesAreDrawnOverEarlierOnes) {
  Scene scene = blank_scene(2, 1);
  scene.draws = {rectangle(0, 0, 512, 256, {1, 0, 0, 1}),
                 rectangle(256, 0, 512, 256, {0, 1, 0, 1})};
  const Rendering rendering = render(example(), scene);
  EXPECT_EQ(coverage(rendering), "#2\n");
  EXPECT_THAT(pixel(rendering, 0, 0), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(pixel(rendering, 1, 0), ElementsAre(0, 255, 0, 255));
}

}  // namespace
}  // namespace edgecase
