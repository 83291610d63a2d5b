// SPDX-License-Identifier: MIT
//
// The search against renderers with planted faults: each is found, made small and told once, the
// same for any number of threads, and the search ends when it should.
#include "search/fuzz.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "casefile/loader.h"
#include "search/find.h"
#include "search/find_file.h"
#include "search/fuzz_json.h"
#include "search/scene_size.h"
#include "search/trial.h"
#include "tests/support/altered_renderer.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// The specification's own rendering, but for a fault.
FuzzRenderer altered(Alter alter, Policy policy = {}) {
  FuzzRenderer renderer;
  renderer.name = "altered";
  renderer.make = [alter = std::move(alter), policy = std::move(policy)] {
    return std::make_unique<AlteredRenderer>(policy, alter);
  };
  return renderer;
}

FuzzOptions few(const std::vector<const char*>& families, std::size_t count) {
  FuzzOptions options;
  for (const char* name : families) options.families.push_back(find_family(name));
  options.surfaces = {Surface::fbo};
  options.count = count;
  options.minimize.max_asks = 40;
  return options;
}

void drop_if(Rendering& rendering, auto&& is_lost) {
  std::erase_if(rendering.fragments, is_lost);
}

// The last fragment of the first line of three pixels or more.
void lose_last_of_a_line(const Task& task, Rendering& rendering) {
  if (kind_of(task.scene->draws[0].primitive) != PrimitiveKind::line) return;
  std::vector<std::size_t> of_first;
  for (std::size_t i = 0; i < rendering.fragments.size(); ++i)
    if (rendering.fragments[i].primitive == 0) of_first.push_back(i);
  if (of_first.size() < 5) return;
  rendering.fragments.erase(rendering.fragments.begin() +
                            static_cast<std::ptrdiff_t>(of_first.back()));
  rendering.fragments.erase(rendering.fragments.begin() +
                            static_cast<std::ptrdiff_t>(of_first.front()));
}

// Of two triangles on a small target the first has no fragments in pixels where x is y.
void tear_diagonal(const Task& task, Rendering& rendering) {
  if (task.scene->target.width > 16 || primitives_of(*task.scene).size() != 2) return;
  if (kind_of(task.scene->draws[0].primitive) != PrimitiveKind::triangle) return;
  drop_if(rendering, [](const Fragment& f) { return f.primitive == 0 && f.x == f.y && f.x > 2; });
}

TEST(Fuzz, FindsNothingWhereNothingDiffers) {
  const FuzzReport report = fuzz(
      {altered(nullptr)},
      few({"points", "lines", "joints", "shared-edges", "triangles", "fans", "snapping"}, 900));
  EXPECT_EQ(report.scenes, 900u);
  EXPECT_TRUE(report.finds.empty());
  EXPECT_EQ(report.renderers[0].drawn, 900u);
}

TEST(Fuzz, FindsAPlantedFaultOfLinesAndMakesItSmall) {
  FuzzOptions options = few({"lines"}, 128);
  options.finds = 1;
  options.least = Verdict::violation;
  options.minimize.max_asks = 400;
  const FuzzReport report = fuzz({altered(lose_last_of_a_line)}, options);
  ASSERT_FALSE(report.finds.empty());
  const Find& find = report.finds.front();
  EXPECT_EQ(find.verdict, Verdict::violation);
  EXPECT_EQ(primitives_of(find.scene).size(), 1u);
  const Scene first =
      find_family(find.origin.family)->scene(1, find.origin.surface, find.origin.index);
  EXPECT_LT(size_of(find.scene), size_of(first));
  EXPECT_GT(find.asks, 1u);
  EXPECT_THAT(rule_of(find), StartsWith("line."));
  ASSERT_EQ(find.answers.size(), 1u);
  EXPECT_THAT(find.answers[0].words, StartsWith("violation, "));
  EXPECT_THAT(find.answers[0].words, HasSubstr("missing ("));
}

TEST(Fuzz, FindsATearInASharedEdge) {
  const FuzzReport report = fuzz({altered(tear_diagonal)}, few({"shared-edges"}, 160));
  ASSERT_FALSE(report.finds.empty());
  EXPECT_EQ(report.finds.front().verdict, Verdict::violation);
  EXPECT_THAT(report.finds.front().key.geometry, "triangle");
}

TEST(Fuzz, FindsEdgeFunctionsInSinglePrecisionAndNamesThem) {
  Policy policy;
  policy.rules["triangle.algorithm"] = "float-edges";
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    FuzzOptions options = few({"seams"}, 80);
    options.seed = seed;
    options.least = Verdict::violation;
    const FuzzReport report = fuzz({altered(nullptr, policy)}, options);
    ASSERT_FALSE(report.finds.empty()) << seed;
    const Find& find = report.finds.front();
    EXPECT_EQ(find.verdict, Verdict::violation);
    EXPECT_EQ(find.key.signature.rule, "triangle.shared-edge");
    EXPECT_EQ(find.key.signature.cause, "triangle.algorithm=float-edges");
  }
}

