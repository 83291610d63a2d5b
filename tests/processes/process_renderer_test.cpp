// SPDX-License-Identifier: MIT
//
// ProcessRenderer against programs that misbehave in every way we could think of. Each is a few
// lines of Python or shell, written to a folder of its own that goes away with the test.
#include "processes/process_renderer.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>

#include "tests/processes/test_programs.h"

namespace edgecase {
namespace {

using std::chrono::milliseconds;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(ProcessRendererTest, RendersAndLearnsWhoAnswers) {
  ProcessRenderer renderer(
      python("for r in requests(): answer(r, renderer={'device': 'toy', 'traits': {'a': 'b'}})"));
  EXPECT_EQ(renderer.info().name, "exec:test");
  EXPECT_EQ(renderer.info().device, "");
  const auto outcomes = render(renderer, {scene_of(2, 1), scene_of(3, 3), scene_of(1, 1)});
  for (const Outcome& outcome : outcomes) ASSERT_TRUE(is_rendering(outcome)) << reason_of(outcome);
  EXPECT_EQ(std::get<Rendering>(outcomes[0]).pixels,
            (std::vector<std::uint8_t>{0, 0, 255, 255, 0, 0, 255, 255}));
  EXPECT_EQ(renderer.info().name, "exec:test");
  EXPECT_EQ(renderer.info().device, "toy");
  EXPECT_EQ(renderer.info().subpixel_bits, 4);
  EXPECT_EQ(renderer.info().traits.at("a"), "b");
}

TEST_F(ProcessRendererTest, SetsAndUnsetsTheEnvironment) {
  setenv("EDGECASE_TEST_OLD", "old", 1);
  setenv("EDGECASE_TEST_GONE", "gone", 1);
  ProcessSpec spec = python(
      "for r in requests(): answer(r, renderer={'device': ' '.join(os.environ.get("
      "'EDGECASE_TEST_' + n, '-') for n in ('OLD', 'GONE', 'NEW'))})");
  spec.command.environment = {{"EDGECASE_TEST_NEW", "new"}, {"EDGECASE_TEST_OLD", "changed"}};
  spec.command.unset = {"EDGECASE_TEST_GONE"};
  ProcessRenderer renderer(spec);
  render(renderer, {scene_of(1, 1)});
  EXPECT_EQ(renderer.info().device, "changed - new");
}

TEST_F(ProcessRendererTest, AsksForCoverageAloneWhereThatIsEnough) {
  // Answers in the form that was asked for; a whole answer says that nothing was.
  ProcessRenderer renderer(python(R"(
for r in requests():
    if r.get("answer") == "coverage":
        print(json.dumps({"digest": r["digest"], "coverage": [0, 1, 2, 3]}), flush=True)
    else:
        answer(r)
)"));
  Scene scene = scene_of(4, 2);
  scene.draws.emplace_back().vertices.resize(3);
  const Task tasks[] = {{"a", &scene, true}, {"b", &scene}};
  std::vector<Outcome> outcomes;
  renderer.render(tasks, [&](std::size_t, Outcome got) { outcomes.push_back(std::move(got)); });
  ASSERT_EQ(outcomes.size(), 2u);
  for (const Outcome& outcome : outcomes) ASSERT_TRUE(is_rendering(outcome)) << reason_of(outcome);
  const Rendering& coverage = std::get<Rendering>(outcomes[0]);
  EXPECT_TRUE(coverage.pixels.empty());
  ASSERT_EQ(coverage.fragments.size(), 2u);
  EXPECT_EQ(coverage.fragments[1].x, 3);
  EXPECT_EQ(coverage.fragments[1].y, 1);
  EXPECT_EQ(std::get<Rendering>(outcomes[1]).pixels.size(), 32u);
}

TEST_F(ProcessRendererTest, AsksForWholeAnswersOfSeveralSamples) {
  ProcessRenderer renderer(
      python("for r in requests(): answer(r, renderer={'device': str(r.get('answer'))})"));
  Scene scene = scene_of(4, 2);
  scene.target.samples = 4;
  const Task tasks[] = {{"a", &scene, true}};
  renderer.render(tasks, [&](std::size_t, const Outcome& outcome) {
    EXPECT_TRUE(is_rendering(outcome)) << reason_of(outcome);
  });
  EXPECT_EQ(renderer.info().device, "None");
}

TEST_F(ProcessRendererTest, CoverageThatNobodyAskedForIsGarbage) {
  ProcessRenderer renderer(
      python("for r in requests(): print(json.dumps({'digest': r['digest'], 'coverage': []}), "
             "flush=True)"));
  const auto outcomes = render(renderer, {scene_of(1, 1)});
  EXPECT_EQ(kind_of(outcomes[0]), "garbage");
}

TEST_F(ProcessRendererTest, PassesARefusalOn) {
  ProcessRenderer renderer(
      python("for r in requests(): print(json.dumps({'digest': r['digest'], 'not_run': 'tired'}), "
             "flush=True)"));
  const auto outcomes = render(renderer, {scene_of(1, 1)});
  EXPECT_EQ(kind_of(outcomes[0]), "unsupported");
  EXPECT_EQ(reason_of(outcomes[0]), "tired");
}

TEST_F(ProcessRendererTest, ADeathCostsOneScene) {
  ProcessRenderer renderer(python(R"(
for r in requests():
    if r["scene"]["target"]["width"] == 3:
        print("about to fall", file=sys.stderr, flush=True)
        os.kill(os.getpid(), signal.SIGSEGV)
    if r["scene"]["target"]["width"] == 4:
        sys.exit(7)
    answer(r)
)"));
  const auto outcomes = render(
      renderer, {scene_of(1, 1), scene_of(2, 1), scene_of(3, 1), scene_of(4, 1), scene_of(5, 1),
                 scene_of(4, 1), scene_of(4, 1), scene_of(4, 1), scene_of(4, 1), scene_of(6, 1)});
  for (std::size_t i : {0u, 1u, 4u, 9u}) EXPECT_TRUE(is_rendering(outcomes[i])) << i;
  EXPECT_EQ(kind_of(outcomes[2]), "crashed");
  EXPECT_THAT(reason_of(outcomes[2]), HasSubstr("signal 11"));
  EXPECT_THAT(reason_of(outcomes[2]), HasSubstr("about to fall"));
  for (std::size_t i : {3u, 5u, 6u, 7u, 8u}) {
    EXPECT_EQ(kind_of(outcomes[i]), "crashed") << i;
    EXPECT_THAT(reason_of(outcomes[i]), HasSubstr("exit status 7"));
  }
}

TEST_F(ProcessRendererTest, QuotesLastWordsAsText) {
  // The cut falls into a character.
  ProcessRenderer renderer(python(R"(
os.write(2, "\u00e4".encode() * 400 + b"\xff\x1b!\n")
sys.exit(1)
)"));
  const std::string reason = reason_of(render(renderer, {scene_of(1, 1)})[0]);
  EXPECT_THAT(reason, HasSubstr("it said: ...?\u00e4\u00e4"));
  EXPECT_THAT(reason, EndsWith("\u00e4? !"));
}

TEST_F(ProcessRendererTest, QuotesLittleOfAnAnswerThatIsRefused) {
  ProcessRenderer renderer(
      python("for r in requests(): answer(r, renderer={'traits': {'\\x1b' * 100000: 1}})"));
  const auto outcomes = render(renderer, {scene_of(1, 1)});
  EXPECT_EQ(kind_of(outcomes[0]), "garbage");
  EXPECT_THAT(reason_of(outcomes[0]), HasSubstr("/renderer/traits/???"));
  EXPECT_LT(reason_of(outcomes[0]).size(), 1100u);
}

TEST_F(ProcessRendererTest, AMissingProgramIsUnavailable) {
  ProcessSpec spec;
  spec.name = "exec:test";
  spec.command.argv = {"/nonexistent/program"};
  ProcessRenderer renderer(spec);
  const auto outcomes = render(renderer, std::vector<Scene>(2, scene_of(1, 1)));
  for (const Outcome& outcome : outcomes) {
    EXPECT_EQ(kind_of(outcome), "unavailable");
    EXPECT_THAT(reason_of(outcome), HasSubstr("No such file or directory"));
  }
}

TEST_F(ProcessRendererTest, AFileThatIsNoProgramIsUnavailable) {
  ProcessSpec spec;
  spec.command.argv = {write("data", "no program")};
  ProcessRenderer renderer(spec);
  EXPECT_THAT(reason_of(render(renderer, {scene_of(1, 1)})[0]), HasSubstr("Permission denied"));
}

TEST_F(ProcessRendererTest, GivesUpOnAProgramThatNeverAnswers) {
  ProcessRenderer renderer(shell(count_start() + "echo no licence >&2; exit 1"));
  const auto outcomes = render(renderer, std::vector<Scene>(100, scene_of(1, 1)));
  EXPECT_EQ(kind_of(outcomes[0]), "crashed");
  EXPECT_THAT(reason_of(outcomes[0]), HasSubstr("exit status 1"));
  EXPECT_THAT(reason_of(outcomes[0]), HasSubstr("no licence"));
  for (std::size_t i = 2; i < 100; ++i) EXPECT_EQ(kind_of(outcomes[i]), "unavailable") << i;
  EXPECT_THAT(reason_of(outcomes[99]), HasSubstr("no licence"));
  EXPECT_LE(starts(), 4u);
}

TEST_F(ProcessRendererTest, DoesNotGiveUpWhereOnlyTheFirstScenesKill) {
  ProcessRenderer renderer(
      python("for r in requests():\n"
             "    if r['scene']['target']['width'] == 9: sys.exit(1)\n"
             "    answer(r)"));
  std::vector<Scene> scenes(5, scene_of(9, 1));
  scenes.push_back(scene_of(2, 2));
  const auto outcomes = render(renderer, scenes);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(kind_of(outcomes[i]), "crashed") << i;
  EXPECT_TRUE(is_rendering(outcomes[5]));
}

TEST_F(ProcessRendererTest, ExitStatusThreeSaysUnavailableAtOnce) {
  ProcessRenderer renderer(shell(count_start() + "echo no such driver >&2; exit 3"));
  const auto outcomes = render(renderer, std::vector<Scene>(10, scene_of(1, 1)));
  for (const Outcome& outcome : outcomes) {
    EXPECT_EQ(kind_of(outcome), "unavailable");
    EXPECT_THAT(reason_of(outcome), HasSubstr("no such driver"));
  }
  EXPECT_EQ(starts(), 1u);
}

TEST_F(ProcessRendererTest, PrintingNothingIsADeath) {
  ProcessRenderer renderer(shell("exit 0"));
  const auto outcomes = render(renderer, {scene_of(1, 1)});
  EXPECT_EQ(kind_of(outcomes[0]), "crashed");
  EXPECT_THAT(reason_of(outcomes[0]), HasSubstr("exit status 0 before its first answer"));
}

TEST_F(ProcessRendererTest, AHangCostsItsTimeoutAndOneScene) {
  ProcessSpec spec = python(
      "for r in requests():\n"
      "    if r['scene']['target']['width'] == 2: time.sleep(100)\n"
      "    answer(r)");
  spec.timeout = milliseconds(400);
  ProcessRenderer renderer(spec);
  const auto start = std::chrono::steady_clock::now();
  const auto outcomes = render(renderer, {scene_of(1, 1), scene_of(2, 1), scene_of(3, 1)});
  EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(8000));
  EXPECT_TRUE(is_rendering(outcomes[0]));
  EXPECT_EQ(kind_of(outcomes[1]), "timed-out");
  EXPECT_THAT(reason_of(outcomes[1]), HasSubstr("400 ms"));
  EXPECT_TRUE(is_rendering(outcomes[2]));
}

TEST_F(ProcessRendererTest, AHungProgramTakesItsChildrenWithIt) {
  ProcessSpec spec = shell("sleep 1000 & echo $! > " + (folder_ / "pid").string() + "; wait");
  spec.timeout = milliseconds(300);
  spec.startup_timeout = milliseconds(0);
  ProcessRenderer renderer(spec);
  EXPECT_EQ(kind_of(render(renderer, {scene_of(1, 1)})[0]), "timed-out");
  pid_t grandchild = 0;
  std::ifstream(folder_ / "pid") >> grandchild;
  ASSERT_GT(grandchild, 0);
  // Whoever adopts it may take a moment to reap it; a zombie is as good as gone.
  const auto is_alive = [&] {
    std::string word, state;
    std::ifstream stat("/proc/" + std::to_string(grandchild) + "/stat");
    stat >> word >> word >> state;
    return !state.empty() && state != "Z";
  };
  for (int i = 0; i < 100 && is_alive(); ++i) usleep(10'000);
  EXPECT_FALSE(is_alive());
}

TEST_F(ProcessRendererTest, ADeadProgramIsNoticedAlthoughItsChildHoldsThePipes) {
  ProcessSpec spec = shell("sleep 1000 & exit 5");
  ProcessRenderer renderer(spec);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(reason_of(render(renderer, {scene_of(1, 1)})[0]), HasSubstr("exit status 5"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(3000));
}

TEST_F(ProcessRendererTest, ABigSceneToAProgramThatDoesNotRead) {
  ProcessSpec spec = shell("sleep 1000");
  spec.timeout = milliseconds(300);
  spec.startup_timeout = milliseconds(200);
  ProcessRenderer renderer(spec);
  const auto outcomes = render(renderer, {big_scene()});
  EXPECT_EQ(kind_of(outcomes[0]), "timed-out");
  EXPECT_THAT(reason_of(outcomes[0]), HasSubstr("500 ms"));
}

TEST_F(ProcessRendererTest, ABigSceneToAProgramThatDies) {
  ProcessRenderer renderer(shell("read -r x; exit 9"));
  ProcessRenderer closed(shell("exec <&-; exit 9"));
  EXPECT_THAT(reason_of(render(renderer, {big_scene()})[0]), HasSubstr("exit status 9"));
  EXPECT_THAT(reason_of(render(closed, {big_scene()})[0]), HasSubstr("exit status 9"));
}

TEST_F(ProcessRendererTest, ABigSceneAndAHugeAnswerArrive) {
  ProcessRenderer renderer(python("for r in requests(): answer(r)"));
  const auto outcomes = render(renderer, {big_scene(), scene_of(1024, 1024)});
  EXPECT_TRUE(is_rendering(outcomes[0])) << reason_of(outcomes[0]);
  ASSERT_TRUE(is_rendering(outcomes[1])) << reason_of(outcomes[1]);
  EXPECT_EQ(std::get<Rendering>(outcomes[1]).pixels.size(), 4u << 20);
}

TEST_F(ProcessRendererTest, AnEndlessAnswerIsCutOff) {
  ProcessSpec spec = shell("tr '\\0' x < /dev/zero");
  ProcessRenderer renderer(spec);
  const auto outcomes = render(renderer, {scene_of(1, 1)});
  EXPECT_EQ(kind_of(outcomes[0]), "garbage");
  EXPECT_THAT(reason_of(outcomes[0]), HasSubstr("without a line break"));
}

TEST_F(ProcessRendererTest, GarbageCostsOneScene) {
  ProcessRenderer renderer(python(R"(
for r in requests():
    if r["scene"]["target"]["width"] == 2: print("what?\nhow?", flush=True)
    else: answer(r)
)"));
  const auto outcomes = render(renderer, {scene_of(1, 1), scene_of(2, 1), scene_of(3, 1)});
  EXPECT_TRUE(is_rendering(outcomes[0]));
  EXPECT_EQ(kind_of(outcomes[1]), "garbage");
  EXPECT_THAT(reason_of(outcomes[1]), HasSubstr("no line of JSON"));
  EXPECT_TRUE(is_rendering(outcomes[2])) << reason_of(outcomes[2]);
}

TEST_F(ProcessRendererTest, AnEchoOfAnotherSceneIsGarbage) {
  ProcessRenderer renderer(python(R"(
first = None
for r in requests():
    first = first or r
    answer(first)
)"));
  Scene other = scene_of(1, 1);
  other.target.clear = {1, 0, 0, 1};
  const auto outcomes = render(renderer, {scene_of(1, 1), other});
  EXPECT_TRUE(is_rendering(outcomes[0]));
  EXPECT_EQ(kind_of(outcomes[1]), "garbage");
  EXPECT_THAT(reason_of(outcomes[1]), HasSubstr("an answer to another scene"));
}

TEST_F(ProcessRendererTest, ContradictingHitCountsAreGarbage) {
  ProcessRenderer renderer(python("for r in requests(): answer(r, hits=[0, 1])"));
  const auto outcomes = render(renderer, {scene_of(2, 1)});
  EXPECT_EQ(kind_of(outcomes[0]), "garbage");
  EXPECT_THAT(reason_of(outcomes[0]), HasSubstr("pixel (1, 0): 1 against 0"));
}

TEST_F(ProcessRendererTest, AFloodOfErrorOutputBlocksNobodyAndIsQuotedByItsEnd) {
  ProcessRenderer renderer(python(R"(
for r in requests():
    for i in range(20000): print("complaint", i, "x" * 80, file=sys.stderr)
    print("the end", file=sys.stderr, flush=True)
    if r["scene"]["target"]["width"] == 2: sys.exit(1)
    answer(r)
)"));
  const auto outcomes = render(renderer, {scene_of(1, 1), scene_of(2, 1)});
  EXPECT_TRUE(is_rendering(outcomes[0])) << reason_of(outcomes[0]);
  EXPECT_THAT(reason_of(outcomes[1]), HasSubstr("the end"));
  EXPECT_LT(reason_of(outcomes[1]).size(), 500u);
}

TEST_F(ProcessRendererTest, LeavesNoDescriptorsAndNoPendingSignal) {
  const std::size_t before = open_descriptors();
  for (int i = 0; i < 5; ++i) {
    ProcessRenderer renderer(shell("exit 9"));
    render(renderer, {big_scene(), scene_of(1, 1)});
  }
  EXPECT_EQ(open_descriptors(), before);
  sigset_t pending;
  sigpending(&pending);
  EXPECT_FALSE(sigismember(&pending, SIGPIPE));
}

TEST_F(ProcessRendererTest, AnExceptionOfTheSinkPassesAndNothingIsLost) {
  ProcessRenderer renderer(python("for r in requests(): answer(r)"));
  const Scene scene = scene_of(1, 1);
  const std::vector<Task> tasks(3, Task{"test", &scene});
  EXPECT_THROW(renderer.render(tasks, [](std::size_t, Outcome) { throw 1; }), int);
  EXPECT_TRUE(is_rendering(render(renderer, {scene_of(2, 2)})[0]));
}

TEST_F(ProcessRendererTest, RunsInAGroupOfItsOwn) {
  ProcessRenderer renderer(
      python("for r in requests(): answer(r, renderer={'device': str(os.getpgrp())})"));
  render(renderer, {scene_of(1, 1)});
  EXPECT_NE(renderer.info().device, std::to_string(getpgrp()));
  EXPECT_THAT(renderer.info().device, Not(HasSubstr("-")));
}

TEST_F(ProcessRendererTest, TheFirstAnswerHasMoreTime) {
  EXPECT_EQ(startup_patience(milliseconds(10)), milliseconds(5'000));
  EXPECT_EQ(startup_patience(milliseconds(2'000)), milliseconds(8'000));
  EXPECT_EQ(startup_patience(milliseconds(10'000)), milliseconds(30'000));
  EXPECT_EQ(startup_patience(milliseconds(3'600'000)), milliseconds(30'000));
}

TEST_F(ProcessRendererTest, TheExampleInTheRepositoryDraws) {
  ProcessSpec spec;
  spec.name = "exec:example";
  spec.command.argv = {EDGECASE_PYTHON, EDGECASE_ROOT "/reference/examples/rasterizer.py"};
  ProcessRenderer renderer(spec);
  Scene scene = scene_of(6, 1);
  Draw line;
  line.primitive = Primitive::lines;
  line.vertices.resize(2);
  line.vertices[0].position = pixel_centre(1, 0);
  line.vertices[1].position = pixel_centre(4, 0);
  scene.draws = {line};
  const auto outcomes = render(renderer, {scene});
  ASSERT_TRUE(is_rendering(outcomes[0])) << reason_of(outcomes[0]);
  std::string row(6, '.');
  for (const Fragment& fragment : std::get<Rendering>(outcomes[0]).fragments)
    row[static_cast<std::size_t>(fragment.x)] = '#';
  EXPECT_EQ(row, ".###..");
}

}  // namespace
}  // namespace edgecase
