// SPDX-License-Identifier: MIT
//
// Strips, loops and fans, sizes of points and lines, and the scissor, against real OpenGL on both
// surfaces. Only what every implementation at hand must draw: nothing depends on a tie, and no line
// begins at a pixel's centre, where llvmpipe loses the first pixel of a line that goes down.
#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "tests/reference/opengl_test.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class PrimitivesTest : public OpenGlTest {};

// The one primitive that covers a pixel, as a letter; '.' for none, '*' for several. Top row first.
std::string numbers(const Rendering& rendering) {
  std::string cells(rendering.pixels.size() / 4, '.');
  for (const Fragment& fragment : rendering.fragments) {
    char& cell = cells[rendering.pixel_index(fragment.x, fragment.y)];
    cell = cell == '.' ? static_cast<char>('a' + fragment.primitive) : '*';
  }
  std::string text;
  for (int y = rendering.height - 1; y >= 0; --y)
    text +=
        cells.substr(rendering.pixel_index(0, y), static_cast<std::size_t>(rendering.width)) + "\n";
  return text;
}

// Every vertex its own colour: vertex i has red i / 255.
Draw numbered_draw(Primitive primitive, const std::vector<std::pair<int, int>>& positions,
                   ProvokingVertex provoking) {
  Draw draw = make_draw(primitive, positions);
  draw.provoking_vertex = provoking;
  for (std::size_t i = 0; i < draw.vertices.size(); ++i)
    draw.vertices[i].color = {static_cast<float>(i) / 255.0f, 0, 0, 1};
  return draw;
}

// The vertices whose colours the primitives of a drawing have, by the primitives' numbers.
std::map<int, int> colour_sources(const Rendering& rendering) {
  std::map<int, int> result;
  for (const Fragment& fragment : rendering.fragments) {
    const int source = static_cast<int>(std::lround(fragment.color[0] * 255));
    const auto [known, is_new] = result.emplace(fragment.primitive, source);
    if (!is_new && known->second != source) known->second = -1;
  }
  return result;
}

// SwiftShader draws the pixel of a line's right or upper end and not that of the other one,
// whichever of them comes first. All others draw the first pixel and not the last.
bool draws_upper_ends(const std::string& renderer) {
  return renderer == "egl:zink-swiftshader";
}

struct Assembly {
  Primitive primitive;
  std::vector<std::pair<int, int>> positions;
  std::string numbers;
  std::string upper_numbers;  // by a driver that draws_upper_ends
  std::vector<int> first;     // the vertex that provokes primitive i under either convention
  std::vector<int> last;
};

// A little right of and above the centre of a pixel, well inside its diamond.
constexpr std::pair<int, int> near_centre(int column, int row) {
  return {column * 256 + 128 + 19, row * 256 + 128 + 11};
}

std::vector<Assembly> assemblies() {
  return {
      {Primitive::line_strip,
       {near_centre(1, 1), near_centre(4, 1), near_centre(4, 3), near_centre(1, 3)},
       "......\n..ccc.\n....b.\n.aaab.\n......\n",
       "......\n..cc*.\n....b.\n..aaa.\n......\n",
       {0, 1, 2},
       {1, 2, 3}},
      {Primitive::line_loop,
       {near_centre(1, 1), near_centre(4, 1), near_centre(4, 3), near_centre(1, 3)},
       "......\n.dccc.\n.d..b.\n.aaab.\n......\n",
       "......\n.dcc*.\n.d..b.\n..aaa.\n......\n",
       {0, 1, 2, 3},
       {1, 2, 3, 0}},
      {Primitive::line_loop,
       {near_centre(1, 1), near_centre(4, 1)},
       "......\n......\n......\n.a**b.\n......\n",
       "......\n......\n......\n..***.\n......\n",
       {0, 1},
       {1, 0}},
      // Diagonals from the upper left to the lower right corner of 2x2 squares, off the centres.
      {Primitive::triangle_strip,
       {{10, 512}, {10, 0}, {1034, 512}, {1034, 0}, {1546, 512}},
       "......\n......\n......\naaabcc\nabbbc.\n",
       "......\n......\n......\naaabcc\nabbbc.\n",
       {0, 1, 2},
       {2, 3, 4}},
      {Primitive::triangle_fan,
       {{768 + 8, 640 + 4}, {0, 0}, {1536, 0}, {1536, 1280}, {0, 1280}},
       ".ccccb\n..ccbb\n...bbb\n..aabb\n.aaaab\n",
       ".ccccb\n..ccbb\n...bbb\n..aabb\n.aaaab\n",
       {1, 2, 3},
       {2, 3, 4}},
  };
}