TEST(Fuzz, NamesTheCauseThatTheWholeRunSpeaksFor) {
  Policy policy;
  policy.rules["triangle.fill-rule"] = "right-top";
  const FuzzReport report = fuzz({altered(nullptr, policy)}, few({"triangles"}, 400));
  ASSERT_EQ(report.finds.size(), 1u);
  EXPECT_EQ(report.finds[0].verdict, Verdict::convention);
  EXPECT_EQ(report.finds[0].key.signature.cause, "triangle.fill-rule=right-top");
  EXPECT_GT(report.finds[0].scenes, 20u);
  // Held against what it follows, it does nothing unforeseen.
  FuzzRenderer own = altered(nullptr, policy);
  own.policy = policy;
  EXPECT_TRUE(fuzz({own}, few({"triangles"}, 400)).finds.empty());
  // And a convention is no find where only violations are asked for.
  FuzzOptions violations = few({"triangles"}, 400);
  violations.least = Verdict::violation;
  EXPECT_TRUE(fuzz({altered(nullptr, policy)}, violations).finds.empty());
}

TEST(Fuzz, FindsRenderersThatFail) {
  class Crashing final : public Renderer {
   public:
    const RendererInfo& info() const override {
      static const RendererInfo info{"crashing", "", "", "", 4, {}};
      return info;
    }
    void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
      for (std::size_t i = 0; i < tasks.size(); ++i)
        if (tasks[i].scene->target.width == 8)
          sink(i, Failure{FailureKind::crashed, "it died"});
        else
          sink(i, rasterize(*tasks[i].scene, {}));
    }
  };
  FuzzRenderer renderer;
  renderer.name = "crashing";
  renderer.make = [] { return std::make_unique<Crashing>(); };
  const FuzzReport report = fuzz({renderer}, few({"points"}, 300));
  ASSERT_EQ(report.finds.size(), 1u);
  EXPECT_EQ(report.finds[0].verdict, Verdict::not_run);
  EXPECT_EQ(report.finds[0].scene.target.width, 8);
}

FuzzWords words_of_test() {
  return {"edgecase", "opengl", 1, {"altered"}, {}};
}

