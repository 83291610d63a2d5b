// SPDX-License-Identifier: MIT
//
// Parts of a run become the whole: what belongs together is judged together, what does not is
// refused.
#include "run/merge.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "diff/coverage/cause.h"
#include "results/results_json.h"
#include "rules/coverage/window.h"
#include "run/judging.h"
#include "tests/support/causes.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A line that is legal under one catalogued snap alone, with a fragment missing inside.
Result line_read_with(const std::string& snap) {
  Result result;
  Disagreement d;
  d.primitive = 0;
  d.rule = rule_named("line.diamond-exit");
  d.ruling = 1;
  result.disagreements = {d};
  for (Snap other : all_snaps())
    if (name_of(other) != snap) result.illegal_line_snaps.push_back(name_of(other));
  result.evidence = {{0, {kInteriorGap}, result.illegal_line_snaps, ""}};
  return result;
}

CaseResults case_of(const std::string& id, Result result) {
  CaseResults one;
  one.id = id;
  one.file = "cases/" + id + ".json";
  one.surface = "fbo";
  one.results = {std::move(result)};
  return one;
}

Results run_of(const std::vector<CaseResults>& cases) {
  Results results;
  results.tool = "edgecase 1";
  results.policy = "opengl";
  results.renderers = {{"fake", "vendor", "1.0", "device", 8, {{"a", "b"}}}};
  results.cases = list_of(cases);
  judge_all(results);
  return results;
}

std::vector<CaseResults> six_cases() {
  std::vector<CaseResults> cases;
  for (const char* id : {"a", "c", "d", "f"}) cases.push_back(case_of(id, line_read_with("none")));
  for (const char* id : {"b", "e"}) cases.push_back(case_of(id, line_read_with("8-truncate")));
  std::ranges::sort(cases, {}, &CaseResults::id);
  return cases;
}

MergePart shard(int index, int count) {
  std::vector<CaseResults> kept;
  const auto cases = six_cases();
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (static_cast<int>(i) % count == index) kept.push_back(cases[i]);
  MergePart part{std::string(1, static_cast<char>('1' + index)) + ".json", run_of(kept)};
  part.results.shard = {index, count, cases.size(), "digest"};
  return part;
}

std::string written(const Results& results) {
  std::ostringstream out;
  write_results(results, out);
  return out.str();
}

Results merged(std::vector<MergePart> parts, bool partial = false) {
  auto outcome = merge_results(std::move(parts), partial);
  if (const auto* fault = std::get_if<std::string>(&outcome)) throw std::runtime_error(*fault);
  return std::get<Results>(std::move(outcome));
}

std::string refusal(std::vector<MergePart> parts, bool partial = false) {
  const auto outcome = merge_results(std::move(parts), partial);
  const auto* fault = std::get_if<std::string>(&outcome);
  return fault != nullptr ? *fault : "";
}

// In the second of three shards, b and e, lines are read otherwise than in the whole: what was
// legal there is not any more, and the ruling is as it was first.
TEST(Merge, EqualsTheWholeRunThoughShardsReadLinesOtherwise) {
  const MergePart second = shard(1, 3);
  EXPECT_EQ(second.results.renderers[0].traits.at("lines read with snap, fbo"), "8-truncate");
  EXPECT_EQ(second.results.cases[0].results[0].disagreements[0].ruling, 3);
  const Results whole = run_of(six_cases());
  EXPECT_EQ(whole.cases[1].results[0].disagreements[0].ruling, 1);
  EXPECT_EQ(written(merged({shard(2, 3), shard(0, 3), second})), written(whole));
}

TEST(Merge, OfOnePartIsThatPart) {
  const Results whole = run_of(six_cases());
  EXPECT_EQ(written(merged({{"a.json", whole}})), written(whole));
}

TEST(Merge, SaysWhichShardsAreMissing) {
  EXPECT_THAT(refusal({shard(0, 4), shard(2, 4)}), HasSubstr("shards 2/4, 4/4 are missing"));
  EXPECT_THAT(refusal({shard(0, 2)}), HasSubstr("shard 2/2 is missing"));
  const Results partial = merged({shard(0, 2)}, true);
  EXPECT_TRUE(partial.interrupted);
  EXPECT_EQ(partial.left_out, 3u);
  EXPECT_FALSE(partial.shard);
}

// Shards count the cases of all files, and some files turn out to have faults.
TEST(Merge, CasesOfAFaultyFileAreNotLeftOut) {
  const auto parts = [](std::size_t faulty) {
    std::vector<MergePart> list;
    for (int i = 0; i < 3; ++i) {
      list.push_back(shard(i, 3));
      list.back().results.shard->cases += 4;
      if (i > 0) list.back().results.shard->faulty = faulty;
    }
    return list;
  };
  EXPECT_EQ(merged(parts(2)).left_out, 0u);
  EXPECT_FALSE(merged(parts(2)).interrupted);
  // Shards that are cut in different ways, by two versions for instance, may lack cases between
  // them.
  EXPECT_EQ(merged(parts(1)).left_out, 2u);
  EXPECT_TRUE(merged(parts(1)).interrupted);
}

