// SPDX-License-Identifier: MIT
//
// Images of the suite's scenes are scenes: a program is asked for nothing that the protocol
// refuses; and exact, which keeps every law, draws each like what it is an image of.
#include <gtest/gtest.h>

#include <vector>

#include "diff/invariance.h"
#include "raster/rasterizer.h"
#include "suite/selection.h"
#include "wire/request_line.h"

namespace edgecase {
namespace {

void expect_a_scene(const Scene& scene, const std::string& id) {
  const auto read = parse_request(request_line(id, scene_json(scene)));
  const auto* const error = std::get_if<WireError>(&read);
  EXPECT_EQ(error, nullptr) << id << ": " << (error != nullptr ? error->message : "");
}

TEST(Images, OfTheSuiteAreScenesThatExactDrawsAlike) {
  constexpr std::size_t kStep = 211;
  Selection selection;
  selection.paths = {std::filesystem::path(EDGECASE_ROOT) / "cases"};
  const Suite suite = load_suite(selection);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < suite.cases.size(); i += kStep) {
    const Case one = suite.cases[i];
    const Rendering own = rasterize(one.scene, Policy{});
    for (const SceneImage& image : images_of(one.scene)) {
      if (image.right > 0) ++moved;
      if (image.first) expect_a_scene(*image.first, one.id);
      expect_a_scene(image.second, one.id);
      std::vector<Variance> found;
      find_variances(image, image.first ? rasterize(*image.first, Policy{}) : own,
                     rasterize(image.second, Policy{}), found);
      EXPECT_TRUE(found.empty()) << one.id << ": " << found.front().what;
    }
  }
  EXPECT_GT(moved, 10U);
}

}  // namespace
}  // namespace edgecase