std::map<int, int> to_map(const std::vector<int>& values) {
  std::map<int, int> result;
  for (std::size_t i = 0; i < values.size(); ++i) result[static_cast<int>(i)] = values[i];
  return result;
}

TEST_P(PrimitivesTest, NumbersAndProvokes) {
  for (const Assembly& assembly : assemblies()) {
    for (ProvokingVertex which : {ProvokingVertex::first, ProvokingVertex::last}) {
      SCOPED_TRACE(std::string(name_of(assembly.primitive)) + " " + name_of(which));
      Scene scene = blank(6, 5);
      scene.draws = {numbered_draw(assembly.primitive, assembly.positions, which)};
      const Rendering rendering = render(renderer(), scene);
      EXPECT_EQ(numbers(rendering),
                draws_upper_ends(name()) ? assembly.upper_numbers : assembly.numbers);
      EXPECT_EQ(colour_sources(rendering),
                to_map(which == ProvokingVertex::first ? assembly.first : assembly.last));
    }
  }
}

TEST_P(PrimitivesTest, NumbersGoOnAfterAStrip) {
  Scene scene = blank(6, 2);
  scene.draws = {
      make_draw(Primitive::line_strip, {near_centre(0, 0), near_centre(2, 0), near_centre(4, 0)}),
      make_draw(Primitive::points, {near_centre(1, 1)}),
      make_draw(Primitive::line_loop, {near_centre(3, 1), near_centre(5, 1)})};
  EXPECT_EQ(numbers(render(renderer(), scene)),
            draws_upper_ends(name()) ? ".c..**\n.aabb.\n" : ".c.d*e\naabb..\n");
}

TEST_P(PrimitivesTest, DegeneratePrimitivesKeepTheirNumbers) {
  Scene scene = blank(6, 1);
  scene.draws = {make_draw(Primitive::line_strip, {near_centre(0, 0), near_centre(2, 0),
                                                   near_centre(2, 0), near_centre(4, 0)})};
  EXPECT_EQ(numbers(render(renderer(), scene)), draws_upper_ends(name()) ? ".aacc.\n" : "aacc..\n");
}

TEST_P(PrimitivesTest, SizesOfPoints) {
  const auto point = [&](Fixed size, int x, int y) {
    Scene scene = blank(6, 6);
    scene.draws = {make_draw(Primitive::points, {{x, y}})};
    scene.draws[0].point_size = size;
    return coverage(render(renderer(), scene));
  };
  EXPECT_EQ(point(Fixed::from_integer(2), 2 * 256 + 20, 3 * 256 + 40),
            "......\n......\n.##...\n.##...\n......\n......\n");
  // From 1.09 to 4.59 across, and from 0.86 to 4.36 upwards.
  EXPECT_EQ(point(Fixed::from_raw(7 * Fixed::kOne / 2), 3 * 256 - 40, 3 * 256 - 100),
            "......\n......\n.####.\n.####.\n.####.\n......\n");
}