TEST(Merge, SharesWithoutACaseAreNotMissed) {
  std::vector<MergePart> parts;
  for (int i = 0; i < 6; ++i) parts.push_back(shard(i, 8));
  EXPECT_FALSE(merged(std::move(parts)).interrupted);
}

TEST(Merge, RefusesWhatDoesNotBelongTogether) {
  const auto refused = [](auto change, const std::string& said) {
    MergePart other = shard(1, 2);
    change(other.results);
    const std::string fault = refusal({shard(0, 2), other});
    EXPECT_THAT(fault, HasSubstr(said));
    EXPECT_THAT(fault, HasSubstr("1.json"));
  };
  refused([](Results& r) { r.tool = "edgecase 2"; }, "2.json by edgecase 2");
  refused([](Results& r) { r.policy = "cs184"; }, "by policy cs184");
  refused([](Results& r) { r.latitude = Latitude::none; }, "policy opengl without latitude");
  refused([](Results& r) { r.policy_digest = "other"; }, "policies or profiles that differ");
  refused([](Results& r) { r.renderers[0].name = "other"; }, "2.json of other");
  refused([](Results& r) { r.renderers[0].version = "2.0"; }, "version 2.0");
  refused([](Results& r) { r.renderers[0].traits["a"] = "c"; }, "a: c");
  refused([](Results& r) { r.shard->count = 3; }, "one of 3");
  refused([](Results& r) { r.shard->selection = "other"; }, "different selections or suites");
  refused([](Results& r) { r.shard->cases = 7; }, "different selections or suites");
  refused([](Results& r) { r.shard->index = 0; }, "both hold shard 1 of 2");
  refused([](Results& r) { r.shard.reset(); }, "is none");
  refused([](Results& r) { edit(r.cases, 0)->id = "a"; }, "the case a is in");
  refused(
      [](Results& r) {
        edit(r.cases, 0)->file = "cases/a.json";
        edit(r.cases, 0)->file_digest = "other";
      },
      "the case file cases/a.json is another");
}

TEST(Merge, ARendererThatNeverAnsweredTakesTheOthersClaims) {
  MergePart silent = shard(0, 2);
  silent.results.renderers[0] = {"fake", "", "", "", 4, {}};
  EXPECT_EQ(merged({silent, shard(1, 2)}).renderers[0].version, "1.0");
}

TEST(Merge, UnitesDiagnosticsOnce) {
  MergePart one = shard(0, 2);
  MergePart other = shard(1, 2);
  const Diagnostic bad{"cases/bad.json", 3, "/draws", "wrong", "right"};
  one.results.diagnostics = {bad, {"cases/x.json", 0, "", "gone", ""}};
  other.results.diagnostics = one.results.diagnostics;
  EXPECT_EQ(merged({one, other}).diagnostics.size(), 2u);
}

TEST(Merge, KeepsFlakesAndInterruptions) {
  MergePart one = shard(0, 2);
  one.results.cases.answer(0, 0).again = {Verdict::agree, ""};
  one.results.interrupted = true;
  const Results whole = merged({one, shard(1, 2)});
  EXPECT_TRUE(whole.interrupted);
  EXPECT_EQ(whole.cases[0].results[0].again, (Judgement{Verdict::agree, ""}));
}

TEST(Merge, RunsOfDifferentCasesNeedNoShards) {
  const auto cases = six_cases();
  const Results whole =
      merged({{"a.json", run_of({cases[4], cases[5]})}, {"b.json", run_of({cases[0], cases[1]})}});
  std::vector<std::string> ids;
  for (const CaseOutline& one : whole.cases.outlines()) ids.push_back(one.id);
  EXPECT_THAT(ids, ElementsAre("a", "b", "e", "f"));
  EXPECT_FALSE(whole.whole_suite);
}

// Its profile is in the digest of the part that knows what it is.
TEST(Merge, APartInWhichARendererNeverAnsweredHasNotItsProfile) {
  for (const std::size_t silent : {0U, 1U}) {
    std::vector<MergePart> parts = {shard(0, 2), shard(1, 2)};
    for (MergePart& part : parts) part.results.policy_digest = "with its profile";
    parts[silent].results.renderers[0] = {"fake", "", "", "", 4, {}};
    parts[silent].results.policy_digest = "without";
    const auto merged = merge_results(parts, false);
    ASSERT_TRUE(std::holds_alternative<Results>(merged)) << std::get<std::string>(merged);
    EXPECT_EQ(std::get<Results>(merged).policy_digest, "with its profile");
    EXPECT_EQ(std::get<Results>(merged).renderers[0].device, "device");
  }
}

}  // namespace
}  // namespace edgecase
