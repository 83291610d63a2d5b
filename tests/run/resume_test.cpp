// SPDX-License-Identifier: MIT
//
// What a resumed run takes over from an earlier one, what it runs again, and what it refuses to
// lose.
#include "run/merge.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "model/text.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A file that is there, whoever asks.
constexpr const char* kPresent = "/proc/self/exe";

Case case_of(const std::string& id, const std::string& source) {
  Case one;
  one.id = id;
  one.file = "cases/" + id + ".json";
  one.source = source;
  return one;
}

CaseResults answer_of(const std::string& id, const std::string& source) {
  CaseResults one;
  one.id = id;
  one.file = "earlier/cases/" + id + ".json";
  one.file_digest = digest_of_text(source);
  one.results.emplace_back();
  return one;
}

CaseResults failed(CaseResults one, FailureKind kind) {
  one.results[0].verdict = Verdict::not_run;
  one.results[0].failure = Failure{kind, "for a reason"};
  return one;
}

Suite suite_of(std::vector<Case> cases) {
  Suite suite;
  suite.cases = std::move(cases);
  return suite;
}

// An interrupted run of these cases.
MergePart run_of(const std::vector<CaseResults>& cases) {
  MergePart part{"results.json", {}};
  part.results.tool = "edgecase 1";
  part.results.renderers = {{"fake", "vendor", "1.0", "device", 8, {}}};
  part.results.cases = list_of(cases);
  part.results.interrupted = true;
  part.results.left_out = 7;
  return part;
}

Resumption resumed(const Suite& suite, MergePart earlier) {
  auto outcome = resume(suite, std::move(earlier));
  if (const auto* fault = std::get_if<std::string>(&outcome)) throw std::runtime_error(*fault);
  return std::get<Resumption>(std::move(outcome));
}

template <class Cases>
std::vector<std::string> ids(const Cases& cases) {
  std::vector<std::string> result;
  for (const auto& one : cases) result.push_back(one.id);
  return result;
}

TEST(Resume, TakesOverWhatIsStillTheSame) {
  const Suite suite = suite_of({case_of("a", "A"), case_of("b", "new"), case_of("c", "C")});
  const auto [held, rest] = resumed(suite, run_of({answer_of("a", "A"), answer_of("b", "old")}));
  EXPECT_THAT(ids(held.cases), ElementsAre("a"));
  EXPECT_THAT(ids(rest.cases), ElementsAre("b", "c"));
}

TEST(Resume, KnowsThePlaceOfTodaysFile) {
  const Suite suite = suite_of({case_of("a", "A")});
  const auto [held, rest] = resumed(suite, run_of({answer_of("a", "A")}));
  ASSERT_EQ(held.cases.size(), 1u);
  EXPECT_EQ(held.cases[0].file, "cases/a.json");
}

// Whether the whole is interrupted, a shard, or has faults, is for the whole to say.
TEST(Resume, KeepsOfTheRunWhatItWasAndNotHowItEnded) {
  Suite suite = suite_of({case_of("a", "A")});
  suite.diagnostics = {{"cases/b.json", 1, "", "is broken", "mend it"}};
  MergePart earlier = run_of({answer_of("a", "A")});
  earlier.results.shard = {0, 2, 2, "digest"};
  earlier.results.diagnostics = suite.diagnostics;
  const auto [held, rest] = resumed(suite, earlier);
  EXPECT_EQ(held.tool, "edgecase 1");
  EXPECT_EQ(held.renderers.size(), 1u);
  EXPECT_FALSE(held.interrupted);
  EXPECT_EQ(held.left_out, 0u);
  EXPECT_FALSE(held.shard);
  EXPECT_THAT(held.diagnostics, IsEmpty());
  EXPECT_EQ(rest.diagnostics.size(), 1u);
}

TEST(Resume, AsksAgainOnlyWhereNobodyWasThere) {
  const Suite suite = suite_of({case_of("a", "A"), case_of("b", "B"), case_of("c", "C")});
  const auto [held, rest] =
      resumed(suite, run_of({failed(answer_of("a", "A"), FailureKind::unavailable),
                             failed(answer_of("b", "B"), FailureKind::crashed),
                             failed(answer_of("c", "C"), FailureKind::timed_out)}));
  EXPECT_THAT(ids(held.cases), ElementsAre("b", "c"));
  EXPECT_THAT(ids(rest.cases), ElementsAre("a"));
}

TEST(Resume, RunsAgainWhatMayLieInOtherFiles) {
  const std::string mesh = R"({"draws": [{"mesh": "knot.obj"}]})";
  const std::string image = R"({"textures": {"wood": {"file": "wood.png"}}})";
  const Suite suite = suite_of({case_of("a", mesh), case_of("b", image), case_of("c", "files")});
  const auto [held, rest] = resumed(
      suite, run_of({answer_of("a", mesh), answer_of("b", image), answer_of("c", "files")}));
  EXPECT_THAT(ids(held.cases), ElementsAre("c"));
  EXPECT_THAT(ids(rest.cases), ElementsAre("a", "b"));
}

TEST(Resume, RefusesToLoseACaseThatIsNotSelected) {
  CaseResults other = answer_of("z", "Z");
  other.file = kPresent;
  const auto outcome =
      resume(suite_of({case_of("a", "A")}), run_of({answer_of("a", "A"), std::move(other)}));
  ASSERT_TRUE(std::holds_alternative<std::string>(outcome));
  EXPECT_THAT(std::get<std::string>(outcome),
              HasSubstr("results.json holds the case z, which is not selected now"));
}

// A file that is gone, one that cannot be loaded now, and one whose sweep has other cases now.
TEST(Resume, DoesNotMissWhatIsNoMore) {
  Case swept = case_of("c:x=2", "new");
  swept.file = kPresent;
  CaseResults before = answer_of("c:x=1", "old");
  before.file = kPresent;
  EXPECT_THAT(ids(resumed(suite_of({swept}), run_of({before, answer_of("gone", "G")})).rest.cases),
              ElementsAre("c:x=2"));
  Suite broken = suite_of({});
  broken.diagnostics = {{kPresent, 1, "", "is broken", "mend it"}};
  EXPECT_THAT(ids(resumed(broken, run_of({before})).held.cases), IsEmpty());
}

}  // namespace
}  // namespace edgecase
