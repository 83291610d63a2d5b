// SPDX-License-Identifier: MIT
//
// Samples as case files give them, their images, their drawings, and back to text; each refusal has
// a file in bad/ or bad_loader_only/.
#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <string>

#include "casefile/case_writer.h"
#include "casefile/loader.h"
#include "exact/numeral.h"
#include "model/scene.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

const fs::path kGood = fs::path(EDGECASE_ROOT) / "tests" / "casefile" / "good";

// One triangle, with this beside the target's size, in its state, and beside the draws.
std::map<std::string, Case> cases_of(const std::string& target, const std::string& state,
                                     const std::string& more = "") {
  const LoadedCases loaded = load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 4, "height": 2, )" + target +
          R"(}, "draws": [{"primitive": "triangles", "vertices": [[0, 0], [2, 0], [0, 2]],
              "state": {)" +
          state + "}}]" + more + "}",
      "a.json", "a");
  for (const Diagnostic& fault : loaded.diagnostics) ADD_FAILURE() << to_string(fault);
  std::map<std::string, Case> result;
  for (const Case& one : loaded.cases) result[one.id.substr(1)] = one;
  return result;
}

std::vector<std::string> spots(const Case& one) {
  std::vector<std::string> result;
  for (const Point within : one.scene.target.sample_positions)
    result.push_back(to_decimal(within.x) + "," + to_decimal(within.y));
  return result;
}

TEST(Samples, DefaultsAreThoseOfTheModel) {
  const auto cases = cases_of(R"("samples": 8)", "");
  ASSERT_EQ(cases.size(), 1U);
  const Scene& scene = cases.at("").scene;
  EXPECT_EQ(scene.target.samples, 8);
  EXPECT_THAT(scene.target.sample_positions, IsEmpty());
  EXPECT_EQ(scene.draws[0].multisampling, Multisampling{});
}

TEST(Samples, EveryNumberOfThemIsRead) {
  for (int samples = 1; samples <= kMaxSamples; ++samples) {
    const auto cases = cases_of("\"samples\": " + std::to_string(samples), "");
    ASSERT_EQ(cases.size(), 1U);
    EXPECT_EQ(cases.at("").scene.target.samples, samples);
  }
}

TEST(Samples, EveryKeyIsRead) {
  const auto cases =
      cases_of(R"("samples": 2, "sample_positions": [[0, "65535/65536"], ["~0.1", 0.5]])",
               R"("multisample": false, "attribute_location": "centroid", "sample_mask": 2,
                  "min_sample_shading": "~0.3", "alpha_to_coverage": true)");
  ASSERT_EQ(cases.size(), 1U);
  const Scene& scene = cases.at("").scene;
  EXPECT_THAT(scene.target.sample_positions,
              ElementsAre(Point{Fixed(), Fixed::from_raw(65535)},
                          Point{Fixed::from_raw(6554), Fixed::from_raw(32768)}));
  const Multisampling& own = scene.draws[0].multisampling;
  EXPECT_FALSE(own.enabled);
  EXPECT_EQ(own.location, AttributeLocation::centroid);
  EXPECT_EQ(own.min_sample_shading, 0.3F);
  EXPECT_EQ(own.mask, 2U);
  EXPECT_TRUE(own.alpha_to_coverage);
}

TEST(Samples, TheSamePlaceMayHaveTwo) {
  const auto cases = cases_of(R"("samples": 2, "sample_positions": [[0.5, 0.5], [0.5, 0.5]])", "");
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_THAT(spots(cases.at("")), ElementsAre("0.5,0.5", "0.5,0.5"));
}

