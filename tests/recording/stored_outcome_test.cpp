// SPDX-License-Identifier: MIT
//
// Every kind of rendering, as exact makes it of cases of the suite, through a block and back.
#include "recording/recording.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "model/policy.h"
#include "raster/rasterizer.h"
#include "recording/block.h"
#include "suite/selection.h"
#include "wire/rendering_json.h"

namespace edgecase::recording {
namespace {

using ::testing::HasSubstr;

// What kinds of renderings a test has met.
struct Met {
  bool samples = false, positions = false, depths = false, stencils = false, passes = false,
       chains = false, details = false, hits = false;

  void note(const Rendering& rendering) {
    samples = samples || !rendering.sample_pixels.empty();
    positions = positions || !rendering.sample_positions.empty();
    depths = depths || !rendering.depths.empty();
    stencils = stencils || !rendering.stencils.empty();
    passes = passes || !rendering.passes.empty();
    chains = chains || !rendering.mip_chains.empty();
    details = details || !rendering.details.empty();
    hits = hits || !rendering.hits.empty();
  }
};

Suite some_of_the_suite() {
  Selection selection;
  selection.paths = {std::filesystem::path(EDGECASE_ROOT) / "cases"};
  selection.excludes = {"scenes/*"};
  selection.sample = {7, 150};
  return load_suite(selection);
}

std::string text_of(const Outcome& outcome) {
  const auto* rendering = std::get_if<Rendering>(&outcome);
  return rendering == nullptr ? std::get<Failure>(outcome).reason
                              : rendering_json("", *rendering) + hits_json(*rendering);
}

TEST(StoredOutcome, EveryKindOfRenderingComesBack) {
  const Suite suite = some_of_the_suite();
  ASSERT_GT(suite.cases.size(), 100u);
  Met met;
  std::vector<std::string> lines;
  std::vector<std::string> texts;
  for (const Case& one : suite.cases) {
    // As a renderer in another process tells it: a zero has no sign there.
    const Outcome told = outcome_of(stored_line(rasterize(one.scene, Policy())), one.scene);
    ASSERT_TRUE(std::holds_alternative<Rendering>(told)) << one.id << text_of(told);
    met.note(std::get<Rendering>(told));
    lines.push_back(stored_line(told));
    texts.push_back(text_of(told));
  }
  const std::vector<std::string> again = unpack_block(pack_block(lines), kLongestBlock);
  ASSERT_EQ(again, lines);
  for (std::size_t i = 0; i < again.size(); ++i)
    EXPECT_EQ(text_of(outcome_of(again[i], suite.cases[i].scene)), texts[i]) << suite.cases[i].id;
  EXPECT_TRUE(met.samples && met.positions && met.depths && met.stencils && met.passes &&
              met.chains && met.details && met.hits);
}

TEST(StoredOutcome, EveryKindOfFailureComesBack) {
  for (const FailureKind kind :
       {FailureKind::unsupported, FailureKind::crashed, FailureKind::timed_out,
        FailureKind::garbage, FailureKind::unavailable}) {
    const Failure failure{kind, "\"why\": 7 # and 8\nand more"};
    const auto lines = unpack_block(pack_block({stored_line(failure)}), kLongestBlock);
    const Outcome again = outcome_of(lines.at(0), Scene());
    EXPECT_EQ(std::get<Failure>(again).kind, kind);
    EXPECT_EQ(std::get<Failure>(again).reason, failure.reason);
  }
}

TEST(StoredOutcome, WhatIsNoAnswerToTheSceneIsAFailure) {
  Scene scene;
  scene.target.width = scene.target.height = 1;
  for (const char* line :
       {"", "{}", R"({"failure":"bored","reason":""})", R"({"failure":"crashed"})",
        R"({"digest":"","pixels":[0,0,0],"fragments":[]})"}) {
    const Outcome outcome = outcome_of(line, scene);
    EXPECT_EQ(std::get<Failure>(outcome).kind, FailureKind::garbage) << line;
    EXPECT_THAT(std::get<Failure>(outcome).reason, HasSubstr("refused"));
  }
}

}  // namespace
}  // namespace edgecase::recording
