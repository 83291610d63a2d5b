// SPDX-License-Identifier: MIT
//
// Every case of triangles on targets of one sample that the installed suite has, each a test.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "casefile/loader.h"
#include "diff/compare.h"
#include "diff/judge.h"
#include "half_space.h"
#include "raster/rasterizer.h"

namespace {

using edgecase::Case;

// What the rasterizer under test draws: fragments alone, of which no depth and colour is told.
edgecase::Rendering draw(const edgecase::Scene& scene) {
  edgecase::Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  for (const edgecase::ScenePrimitive& primitive : edgecase::primitives_of(scene)) {
    std::array<std::array<double, 2>, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const edgecase::Point at = edgecase::nearest_point(primitive.positions[i]);
      triangle[i] = {at.x.to_double(), at.y.to_double()};
    }
    for (const PixelPlace p : half_space_pixels(triangle, rendering.width, rendering.height)) {
      edgecase::Fragment fragment;
      fragment.x = p.x;
      fragment.y = p.y;
      fragment.primitive = primitive.index;
      fragment.has_depth = fragment.has_color = false;
      rendering.fragments.push_back(fragment);
    }
  }
  edgecase::sort_fragments(rendering);
  return rendering;
}

std::vector<Case> cases_of_suite() {
  std::vector<Case> cases;
  const std::vector<std::filesystem::path> folders = {
      CASES "/triangles/single", CASES "/triangles/shared-edges", CASES "/triangles/ties"};
  for (const auto& file : edgecase::find_cases(folders).cases)
    for (Case& one : edgecase::load_cases(file.file, file.id).cases)
      if (one.scene.target.samples == 1) cases.push_back(std::move(one));
  return cases;
}

class Conformance : public testing::TestWithParam<Case> {};

TEST_P(Conformance, DrawsWhatTheSpecificationAllows) {
  const Case& one = GetParam();
  const edgecase::Policy opengl;
  const edgecase::Rendering exact = edgecase::rasterize(one.scene, opengl);
  edgecase::Result result = edgecase::compare(one.scene, opengl, exact, draw(one.scene), {});
  edgecase::Result* const results[] = {&result};
  edgecase::judge(results, edgecase::Latitude::opengl);
  for (const edgecase::Disagreement& d : result.disagreements) ADD_FAILURE() << d.explanation;
  EXPECT_EQ(result.verdict, edgecase::Verdict::agree);
}

std::string name_of_test(const testing::TestParamInfo<Case>& info) {
  std::string name = std::to_string(info.index) + "_" + info.param.id;
  for (char& c : name)
    if (!isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Suite, Conformance, testing::ValuesIn(cases_of_suite()), name_of_test);

// Where the suite is not found, there would be nothing to fail.
TEST(Suite, IsThere) {
  EXPECT_GE(cases_of_suite().size(), 100u);
}

}  // namespace