TEST_P(PrimitivesTest, WideLines) {
  const auto line = [&](std::pair<int, int> a, std::pair<int, int> b) {
    Scene scene = blank(6, 6);
    scene.draws = {make_draw(Primitive::lines, {a, b})};
    scene.draws[0].line_width = Fixed::from_integer(3);
    return render_outcome(renderer(), scene);
  };
  const Outcome across = line({300, 800}, {1270, 810});
  if (const auto* failure = std::get_if<Failure>(&across)) {
    EXPECT_THAT(failure->reason,
                HasSubstr("lines of width 3 are not drawn by this driver: it has"));
    return;
  }
  // 14.5.2.2: the line's fragments, moved by (3 - 1) / 2 and replicated along the minor axis. An
  // end may be one pixel off.
  const auto middle = [](const Outcome& outcome, bool up) {
    std::string text = coverage(std::get<Rendering>(outcome));
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t end : {1u, 4u}) text[up ? 7 * end + i : 7 * i + end] = '-';
    return text;
  };
  EXPECT_EQ(middle(across, false), ".-..-.\n.-##-.\n.-##-.\n.-##-.\n.-..-.\n.-..-.\n");
  EXPECT_EQ(middle(line({800, 300}, {810, 1270}), true),
            "......\n------\n..###.\n..###.\n------\n......\n");
}

TEST_P(PrimitivesTest, ScissorBelongsToItsDraw) {
  Scene scene = blank(6, 4);
  scene.draws = {rectangle(0, 0, 6 * 256, 4 * 256), rectangle(0, 0, 6 * 256, 4 * 256),
                 rectangle(0, 0, 6 * 256, 4 * 256)};
  scene.draws[1].scissor = Viewport{1, -3, 3, 5};
  EXPECT_EQ(coverage(render(renderer(), scene)), "222222\n222222\n233322\n233322\n");
  // An empty rectangle lets nothing pass; the clear is not cut by what was drawn before it.
  scene.draws[1].scissor = Viewport{1, 1, 0, 3};
  EXPECT_EQ(coverage(render(renderer(), scene)), "222222\n222222\n222222\n222222\n");
  EXPECT_THAT(pixel(render(renderer(), blank(6, 4)), 0, 0), ElementsAre(0, 0, 0, 255));
}

TEST_P(PrimitivesTest, NoperspectiveInterpolates) {
  Scene scene = blank(8, 1);
  scene.draws = {rectangle(0, 0, 8 * 256, 256)};
  scene.draws[0].interpolation = Interpolation::noperspective;
  for (Vertex& vertex : scene.draws[0].vertices)
    vertex.color = {vertex.position.x.raw() > 0 ? 1.0f : 0.0f, 0, 0, 1};
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.fragments.size(), 8u);
  for (const Fragment& fragment : rendering.fragments)
    EXPECT_NEAR(fragment.color[0], (fragment.x + 0.5) / 8, 1e-5);
}

TEST_P(PrimitivesTest, RefusesSizesItDoesNotHave) {
  const std::string range = renderer().info().traits.at("point_sizes");
  const double largest = std::stod(range.substr(range.find("to ") + 3));
  if (std::stod(range) <= 0.5 && largest >= 64) GTEST_SKIP() << "it has all sizes: " << range;
  Scene scene = blank(4, 4);
  scene.draws = {make_draw(Primitive::points, {near_centre(1, 1)})};
  scene.draws[0].point_size =
      std::stod(range) > 0.5 ? Fixed::from_raw(Fixed::kOne / 2) : Fixed::from_integer(64);
  const Outcome outcome = render_outcome(renderer(), scene);
  ASSERT_TRUE(std::holds_alternative<Failure>(outcome));
  EXPECT_THAT(std::get<Failure>(outcome).reason, HasSubstr("it has " + range));
  // Sizes of what is not drawn do not matter.
  scene.draws[0].primitive = Primitive::line_strip;
  scene.draws[0].vertices.push_back(scene.draws[0].vertices[0]);
  EXPECT_TRUE(std::holds_alternative<Rendering>(render_outcome(renderer(), scene)));
}

INSTANTIATE_TEST_SUITE_P(OpenGl, PrimitivesTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
