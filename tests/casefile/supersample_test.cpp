// SPDX-License-Identifier: MIT
//
// Supersampling as case files give it, its images, and back to text; each refusal has a file in
// bad/ or bad_loader_only/.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include "casefile/case_writer.h"
#include "casefile/loader.h"
#include "casefile/scene/patterns.h"
#include "casefile/scene/viewport.h"
#include "model/scene.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const fs::path kGood = fs::path(EDGECASE_ROOT) / "tests" / "casefile" / "good";

Point at(std::int64_t raw_x, std::int64_t raw_y) {
  return {Fixed::from_raw(raw_x), Fixed::from_raw(raw_y)};
}

// One triangle, with this as "supersample", and beside the draws.
std::map<std::string, Case> cases_of(const std::string& supersample, const std::string& more = "",
                                     const std::string& target = "") {
  const LoadedCases loaded = load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 4, "height": 2, "supersample": {)" +
          supersample + "}" + target +
          R"(}, "draws": [{"primitive": "triangles", "vertices": [[0, 0], [2, 0], [0, 2]]}])" +
          more + "}",
      "a.json", "a");
  for (const Diagnostic& fault : loaded.diagnostics) ADD_FAILURE() << to_string(fault);
  std::map<std::string, Case> result;
  for (const Case& one : loaded.cases) result[one.id.substr(1)] = one;
  return result;
}

Supersampling passes_given(const std::string& supersample) {
  const auto cases = cases_of(supersample);
  return cases.empty() ? Supersampling{} : cases.begin()->second.scene.supersampling;
}

TEST(Supersample, PatternsAreThoseOfTheirNames) {
  EXPECT_EQ(passes_given(R"("grid": 5)"), filtered(grid_pattern(5), {}));
  EXPECT_EQ(passes_given(R"("jittered": 5, "seed": 9)"), filtered(jittered_pattern(5, 9), {}));
  EXPECT_EQ(passes_given(R"("n-rooks": 5, "seed": 9)"), filtered(n_rooks_pattern(5, 9), {}));
  EXPECT_EQ(passes_given(R"("random": 5, "seed": 9)"), filtered(random_pattern(5, 9), {}));
  EXPECT_EQ(passes_given(R"("grid": 32)").size(), kMaxPasses);
}

TEST(Supersample, KernelsHaveTheirRadii) {
  const Fixed one = Fixed::from_integer(1);
  const Pattern grid = grid_pattern(4);
  EXPECT_EQ(passes_given(R"("grid": 4, "kernel": "box")"), filtered(grid, {}));
  EXPECT_EQ(passes_given(R"("grid": 4, "kernel": "tent")"), filtered(grid, {Kernel::tent, one}));
  EXPECT_EQ(passes_given(R"("grid": 4, "kernel": "gaussian")"),
            filtered(grid, {Kernel::gaussian, one}));
  EXPECT_EQ(passes_given(R"("grid": 4, "radius": "5/4")"),
            filtered(grid, {Kernel::box, Fixed::from_raw(81920)}));
  EXPECT_EQ(passes_given(R"("samples": [["1/4", 0]], "kernel": "tent", "radius": 1.5)"),
            filtered({at(16384, 0)}, {Kernel::tent, Fixed::from_raw(98304)}));
}

TEST(Supersample, ListedSamplesAreTakenAsTheyAre) {
  EXPECT_THAT(passes_given(R"("samples": [[-1, 2], ["~0.1", "65535/65536"]])"),
              ElementsAre(ShadingPass{at(-65536, 131072), 1}, ShadingPass{at(6554, 65535), 1}));
  EXPECT_THAT(
      passes_given(R"("samples": [[0.5, 0.5], [0.5, 0.5]], "weights": [1048576, 2])"),
      ElementsAre(ShadingPass{at(32768, 32768), 1048576}, ShadingPass{at(32768, 32768), 2}));
}

TEST(Supersample, IsNoneWhereItIsNotGiven) {
  const LoadedCases loaded = load_cases(kGood / "minimal.json", "minimal");
  ASSERT_EQ(loaded.cases.size(), 1U);
  EXPECT_THAT(loaded.cases[0].scene.supersampling, IsEmpty());
}

TEST(Supersample, SweepsReachIt) {
  const auto cases = cases_of(
      R"("samples": [[0.5, 0.25]], "weights": [1])",
      R"(, "sweep": {"x": {"add_to": ["/target/supersample/samples/0/0"], "values": [0, "3/256"]},
                     "w": {"set": ["/target/supersample/weights/0"], "values": [1, 9]}})");
  ASSERT_EQ(cases.size(), 4U);
  EXPECT_THAT(cases.at(":x=0.01171875:w=9").scene.supersampling,
              ElementsAre(ShadingPass{at(33536, 16384), 9}));
}

