// SPDX-License-Identifier: MIT
#include "suite/policy_contrast.h"

#include <gtest/gtest.h>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

Point at(double x, double y) {
  return {Fixed::from_raw(static_cast<std::int64_t>(x * 65536)),
          Fixed::from_raw(static_cast<std::int64_t>(y * 65536))};
}

Draw draw_of(Primitive primitive, const std::vector<Point>& points, float red) {
  Draw draw;
  draw.primitive = primitive;
  for (const Point& point : points) {
    Vertex vertex;
    vertex.position = point;
    vertex.color = {red, 0.5F, 0.25F, 1};
    draw.vertices.push_back(vertex);
  }
  return draw;
}

Scene scene_of(std::vector<Draw> draws) {
  Scene scene;
  scene.target.width = 8;
  scene.target.height = 8;
  scene.viewport = {0, 0, 8, 8};
  scene.draws = std::move(draws);
  return scene;
}

// An edge through a row of centres, which `closed` draws and `left-top` does not: a bottom edge.
Scene edge_on_centres() {
  return scene_of({draw_of(Primitive::triangles, {at(1, 2.5), at(7, 2.5), at(1, 7)}, 1)});
}

// And beside it a line that every algorithm draws in its own way.
Scene edge_and_line() {
  Scene scene = edge_on_centres();
  scene.draws.push_back(draw_of(Primitive::lines, {at(1, 0.5), at(7, 1.5)}, 0));
  return scene;
}

Policy policy_of(Choices rules) {
  Policy policy;
  policy.name = "mine";
  policy.rules = std::move(rules);
  return policy;
}

TEST(PolicyContrast, ChoicesAreThoseThatOpenGlHasOtherwise) {
  Policy policy = policy_of({{"triangle.fill-rule", "closed"},
                             {"line.algorithm", "diamond-exit"},
                             {"subpixel.snap", "8-half-even"}});
  policy.surfaces[Surface::window] = {{"subpixel.snap", "none"}, {"line.algorithm", "midpoint"}};
  const auto names = [&](Surface surface) {
    std::vector<std::string> result;
    for (const ContrastingChoice& choice : contrasting_choices(policy, surface)) {
      EXPECT_EQ(choice.standard, find_rule(choice.rule)->standard);
      result.push_back(choice.rule + "=" + choice.alternative);
    }
    return result;
  };
  EXPECT_EQ(names(Surface::fbo),
            (std::vector<std::string>{"triangle.fill-rule=closed", "subpixel.snap=8-half-even"}));
  EXPECT_EQ(names(Surface::window),
            (std::vector<std::string>{"line.algorithm=midpoint", "triangle.fill-rule=closed"}));
  EXPECT_TRUE(contrasting_choices({}, Surface::fbo).empty());
}

TEST(PolicyContrast, AllPutBackIsOpenGl) {
  Policy policy = policy_of({{"triangle.fill-rule", "closed"}, {"line.algorithm", "midpoint"}});
  policy.surfaces[Surface::fbo] = {{"line.algorithm", "bresenham"}};
  const Policy back = with_standard(policy, {"triangle.fill-rule", "line.algorithm"});
  EXPECT_TRUE(contrasting_choices(back, Surface::fbo).empty());
  EXPECT_EQ(contrasting_choices(with_standard(policy, {"line.algorithm"}), Surface::fbo).size(),
            1U);
  const Scene scene = edge_and_line();
  EXPECT_TRUE(is_same_picture(rasterize(scene, back), rasterize(scene, {})));
  EXPECT_FALSE(is_same_picture(rasterize(scene, policy), rasterize(scene, {})));
}

TEST(PolicyContrast, OneRuleAlone) {
  const PolicyContrast contrast =
      contrast_with_opengl(edge_on_centres(), policy_of({{"triangle.fill-rule", "closed"},
                                                         {"line.algorithm", "midpoint"},
                                                         {"attribute.provoking-vertex", "first"}}));
  EXPECT_FALSE(contrast.is_same);
  EXPECT_EQ(contrast.alone, std::vector<std::string>{"triangle.fill-rule"});
  EXPECT_TRUE(contrast.together.empty());
  EXPECT_FALSE(is_same_picture(contrast.under_policy, contrast.under_opengl));
}

TEST(PolicyContrast, TwoRulesTogetherAreASmallestSet) {
  const PolicyContrast contrast =
      contrast_with_opengl(edge_and_line(), policy_of({{"triangle.fill-rule", "closed"},
                                                       {"line.algorithm", "midpoint"},
                                                       {"attribute.provoking-vertex", "first"},
                                                       {"point.ownership", "open"}}));
  EXPECT_TRUE(contrast.alone.empty());
  EXPECT_EQ(contrast.together, (std::vector<std::string>{"line.algorithm", "triangle.fill-rule"}));
}

// Four rules, each with a primitive of its own: a set of three is not enough.
TEST(PolicyContrast, MoreThanThreeAreAll) {
  Scene scene = edge_and_line();
  scene.draws.push_back(draw_of(Primitive::points, {at(1, 1)}, 0.75));
  Draw flat = draw_of(Primitive::triangles, {at(5, 5), at(7.75, 5), at(7.75, 7.75)}, 0.5);
  flat.vertices[0].color = {0, 0, 1, 1};
  scene.draws.push_back(flat);
  const Choices rules{{"triangle.fill-rule", "closed"},
                      {"line.algorithm", "midpoint"},
                      {"attribute.provoking-vertex", "first"},
                      {"point.ownership", "left-bottom"}};
  const PolicyContrast contrast = contrast_with_opengl(scene, policy_of(rules));
  EXPECT_TRUE(contrast.alone.empty());
  EXPECT_EQ(contrast.together.size(), 4U);
}

// Pixels that are drawn twice in one colour differ from those that are drawn once.
TEST(PolicyContrast, CountsBelongToThePicture) {
  Draw left = draw_of(Primitive::triangles, {at(1, 1), at(4.5, 1), at(4.5, 7)}, 1);
  Draw right = draw_of(Primitive::triangles, {at(4.5, 1), at(7, 7), at(4.5, 7)}, 1);
  const Scene scene = scene_of({left, right});
  const PolicyContrast contrast =
      contrast_with_opengl(scene, policy_of({{"triangle.fill-rule", "closed"}}));
  EXPECT_FALSE(contrast.is_same);
  EXPECT_EQ(contrast.alone, std::vector<std::string>{"triangle.fill-rule"});
}

TEST(PolicyContrast, NothingDiffersUnderOpenGlItself) {
  const PolicyContrast contrast = contrast_with_opengl(edge_and_line(), {});
  EXPECT_TRUE(contrast.is_same);
  EXPECT_TRUE(contrast.alone.empty());
  EXPECT_TRUE(contrast.together.empty());
}

}  // namespace
}  // namespace edgecase
