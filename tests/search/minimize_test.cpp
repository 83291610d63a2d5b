// SPDX-License-Identifier: MIT
//
// The whole minimisation, against renderers of which the smallest scene is known.
#include "search/minimize.h"

#include <gtest/gtest.h>

#include "casefile/case_writer.h"
#include "casefile/loader.h"
#include "model/scene.h"
#include "search/scene_size.h"
#include "tests/search/faulty_renderer.h"

namespace edgecase {
namespace {

std::string written(const Scene& scene) {
  CaseWords words;
  words.title = "Minimised";
  words.rules = {"line.diamond-exit"};
  return case_text(scene, words).text;
}

// A scene with much of everything.
Scene rich_scene() {
  const auto at = [](std::int64_t x, std::int64_t y) {
    return Point{Fixed::from_raw(x), Fixed::from_raw(y)};
  };
  Scene scene = scene_with(
      64, {make_draw(Primitive::triangle_strip,
                     std::array{at(300'001, 200'017), at(1'000'003, 250'001), at(340'009, 900'001),
                                at(1'100'001, 1'050'001)}),
           make_draw(Primitive::lines, std::array{at(100'001, 100'003), at(2'000'001, 1'234'567)}),
           make_draw(Primitive::points, std::array{at(77'777, 88'888)})});
  scene.target.depth = DepthFormat::depth24;
  scene.draws[0].interpolation = Interpolation::smooth;
  scene.draws[0].operations.depth.function = CompareFunction::less;
  scene.draws[1].line_width = Fixed::from_integer(3);
  scene.draws[1].scissor = Viewport{1, 1, 60, 60};
  return scene;
}

TEST(Minimize, AFindThatAnySceneShowsComesDownToNothing) {
  FaultyRenderer renderer(crash_where([](const Scene&) { return true; }));
  const Minimized result = minimized(rich_scene(), renderer);
  EXPECT_EQ(result.end, MinimizeEnd::finished);
  SCOPED_TRACE(scene_text(result.scene));
  const SceneSize size = size_of(result.scene);
  EXPECT_EQ(size.primitives, 1);
  EXPECT_EQ(size.draws, 1);
  EXPECT_EQ(size.settings, 0);
  EXPECT_EQ(size.pixels, 1);
  EXPECT_EQ(size.distance, 0);
  EXPECT_EQ(result.fraction_bits, 0);
  EXPECT_TRUE(result.result.failure.has_value());
  EXPECT_EQ(result.asks, renderer.scenes - 1) << "one was asked for the signature";
}

TEST(Minimize, KeepsWhatIsNeeded) {
  // A triangle that is smooth on at least 6 by 9 pixels, an x of at least 5 fraction bits.
  FaultyRenderer renderer(crash_where([](const Scene& scene) {
    return scene.target.width >= 6 && scene.target.height >= 9 &&
           std::ranges::any_of(scene.draws, [](const Draw& draw) {
             return kind_of(draw.primitive) == PrimitiveKind::triangle &&
                    draw.interpolation == Interpolation::smooth &&
                    fraction_bits_of(draw.vertices[0].position.x) >= 5;
           });
  }));
  const Minimized result = minimized(rich_scene(), renderer);
  EXPECT_EQ(result.scene.draws.size(), 1u);
  EXPECT_EQ(result.scene.draws[0].primitive, Primitive::triangles);
  EXPECT_EQ(size_of(result.scene).settings, 1);
  EXPECT_EQ(result.scene.target.width, 6);
  EXPECT_EQ(result.scene.target.height, 9);
  EXPECT_EQ(result.fraction_bits, 5);
}

// What a renderer with another rule draws otherwise: one triangle with one sample on an edge.
TEST(Minimize, AnotherFillRuleComesDownToOneTriangle) {
  Policy other;
  other.rules["triangle.fill-rule"] = "right-bottom";
  FaultyRenderer renderer(nullptr, other);
  const Scene scene = scene_with(
      32, {make_draw(Primitive::triangle_fan,
                     std::array{sixteenths(200, 200), sixteenths(344, 200), sixteenths(344, 344),
                                sixteenths(200, 344), sixteenths(56, 344)})});
  const Minimized result = minimized(scene, renderer);
  const SceneSize size = size_of(result.scene);
  EXPECT_EQ(size.primitives, 1);
  EXPECT_EQ(size.pixels, 1);
  EXPECT_LE(result.fraction_bits, 1);
  EXPECT_EQ(result.result.disagreements.size(), 1u);
}

TEST(Minimize, ASignatureThatChangesStopsAStep) {
  // Pixels are lost of scenes with two lines, and the renderer crashes at scenes with one.
  FaultyRenderer renderer([](const Scene& scene, Rendering& rendering) -> std::optional<Failure> {
    if (primitives_of(scene).size() < 2) return Failure{FailureKind::crashed, "it ended"};
    rendering.fragments.clear();
    rendering.hits.assign(rendering.hits.size(), 0);
    return std::nullopt;
  });
  const Scene scene = scene_with(
      8, {make_draw(Primitive::lines, std::array{sixteenths(8, 8), sixteenths(104, 8)}),
          make_draw(Primitive::lines, std::array{sixteenths(8, 40), sixteenths(104, 40)}),
          make_draw(Primitive::lines, std::array{sixteenths(8, 72), sixteenths(104, 72)})});
  const Minimized result = minimized(scene, renderer);
  EXPECT_EQ(size_of(result.scene).primitives, 2);
  EXPECT_FALSE(result.result.failure.has_value());
}

TEST(Minimize, IsTheSameEachTime) {
  RandomScenes scenes(5);
  Policy other;
  other.rules["triangle.fill-rule"] = "left-bottom";
  other.rules["line.snap"] = "4-half-even";
  int found = 0;
  for (int i = 0; i < 30; ++i) {
    SceneKind kind;
    kind.step = 1024;
    const Scene scene = scenes.next(kind);
    FaultyRenderer renderer(nullptr, other);
    Trial trial(renderer, {});
    const TrialAnswer answer = trial.ask(scene);
    if (answer.signatures.empty()) continue;
    ++found;
    const Minimized one = minimized(scene, renderer, {150});
    const Minimized two = minimized(scene, renderer, {150});
    EXPECT_TRUE(same_scene(one.scene, two.scene));
    EXPECT_EQ(one.asks, two.asks);
    EXPECT_LE(size_of(one.scene), size_of(scene));
    // It shows what it is said to show, and a case file brings it back.
    TrialAnswer again = trial.ask(one.scene);
    EXPECT_NE(std::ranges::find(again.signatures, answer.signatures[0]), again.signatures.end());
    const LoadedCases loaded = load_cases_text(written(one.scene), "x.json", "x");
    ASSERT_EQ(loaded.cases.size(), 1u);
    EXPECT_TRUE(same_scene(loaded.cases[0].scene, one.scene));
  }
  EXPECT_GE(found, 5);
}

TEST(Minimize, OfASceneThatDoesNotShowItIsTheScene) {
  FaultyRenderer renderer(nullptr);
  Trial trial(renderer, {});
  Signature signature;
  signature.surface = "fbo";
  signature.failure = "crashed";
  const Minimized result = minimize(rich_scene(), signature, trial, {});
  EXPECT_EQ(result.end, MinimizeEnd::not_reproduced);
  EXPECT_TRUE(same_scene(result.scene, rich_scene()));
  EXPECT_EQ(result.asks, 1u);
}

TEST(Minimize, AsksNoMoreThanItMay) {
  for (const std::size_t most : {1U, 2U, 7U, 40U}) {
    FaultyRenderer renderer(crash_where([](const Scene&) { return true; }));
    Trial trial(renderer, {});
    const Signature signature = trial.ask(rich_scene()).signatures.at(0);
    const Minimized result = minimize(rich_scene(), signature, trial, {most});
    EXPECT_LE(result.asks, most);
    EXPECT_EQ(renderer.scenes, result.asks + 1);
    EXPECT_LE(size_of(result.scene), size_of(rich_scene()));
    EXPECT_TRUE(result.result.failure.has_value());
    if (most <= 2) {
      EXPECT_EQ(result.end, MinimizeEnd::exhausted);
    }
  }
}

TEST(Minimize, KeepsTheBestWhereItIsStopped) {
  std::atomic<bool> stop = false;
  std::size_t left = 30;
  FaultyRenderer renderer([&](const Scene&, Rendering&) {
    if (--left == 0) stop = true;
    return std::optional(Failure{FailureKind::crashed, "it ended"});
  });
  TrialOptions options;
  options.stop = &stop;
  Trial trial(renderer, options);
  const Signature signature = trial.ask(rich_scene()).signatures.at(0);
  const Minimized result = minimize(rich_scene(), signature, trial, {});
  EXPECT_EQ(result.end, MinimizeEnd::stopped);
  EXPECT_LT(size_of(result.scene), size_of(rich_scene()));
  EXPECT_EQ(renderer.scenes, 30u);
}

TEST(Minimize, NeverLeavesWhatCaseFilesCanSay) {
  FaultyRenderer renderer([](const Scene& scene, Rendering&) -> std::optional<Failure> {
    EXPECT_FALSE(written(scene).empty());
    return Failure{FailureKind::crashed, "it ended"};
  });
  minimized(rich_scene(), renderer);
}

TEST(Minimize, OfWhatNoCaseFileCanSayIsStillSmaller) {
  Scene scene = rich_scene();
  scene.target.clear = {2, 0, 0, 1};
  ASSERT_TRUE(written(scene).empty());
  FaultyRenderer renderer(
      crash_where([](const Scene& drawn) { return drawn.target.clear[0] == 2; }));
  const Minimized result = minimized(scene, renderer);
  EXPECT_EQ(size_of(result.scene).primitives, 1);
  EXPECT_EQ(result.fraction_bits, 0);
}

TEST(Minimize, AsksNoSceneTwice) {
  std::set<std::string> asked;
  FaultyRenderer renderer([&](const Scene& scene, Rendering&) -> std::optional<Failure> {
    EXPECT_TRUE(asked.insert(written(scene)).second);
    // Something that makes it go back and forth: an odd number of pixels, at least 3 bits.
    if (scene.target.width % 2 == 0 && scene.target.width != 64) return std::nullopt;
    if (fraction_bits_of(scene) < 3) return std::nullopt;
    return Failure{FailureKind::crashed, "it ended"};
  });
  Trial trial(renderer, {});
  Signature signature;
  signature.surface = "fbo";
  signature.failure = "crashed";
  const Minimized result = minimize(rich_scene(), signature, trial, {});
  EXPECT_EQ(result.fraction_bits, 3);
  EXPECT_EQ(result.scene.target.width, 1);
}

}  // namespace
}  // namespace edgecase