TEST(Samples, SweepsReachThem) {
  const auto cases = cases_of(
      R"("samples": 2, "sample_positions": [[0.5, 0.25], [0.125, 0.75]])", R"("sample_mask": 1)",
      R"(, "sweep": {"x": {"add_to": ["/target/sample_positions/0/0"], "values": [0, "3/256"]},
                     "y": {"set": ["/target/sample_positions/1/1"], "values": [0.75, "1/65536"]},
                     "mask": {"set": ["/draws/0/state/sample_mask"], "values": [0, 3]},
                     "rate": {"set": ["/draws/0/state/min_sample_shading"], "values": [0, 0.5]}})");
  ASSERT_EQ(cases.size(), 16U);
  const Case& one = cases.at(":x=0.01171875:y=0.0000152587890625:mask=3:rate=0.5");
  EXPECT_THAT(spots(one), ElementsAre("0.51171875,0.25", "0.125,0.0000152587890625"));
  EXPECT_EQ(one.scene.draws[0].multisampling.mask, 3U);
  EXPECT_EQ(one.scene.draws[0].multisampling.min_sample_shading, 0.5F);
}

// Each sample keeps its index: octant 5 mirrors x, then exchanges.
TEST(Samples, OctantsTurnThemWithTheImage) {
  const std::string target =
      R"("samples": 2, "sample_positions": [[0.125, 0.25], [0.5, "1/65536"]])";
  const auto cases = cases_of(target, "", R"(, "variants": ["octants", "translate", "winding"])");
  ASSERT_EQ(cases.size(), 10U);
  const auto at = [&](const char* part) { return spots(cases.at(part)); };
  EXPECT_THAT(at(""), ElementsAre("0.125,0.25", "0.5,0.0000152587890625"));
  EXPECT_THAT(at(":octant=1"), ElementsAre("0.875,0.25", "0.5,0.0000152587890625"));
  EXPECT_THAT(at(":octant=2"), ElementsAre("0.125,0.75", "0.5,0.9999847412109375"));
  EXPECT_THAT(at(":octant=3"), ElementsAre("0.875,0.75", "0.5,0.9999847412109375"));
  EXPECT_THAT(at(":octant=4"), ElementsAre("0.25,0.125", "0.0000152587890625,0.5"));
  EXPECT_THAT(at(":octant=5"), ElementsAre("0.25,0.875", "0.0000152587890625,0.5"));
  EXPECT_THAT(at(":octant=6"), ElementsAre("0.75,0.125", "0.9999847412109375,0.5"));
  EXPECT_THAT(at(":octant=7"), ElementsAre("0.75,0.875", "0.9999847412109375,0.5"));
  for (const char* part : {":translate=3,2", ":winding"}) EXPECT_EQ(at(part), at("")) << part;
}

TEST(Samples, OnlyMirrorsTakeAPositionOutOfItsPixel) {
  const LoadedCases loaded = load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 4, "height": 2, "samples": 2,
          "sample_positions": [[0.5, 0.5], [0, 0.5]]}, "variants": ["translate", "reverse"],
          "draws": [{"primitive": "lines", "vertices": [[0, 0], [2, 0]]}]})",
      "a.json", "a");
  EXPECT_EQ(loaded.cases.size(), 3U);
}

TEST(Samples, WhereThereAreNoneImagesHaveNone) {
  const auto cases = cases_of(R"("samples": 4)", "", R"(, "variants": ["octants"])");
  ASSERT_EQ(cases.size(), 8U);
  for (const auto& [part, one] : cases) {
    EXPECT_THAT(spots(one), IsEmpty());
    EXPECT_EQ(one.scene.target.samples, 4);
  }
}

TEST(Samples, CountDownwardsWithTheFile) {
  const auto cases = cases_of(
      R"("samples": 2, "sample_positions": [[0.125, 0.25], [0.5, 0.75]], "y": "down")", "");
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_THAT(spots(cases.at("")), ElementsAre("0.125,0.75", "0.5,0.25"));
}

TEST(Samples, DrawingsOfMasksHaveTheirTopRowFirst) {
  const auto cases =
      cases_of(R"("samples": 12)", "",
               R"(, "expect": [{"policy": "p", "masks": [".  1 .  00c", " FfF . aB 800 "]}])");
  ASSERT_EQ(cases.size(), 1U);
  ASSERT_EQ(cases.at("").expect.size(), 1U);
  const Expect& expect = cases.at("").expect[0];
  EXPECT_EQ(expect.policy, "p");
  EXPECT_THAT(expect.coverage, IsEmpty());
  EXPECT_THAT(expect.masks, ElementsAre(0xfff, 0, 0xab, 0x800, 0, 1, 0, 0xc));
  EXPECT_THAT(expect.where, testing::HasSubstr("/expect/0/masks"));
}

