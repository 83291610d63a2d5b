// SPDX-License-Identifier: MIT
//
// ProcessRenderer against workers that speak in bytes, and are asked for scenes before they have
// answered others: what one does wrong costs the scene at hand, and no other.
#include <gmock/gmock.h>

#include "tests/processes/test_programs.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

// Refuses each scene, in words that are the scene's id; "die", "sleep", "lie", "babble" and "cut"
// it does.
constexpr const char* kWorker = R"(
import struct
def read(count):
    data = sys.stdin.buffer.read(count)
    if len(data) < count: sys.exit(0)
    return data
def write(data):
    sys.stdout.buffer.write(struct.pack("=Q", len(data)) + data)
    sys.stdout.buffer.flush()
def refusal(digest, words):
    return digest + b"\x02\x00" + struct.pack("=Q", len(words)) + words
assert sys.argv[-1] == "--messages"
while True:
    body = read(struct.unpack("=Q", read(8))[0])
    name = body[16:16 + struct.unpack("=Q", body[8:16])[0]]
    if name == b"die": os._exit(7)
    if name == b"sleep": time.sleep(100)
    if name == b"lie": write(refusal(b"\0" * 8, name))
    elif name == b"babble": write(b"no answer")
    elif name == b"cut":
        sys.stdout.buffer.write(struct.pack("=Q", 100) + b"half")
        sys.stdout.buffer.flush()
        os._exit(8)
    else: write(refusal(body[:8], name))
)";

class MessageRendererTest : public ProcessRendererTest {
 protected:
  ProcessSpec worker() {
    ProcessSpec spec = python(kWorker);
    spec.takes_messages = true;
    return spec;
  }

  // "unsupported scene 3", or another kind of failure and its reason, by scene.
  static std::vector<std::string> ask(Renderer& renderer, const std::vector<std::string>& ids) {
    const Scene scene = scene_of(1, 1);
    std::vector<Task> tasks;
    for (const std::string& id : ids) tasks.push_back({id, &scene});
    std::vector<std::string> answers;
    renderer.render(tasks, [&](std::size_t index, Outcome outcome) {
      EXPECT_EQ(index, answers.size());
      const Failure& failure = std::get<Failure>(outcome);
      answers.push_back(std::string(name_of(failure.kind)) + " " + failure.reason);
    });
    return answers;
  }

  // Of fifty scenes, some do what their names say.
  void expect_to_cost_itself_alone(const std::string& deed, const std::string& words,
                                   ProcessSpec spec) {
    std::vector<std::string> ids;
    for (int i = 0; i < 50; ++i) ids.push_back("scene " + std::to_string(i));
    for (const std::size_t i : {5U, 6U, 30U}) ids[i] = deed;
    ProcessRenderer renderer(std::move(spec));
    const auto answers = ask(renderer, ids);
    ASSERT_EQ(answers.size(), ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (ids[i] == deed)
        EXPECT_THAT(answers[i], HasSubstr(words)) << i;
      else
        EXPECT_EQ(answers[i], "unsupported " + ids[i]);
    }
  }
};

TEST_F(MessageRendererTest, ADeathCostsOneScene) {
  expect_to_cost_itself_alone("die", "crashed the program ended with exit status 7", worker());
}

TEST_F(MessageRendererTest, AnAnswerThatIsCutCostsOneScene) {
  expect_to_cost_itself_alone("cut", "crashed the program ended with exit status 8", worker());
}

TEST_F(MessageRendererTest, AHangCostsItsTimeoutAndOneScene) {
  ProcessSpec spec = worker();
  spec.timeout = std::chrono::milliseconds(500);
  expect_to_cost_itself_alone("sleep", "timed-out no answer within", std::move(spec));
}

TEST_F(MessageRendererTest, AnAnswerToAnotherSceneIsGarbage) {
  expect_to_cost_itself_alone("lie", "garbage its answer is refused: it is the answer to another",
                              worker());
}

TEST_F(MessageRendererTest, WhatIsNoAnswerIsGarbage) {
  expect_to_cost_itself_alone("babble", "garbage its answer is refused", worker());
}

TEST_F(MessageRendererTest, AnExceptionOfTheSinkLeavesNothingBehind) {
  ProcessRenderer renderer(worker());
  const Scene scene = scene_of(1, 1);
  std::vector<Task> tasks;
  for (int i = 0; i < 40; ++i) tasks.push_back({"early", &scene});
  EXPECT_THROW(renderer.render(tasks,
                               [](std::size_t index, const Outcome&) {
                                 if (index == 7) throw std::runtime_error("enough");
                               }),
               std::runtime_error);
  EXPECT_EQ(ask(renderer, {"late"}), std::vector<std::string>{"unsupported late"});
}

}  // namespace
}  // namespace edgecase
