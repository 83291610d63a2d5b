// SPDX-License-Identifier: MIT
#include "search/trial.h"

#include <gtest/gtest.h>

#include "tests/search/faulty_renderer.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

Scene line_scene(int size, Point from, Point to) {
  return scene_with(size, {make_draw(Primitive::lines, std::array{from, to})});
}

Scene plain_line(int size = 8) {
  return line_scene(size, sixteenths(8, 8), sixteenths(72, 8));
}

Policy with_rule(const std::string& rule, const std::string& alternative) {
  Policy policy;
  policy.rules[rule] = alternative;
  return policy;
}

TEST(Trial, ShowsNothingOfARendererThatIsRight) {
  FaultyRenderer right(nullptr);
  Trial trial(right, {});
  const TrialAnswer answer = trial.ask(plain_line());
  EXPECT_EQ(answer.result.verdict, Verdict::agree);
  EXPECT_TRUE(answer.signatures.empty());
  EXPECT_EQ(trial.asked(), 1u);
}

TEST(Trial, AnswersABatchInItsOrderAndAsksForItAtOnce) {
  // Wrong for targets of 16 pixels only; the trial may draw them in another order.
  FaultyRenderer faulty(blank_where([](const Scene& scene) { return scene.target.width == 16; }));
  Trial trial(faulty, {});
  const std::vector<Scene> scenes = {plain_line(16), plain_line(8), plain_line(16), plain_line(4)};
  const auto answers = trial.ask(scenes);
  ASSERT_EQ(answers.size(), 4u);
  EXPECT_FALSE(answers[0].signatures.empty());
  EXPECT_TRUE(answers[1].signatures.empty());
  EXPECT_FALSE(answers[2].signatures.empty());
  EXPECT_TRUE(answers[3].signatures.empty());
  EXPECT_EQ(trial.asked(), 4u);
  EXPECT_EQ(faulty.batches, 1u);
}

TEST(Trial, ExactFollowsThePolicy) {
  const Policy policy = with_rule("triangle.fill-rule", "right-bottom");
  const Scene scene = scene_with(
      8, {make_draw(Primitive::triangles,
                    std::array{sixteenths(8, 8), sixteenths(72, 8), sixteenths(8, 72)})});
  FaultyRenderer other(nullptr, policy);
  Trial under_opengl(other, {});
  EXPECT_FALSE(under_opengl.ask(scene).signatures.empty());
  TrialOptions options;
  options.policy = policy;
  Trial under_its_own(other, options);
  EXPECT_TRUE(under_its_own.ask(scene).signatures.empty());
}

TEST(Trial, KeepsWhyThereIsNoRendering) {
  FaultyRenderer crashing(crash_where([](const Scene&) { return true; }));
  Trial trial(crashing, {});
  const TrialAnswer answer = trial.ask(plain_line());
  ASSERT_TRUE(answer.result.failure.has_value());
  EXPECT_EQ(answer.result.failure->reason, "it ended");
  EXPECT_EQ(answer.result.verdict, Verdict::not_run);
  ASSERT_EQ(answer.signatures.size(), 1u);
  EXPECT_EQ(answer.signatures[0].failure, "crashed");
  EXPECT_EQ(trial.asked(), 1u);
}

TEST(Trial, ReadsLinesAsTheRunThatItIsGiven) {
  // Vertices truncated to 1/16: legal where lines are read so, and only there.
  FaultyRenderer snapping(nullptr, with_rule("line.snap", "4-truncate"));
  const Scene scene = line_scene(8, {Fixed::from_raw(4 * Fixed::kOne - 1), sixteenths(8, 8).y},
                                 {Fixed::from_raw(Fixed::kOne / 2 + 1), sixteenths(8, 8).y});
  Trial alone(snapping, {});
  Trial read(snapping, {});
  RunReading reading;
  reading.line_snap = "8-truncate";
  read.read(Surface::window, reading);
  EXPECT_EQ(alone.ask(scene).signatures, read.ask(scene).signatures) << "another surface";
  RunReading nothing_fits;
  // With a name that no line result calls illegal, everything is legal.
  nothing_fits.line_snap = "no such snap";
  read.read(Surface::fbo, nothing_fits);
  for (const Disagreement& d : read.ask(scene).result.disagreements) EXPECT_TRUE(is_legal(d));
}

TEST(Trial, ChoosesCausesAsTheRunThatItIsGiven) {
  FaultyRenderer faulty(nullptr, with_rule("triangle.fill-rule", "right-bottom"));
  const Scene scene = scene_with(
      8, {make_draw(Primitive::triangles,
                    std::array{sixteenths(8, 8), sixteenths(72, 8), sixteenths(8, 72)})});
  Trial trial(faulty, {});
  const TrialAnswer alone = trial.ask(scene);
  ASSERT_FALSE(alone.result.evidence.empty());
  const auto& causes = alone.result.evidence[0].causes;
  ASSERT_GT(causes.size(), 1u);
  const auto chosen = alone.signatures.at(0).cause;
  for (const Cause& other : causes) {
    RunReading reading;
    for (const AlternativeId part : other.parts) reading.alternatives[part] = 1000;
    trial.read(Surface::fbo, reading);
    if (other.size() == 1) {
      EXPECT_EQ(trial.ask(scene).signatures.at(0).cause, text_of(other))
          << "alone it is " << chosen;
    }
  }
}

TEST(Trial, StopsWhenItIsToldTo) {
  std::atomic<bool> stop = false;
  FaultyRenderer stopping([&](const Scene&, Rendering&) {
    stop = true;
    return std::optional<Failure>();
  });
  TrialOptions options;
  options.stop = &stop;
  Trial trial(stopping, options);
  const std::vector<Scene> scenes = {plain_line(), plain_line(), plain_line()};
  EXPECT_THROW(trial.ask(scenes), SearchStopped);
  EXPECT_EQ(stopping.scenes, 1u);
  EXPECT_THROW(trial.ask(plain_line()), SearchStopped);
  EXPECT_EQ(stopping.scenes, 1u) << "asked although it was stopped";
}

}  // namespace
}  // namespace edgecase