CaseText written(const Scene& scene) {
  CaseWords words;
  words.title = "A scene";
  words.rules = {"triangle.fill-rule"};
  return case_text(scene, words);
}

TEST(Samples, EveryCaseComesBack) {
  std::size_t count = 0;
  for (const char* name : {"samples-everything.json", "samples-sixteen.json"}) {
    for (const Case& one : load_cases(kGood / name, "samples").cases) {
      SCOPED_TRACE(one.id);
      const CaseText text = written(one.scene);
      for (const Diagnostic& fault : text.diagnostics) ADD_FAILURE() << to_string(fault);
      const LoadedCases read = load_cases_text(text.text, "a.json", "another");
      ASSERT_EQ(read.cases.size(), 1U) << text.text;
      EXPECT_TRUE(same_scene(read.cases[0].scene, one.scene)) << text.text;
      EXPECT_EQ(written(read.cases[0].scene).text, text.text);
      ++count;
    }
  }
  EXPECT_EQ(count, 3U * 2 * 3 * 2 * 2 * 11 + 3 * 8);
}

TEST(Samples, AreWrittenAsAPersonWould) {
  const auto cases = cases_of(
      R"("clear": [0, 0, 0], "samples": 2, "sample_positions": [[0.25, 0.125], ["3/256", 0]])",
      R"("multisample": false, "attribute_location": "sample", "min_sample_shading": 0.5,
         "sample_mask": 0, "alpha_to_coverage": true)");
  ASSERT_EQ(cases.size(), 1U);
  Scene scene = cases.at("").scene;
  for (Vertex& vertex : scene.draws[0].vertices) vertex.color = {1, 1, 1, 1};
  EXPECT_EQ(written(scene).text, R"({
  "title": "A scene",
  "rules": ["triangle.fill-rule"],
  "target": {
    "width": 4,
    "height": 2,
    "samples": 2,
    "sample_positions": [[0.25, 0.125], ["3/256", 0]],
    "clear": [0, 0, 0]
  },
  "draws": [
    {
      "primitive": "triangles",
      "vertices": [[0, 0], [2, 0], [0, 2]],
      "color": [1, 1, 1],
      "state": {
        "multisample": false,
        "attribute_location": "sample",
        "min_sample_shading": 0.5,
        "alpha_to_coverage": true,
        "sample_mask": 0
      }
    }
  ]
}
)");
}

TEST(Samples, WhatACaseFileCannotSayIsRefused) {
  const auto cases = cases_of(R"("samples": 2)", "");
  ASSERT_EQ(cases.size(), 1U);
  const Scene scene = cases.at("").scene;
  EXPECT_THAT(written(scene).diagnostics, IsEmpty());
  const auto fault_of = [](const Scene& changed) {
    const CaseText text = written(changed);
    return text.diagnostics.empty() ? "" : to_string(text.diagnostics[0]);
  };
  Scene changed = scene;
  changed.target.samples = 17;
  EXPECT_THAT(fault_of(changed), testing::HasSubstr("samples is 17, out of range"));
  changed = scene;
  changed.target.surface = Surface::window;
  EXPECT_THAT(fault_of(changed), testing::HasSubstr("a window's samples cannot be chosen"));
  changed = scene;
  changed.details.derivatives = true;
  EXPECT_THAT(fault_of(changed), testing::HasSubstr("derivatives with several samples"));
  changed = scene;
  changed.draws[0].multisampling.mask = 4;
  EXPECT_THAT(fault_of(changed), testing::HasSubstr("sample_mask is 4, out of range"));
  changed = scene;
  changed.target.sample_positions = {centre_of_pixel()};
  EXPECT_THAT(fault_of(changed), testing::HasSubstr("sample_positions has 1 points"));
  changed = scene;
  changed.target.samples = 1;
  changed.draws[0].multisampling.alpha_to_coverage = true;
  EXPECT_THAT(fault_of(changed), testing::HasSubstr("\"alpha_to_coverage\" is for several"));
}

}  // namespace
}  // namespace edgecase