// Octant 5 mirrors x, then exchanges. Places at 0 mirror to 1, in the next pixel.
TEST(Supersample, OctantsTurnPlacesAboutTheCentre) {
  const auto cases = cases_of(R"("samples": [["1/8", 0], [1.75, -1]], "weights": [5, 7])",
                              R"(, "variants": ["octants", "translate", "winding"])");
  ASSERT_EQ(cases.size(), 10U);
  const auto passes = [&](const char* part) { return cases.at(part).scene.supersampling; };
  const auto expected = [](Point first, Point second) {
    return Supersampling{{first, 5}, {second, 7}};
  };
  constexpr std::int64_t kOne = 65536, kLeft = 8192, kRight = 57344, kFar = 114688, kNear = -49152;
  EXPECT_EQ(passes(""), expected(at(kLeft, 0), at(kFar, -kOne)));
  EXPECT_EQ(passes(":octant=1"), expected(at(kRight, 0), at(kNear, -kOne)));
  EXPECT_EQ(passes(":octant=2"), expected(at(kLeft, kOne), at(kFar, 2 * kOne)));
  EXPECT_EQ(passes(":octant=3"), expected(at(kRight, kOne), at(kNear, 2 * kOne)));
  EXPECT_EQ(passes(":octant=4"), expected(at(0, kLeft), at(-kOne, kFar)));
  EXPECT_EQ(passes(":octant=5"), expected(at(0, kRight), at(-kOne, kNear)));
  EXPECT_EQ(passes(":octant=6"), expected(at(kOne, kLeft), at(2 * kOne, kFar)));
  EXPECT_EQ(passes(":octant=7"), expected(at(kOne, kRight), at(2 * kOne, kNear)));
  for (const char* part : {":translate=3,2", ":winding"})
    EXPECT_EQ(passes(part), passes("")) << part;
}

TEST(Supersample, CountsDownwardsWithTheFile) {
  const auto cases = cases_of(R"("samples": [["1/8", "1/4"]])", "", R"(, "y": "down")");
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_THAT(cases.at("").scene.supersampling, ElementsAre(ShadingPass{at(8192, 49152), 1}));
}

// The viewport that is chosen holds every pass, exactly.
TEST(Supersample, ViewportsAreChosenForAllPasses) {
  for (const char* supersample :
       {R"("grid": 3)", R"("random": 64, "seed": 3)", R"("samples": [[-1, -1], [2, 2]])"}) {
    const auto cases = cases_of(supersample);
    ASSERT_EQ(cases.size(), 1U);
    const Scene& scene = cases.at("").scene;
    EXPECT_NE(scene.viewport.width, 4);
    for (const Scene& pass : passes_of(scene))
      for (const Vertex& vertex : pass.draws[0].vertices) {
        const Viewport& box = scene.viewport;
        EXPECT_FALSE(find_inexactness(vertex.position.x, {box.x, box.width}, 'x'));
        EXPECT_FALSE(find_inexactness(vertex.position.y, {box.y, box.height}, 'y'));
      }
  }
}

TEST(Supersample, ShiftsAreToldOnceEach) {
  const Shifts shifts = shifts_of({{at(0, 1), 1}, {at(65536, 1), 1}, {at(0, 2), 1}});
  EXPECT_THAT(shifts.x, ElementsAre(Fixed::from_raw(-32768), Fixed::from_raw(32768)));
  EXPECT_THAT(shifts.y, ElementsAre(Fixed::from_raw(32766), Fixed::from_raw(32767)));
  EXPECT_THAT(shifts_of({}).x, ElementsAre(Fixed()));
  EXPECT_THAT(shifts_of({}).y, ElementsAre(Fixed()));
}

CaseText written(const Scene& scene) {
  CaseWords words;
  words.title = "A scene";
  words.rules = {"triangle.fill-rule"};
  return case_text(scene, words);
}

TEST(Supersample, EveryCaseComesBack) {
  std::size_t count = 0;
  for (const char* name : {"everything", "grids", "jittered", "rooks", "weights"}) {
    const fs::path file = kGood / (std::string("supersample-") + name + ".json");
    for (const Case& one : load_cases(file, "supersample").cases) {
      SCOPED_TRACE(one.id);
      const CaseText text = written(one.scene);
      for (const Diagnostic& fault : text.diagnostics) ADD_FAILURE() << to_string(fault);
      const LoadedCases read = load_cases_text(text.text, "a.json", "another");
      ASSERT_EQ(read.cases.size(), 1U) << text.text;
      EXPECT_TRUE(same_scene(read.cases[0].scene, one.scene)) << text.text;
      ++count;
    }
  }
  EXPECT_EQ(count, 2U * 2 * 3 * 3 * 11 + 6 + 9 + 9 + 2);
}

TEST(Supersample, IsWrittenPassByPass) {
  const auto text_of = [&](const std::string& supersample) {
    const auto cases = cases_of(supersample);
    return cases.size() == 1 ? written(cases.at("").scene).text : std::string();
  };
  EXPECT_THAT(text_of(R"("grid": 2)"),
              HasSubstr(R"("supersample": {"samples": [[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], )"
                        R"([0.75, 0.75]]})"));
  const std::string tent = text_of(R"("samples": [[0.5, 0.25]], "kernel": "tent")");
  EXPECT_THAT(tent, HasSubstr(R"("samples": [[0.5, 0.25], [0.5, 1.25]])"));
  EXPECT_THAT(tent, HasSubstr(R"("weights": [49152, 16384])"));
}

TEST(Supersample, WhatACaseFileCannotSayIsRefused) {
  const auto cases = cases_of(R"("grid": 1)");
  ASSERT_EQ(cases.size(), 1U);
  const auto fault_of = [](const Scene& changed) {
    const CaseText text = written(changed);
    return text.diagnostics.empty() ? "" : to_string(text.diagnostics[0]);
  };
  Scene changed = cases.at("").scene;
  EXPECT_EQ(fault_of(changed), "");
  changed.supersampling[0].weight = 0;
  EXPECT_THAT(fault_of(changed), HasSubstr("a weight is 0, out of range"));
  changed = cases.at("").scene;
  changed.supersampling[0].at.x = Fixed::from_integer(3);
  EXPECT_THAT(fault_of(changed), HasSubstr("x of a sample is 3, out of range"));
  changed = cases.at("").scene;
  changed.supersampling.resize(1025, changed.supersampling[0]);
  EXPECT_THAT(fault_of(changed), HasSubstr("samples has 1025 points"));
}

}  // namespace
}  // namespace edgecase
