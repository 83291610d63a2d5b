// SPDX-License-Identifier: MIT
//
// The cases of the suite, as the framebuffer draws them on each SIMD target of the machine: to the
// bit what the plain rasterizer, without a kernel, puts into their pixels. Every eighth of them,
// another eighth for each further time in EDGECASE_KERNEL_SCENES: 8 and more asks all.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "casefile/loader.h"
#include "kernels/kernels.h"
#include "raster/framebuffer.h"
#include "raster/rasterizer.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

TEST(FramebufferSuite, DrawsItsCasesAsThePlainPath) {
  const int eighths = std::min(kernel_scene_factor(), 8);
  Policy snapped;
  snapped.rules = {{"subpixel.snap", "8-half-even"}, {"triangle.fill-rule", "left-bottom"}};
  std::vector<std::string> targets = kernel_names();
  targets.pop_back();
  const std::filesystem::path suite[] = {std::filesystem::path(EDGECASE_ROOT) / "cases"};
  int count = 0, asked = 0, drawn = 0;
  Dealer files;
  for (const CaseFile& file : find_cases(suite).cases) {
    if (!files.deal()) continue;
    for (const Case& one : load_cases(file.file, file.id).cases) {
      if (count++ % 8 >= eighths) continue;
      ++asked;
      for (const Policy& policy : {Policy(), snapped}) {
        use_kernels("none");
        const auto plain = rasterize(one.scene, policy).pixels;
        for (const std::string& target : targets) {
          use_kernels(target);
          ExactDrawing drawing(std::span(&one.scene, 1), policy);
          drawing.draw();
          ASSERT_EQ(drawing.pixels(), plain) << one.id << " on " << target;
        }
        if (Framebuffer(one.scene.target, policy).prepared(one.scene)) ++drawn;
      }
    }
  }
  use_kernels(targets.front());
  std::printf("%d of %d renderings by the framebuffer, on %zu SIMD targets\n", drawn, asked * 2,
              targets.size());
  EXPECT_GT(drawn, asked);
}

}  // namespace
}  // namespace edgecase