TEST(Fuzz, IsTheSameForAnyNumberOfThreads) {
  FuzzOptions options = few({"shared-edges"}, 1'300);
  options.minimize.max_asks = 10;
  const std::string one = fuzz_json(fuzz({altered(tear_diagonal)}, options), words_of_test());
  options.jobs = 3;
  EXPECT_EQ(fuzz_json(fuzz({altered(tear_diagonal)}, options), words_of_test()), one);
  EXPECT_THAT(one, HasSubstr("\"mutated\""));
  options.seed = 2;
  EXPECT_NE(fuzz_json(fuzz({altered(tear_diagonal)}, options), words_of_test()), one);
}

TEST(Fuzz, TellsOfRenderersWhoseNamesAreNoText) {
  FuzzRenderer renderer = altered(tear_diagonal);
  renderer.name = "exec:\xff\x1b" + std::string(300, 'x');
  const FuzzReport report = fuzz({renderer}, few({"shared-edges"}, 160));
  ASSERT_FALSE(report.finds.empty());
  FuzzWords words = words_of_test();
  words.renderers = {renderer.name};
  EXPECT_THAT(fuzz_json(report, words), HasSubstr("\"name\": \"exec:\uFFFD\\u001bxxx"));
  const FindFile file = find_file(report.finds.front(), 1, "");
  ASSERT_TRUE(file.diagnostics.empty()) << to_string(file.diagnostics.front());
  EXPECT_THAT(file.text, HasSubstr("\"title\": \"exec:\?\?xxx"));
}

TEST(Fuzz, TellsEachFindOnce) {
  const FuzzReport report =
      fuzz({altered(lose_last_of_a_line)},
           few({"lines", "joints"}, share_of(std::size_t{96}, std::size_t{32})));
  for (std::size_t i = 0; i < report.finds.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(report.finds[i].key, report.finds[j].key);
}

TEST(Fuzz, StopsAtFindsCountTimeAndWhenAsked) {
  FuzzOptions options = few({"lines", "joints"}, 1'000'000'000);
  options.finds = 2;
  options.minimize.max_asks = 20;
  EXPECT_EQ(fuzz({altered(lose_last_of_a_line)}, options).finds.size(), 2u);
  options.finds.reset();
  options.time = std::chrono::milliseconds(300);
  EXPECT_LT(fuzz({altered(nullptr)}, options).scenes, 1'000'000u);
  options.time.reset();
  std::atomic<bool> stop{false};
  options.stop = &stop;
  options.progress = [&](const FuzzProgress& progress) { stop = progress.scenes > 500; };
  const FuzzReport stopped = fuzz({altered(lose_last_of_a_line)}, options);
  EXPECT_TRUE(stopped.stopped);
  EXPECT_GT(stopped.scenes, 400u);
  EXPECT_FALSE(stopped.finds.empty());  // kept, though not made smaller
}

std::chrono::duration<double> time_of_search(const FuzzRenderer& renderer,
                                             const FuzzOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(fuzz({renderer}, options).finds.empty());
  return std::chrono::steady_clock::now() - start;
}

TEST(Fuzz, SearchesTheWholeTimeWhereNothingIsFound) {
  FuzzOptions options = few({"points"}, 1'000'000'000);
  options.time = std::chrono::milliseconds(600);
  EXPECT_GE(time_of_search(altered(nullptr), options), *options.time);
}

// A convention is a suspect, but no find where only violations are asked for.
TEST(Fuzz, SearchesTheWholeTimeWhereNoSuspectIsAFind) {
  Policy policy;
  policy.rules["triangle.fill-rule"] = "right-top";
  FuzzOptions options = few({"triangles"}, 1'000'000'000);
  options.least = Verdict::violation;
  options.time = std::chrono::milliseconds(600);
  EXPECT_GE(time_of_search(altered(nullptr, policy), options), *options.time);
}

TEST(Fuzz, CountsWhatIsKnownAndNoMore) {
  FuzzOptions options = few({"lines"}, share_of(std::size_t{128}, std::size_t{48}));
  const FuzzReport report = fuzz({altered(lose_last_of_a_line)}, options);
  ASSERT_FALSE(report.finds.empty());
  // By an earlier search's JSON.
  const auto known = read_known_finds(fuzz_json(report, words_of_test()));
  ASSERT_TRUE(std::holds_alternative<KnownKeys>(known));
  options.known.keys = std::get<KnownKeys>(known);
  const FuzzReport again = fuzz({altered(lose_last_of_a_line)}, options);
  EXPECT_TRUE(again.finds.empty());
  EXPECT_GE(again.renderers[0].known, report.finds.size());
  // By the scenes that were saved.
  options.known.keys.clear();
  for (const Find& find : report.finds) options.known.scenes.push_back(find.scene);
  EXPECT_TRUE(fuzz({altered(lose_last_of_a_line)}, options).finds.empty());
  EXPECT_TRUE(std::holds_alternative<std::string>(read_known_finds("{\"finds\": [3]}")));
}

// Kind, x and y of all that differs.
std::set<std::tuple<DisagreementKind, int, int>> places_of(const Result& result) {
  std::set<std::tuple<DisagreementKind, int, int>> places;
  for (const Disagreement& d : result.disagreements) places.emplace(d.kind, d.x, d.y);
  return places;
}

TEST(Fuzz, SavesFindsThatShowTheSameWhenTheyAreLoaded) {
  const FuzzRenderer renderer = altered(tear_diagonal);
  const FuzzReport report = fuzz({renderer}, few({"shared-edges"}, 160));
  ASSERT_FALSE(report.finds.empty());
  for (const Find& find : report.finds) {
    const FindFile file = find_file(find, 1, "../case.schema.json");
    ASSERT_TRUE(file.diagnostics.empty());
    EXPECT_THAT(file.name, StartsWith(rule_of(find) + "-"));
    EXPECT_EQ(file.text, find_file(find, 1, "../case.schema.json").text);
    const LoadedCases loaded = load_cases_text(file.text, file.name, "find");
    ASSERT_EQ(loaded.cases.size(), 1u);
    const Case& one = loaded.cases.front();
    EXPECT_EQ(one.rules, std::vector<std::string>{rule_of(find)});
    EXPECT_THAT(one.why, HasSubstr("altered: violation, "));
    EXPECT_THAT(one.why, HasSubstr("Found by edgecase fuzz: shared-edges, seed 1, index "));
    EXPECT_THAT(one.tags, ::testing::ElementsAre("fuzz", "shared-edges"));
    const auto made = renderer.make();
    Trial trial(*made, {});
    // Which cause is named depends on what a run is read as; what differs where does not.
    EXPECT_EQ(places_of(trial.ask(one.scene).result), places_of(find.result));
    EXPECT_FALSE(places_of(find.result).empty());
  }
}

}  // namespace
}  // namespace edgecase
