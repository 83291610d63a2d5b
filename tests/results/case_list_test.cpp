// SPDX-License-Identifier: MIT
//
// What is put into a list of cases is what is read of it.
#include "results/case_list.h"

#include <gmock/gmock.h>

#include <atomic>
#include <cstdint>
#include <random>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "tests/results/expect_case.h"
#include "tests/results/sample_results.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

using testing::ElementsAre;

using Bytes = std::vector<std::uint8_t>;

// Also what a results file does not tell.
void expect_same(const CaseResults& a, const CaseResults& b) {
  expect_case(a, b);
  ASSERT_EQ(a.results.size(), b.results.size());
  for (std::size_t r = 0; r < a.results.size(); ++r) {
    const Result& one = a.results[r];
    const Result& other = b.results[r];
    for (std::size_t i = 0; i < one.disagreements.size(); ++i)
      EXPECT_EQ(one.disagreements[i].policy_agrees, other.disagreements[i].policy_agrees);
    for (std::size_t v = 0; v < one.values.size(); ++v)
      for (std::size_t i = 0; i < one.values[v].differing.size(); ++i) {
        const ValueAggregate::Place& p = one.values[v].differing[i];
        const ValueAggregate::Place& q = other.values[v].differing.at(i);
        EXPECT_EQ(std::tie(p.x, p.y, p.primitive), std::tie(q.x, q.y, q.primitive));
      }
  }
}

CaseResults filled() {
  CaseResults one = full_results().cases[0];
  one.results[0].disagreements[0].policy_agrees = true;
  one.results[0].values[0].differing = {{2, 1, 9}, {2, 1, 3}, {0, 4095, -1}};
  return one;
}

CaseResults named(const std::string& id) {
  CaseResults one;
  one.id = id;
  one.results.resize(2);
  return one;
}

// Of a picture that cannot be packed.
CaseResults noisy(std::size_t index) {
  CaseResults one = named(std::to_string(index));
  std::mt19937 random(static_cast<unsigned>(index));
  Bytes pixels(4 * 64 * 64);
  for (std::uint8_t& byte : pixels) byte = static_cast<std::uint8_t>(random());
  one.pixels = pixels;
  return one;
}

std::vector<std::string> ids_of(const CaseList& cases) {
  std::vector<std::string> ids;
  for (const CaseResults& one : cases) ids.push_back(one.id);
  return ids;
}

TEST(CaseList, GivesBackEveryMember) {
  CaseList list;
  const CaseResults one = filled();
  list.push_back(one);
  list.push_back(CaseResults{});
  expect_same(one, list[0]);
  expect_same(CaseResults{}, list[1]);
  expect_same(one, ShelvedCase(list[0], std::make_shared<Shelf>()).whole());
}

TEST(CaseList, GivesBackPlacesFarApartAndRunsOfNeighbours) {
  std::mt19937 random(5);
  const auto number = [&](int most) {
    return std::uniform_int_distribution<int>(-most, most)(random);
  };
  CaseResults one = filled();
  std::vector<ValueAggregate::Place>& places = one.results[0].values[0].differing;
  for (int i = 0; i < 2000; ++i) {
    const int most = i % 3 == 0 ? 1 : i % 3 == 1 ? 300 : 1 << 29;
    ValueAggregate::Place place{number(most), number(most), number(most)};
    for (int length = 1 + i % 4; length > 0; --length, ++place.x) places.push_back(place);
  }
  std::vector<CountedDisagreements>& counted = one.results[0].counted;
  counted.resize(1);
  for (int i = 0; i < 2000; ++i)
    counted[0].runs.push_back({number(4095), number(4095), number(4095)});
  EXPECT_EQ(list_of({one})[0].results[0].counted[0].runs, counted[0].runs);
  const auto read = list_of({one})[0].results[0].values[0].differing;
  ASSERT_EQ(read.size(), places.size());
  for (std::size_t i = 0; i < read.size(); ++i)
    ASSERT_EQ(std::tie(read[i].x, read[i].y, read[i].primitive),
              std::tie(places[i].x, places[i].y, places[i].primitive))
        << i;
}

TEST(CaseList, HasHeadsWhichCasesOfAFileShare) {
  CaseResults other = filled();
  other.id = "lines/b";
  other.fragments += 1;
  CaseResults titled = filled();
  titled.title += " again";
  const CaseList list = list_of({filled(), other, titled});
  EXPECT_EQ(list.shelved(0).head_place(), list.shelved(1).head_place());
  EXPECT_NE(list.shelved(0).head_place(), list.shelved(2).head_place());
  const CaseResults head = list.shelved(1).head();
  EXPECT_EQ(head.id, "lines/b");
  EXPECT_EQ(head.surface, other.surface);
  EXPECT_EQ(std::tie(head.title, head.why, head.rules, head.spec, head.origin, head.tags),
            std::tie(other.title, other.why, other.rules, other.spec, other.origin, other.tags));
  EXPECT_EQ(std::tie(head.file, head.file_digest, head.width, head.height),
            std::tie(other.file, other.file_digest, other.width, other.height));
  EXPECT_EQ(head.viewport.has_value(), other.viewport.has_value());
  EXPECT_TRUE(head.results.empty());
}

TEST(CaseList, KnowsWhatDependsOnTheRun) {
  CaseResults one = named("a");
  EXPECT_FALSE(outline_of(one).depends_on_run);
  one.results[0].values.resize(1);
  EXPECT_FALSE(outline_of(one).depends_on_run);
  one.results[1].evidence.resize(1);
  EXPECT_TRUE(outline_of(one).depends_on_run);
  one.results[1].evidence.clear();
  one.results[1].disagreements.resize(1);
  EXPECT_TRUE(outline_of(one).depends_on_run);
}

TEST(CaseList, HasTheOutlinesAtHand) {
  const CaseList list = list_of({filled(), named("b")});
  const CaseOutline& full = list.outline(0);
  EXPECT_EQ(full.id, "lines/a");
  EXPECT_EQ(full.surface, "fbo");
  EXPECT_EQ(full.expect_failures, 2u);
  EXPECT_TRUE(full.has_ramp);
  ASSERT_EQ(full.answers.size(), 2u);
  EXPECT_EQ(full.answers[0].standing, Standing::flake);
  EXPECT_EQ(full.answers[0].again, (Judgement{Verdict::agree, ""}));
  EXPECT_EQ(full.answers[1].failure->kind, FailureKind::timed_out);
  EXPECT_FALSE(list.outline(1).has_ramp);
  std::vector<std::string> ids;
  for (const CaseOutline& one : list.outlines()) ids.push_back(one.id);
  EXPECT_EQ(ids, ids_of(list));
}

TEST(CaseList, DetailsAreOfWhatDiffersOrIsToBeShown) {
  CaseResults one = named("a");
  for (Result& result : one.results) result.verdict = Verdict::agree;
  EXPECT_FALSE(has_details(outline_of(one)));
  const auto has = [&](const auto& change) {
    CaseResults other = one;
    change(other);
    return has_details(outline_of(other));
  };
  EXPECT_TRUE(has([](CaseResults& c) { c.expect_failures = {"drawn otherwise"}; }));
  EXPECT_TRUE(has([](CaseResults& c) { c.results[1].ramp.resize(1); }));
  EXPECT_TRUE(has([](CaseResults& c) { c.results[1].verdict = Verdict::convention; }));
  EXPECT_TRUE(has([](CaseResults& c) { c.results[1].standing = Standing::flake; }));
}

TEST(CaseList, PicturesThatWereEqualAreOneObject) {
  CaseResults one = filled();
  one.results[0].exact_pixels = one.pixels;
  one.results[0].pixels = one.pixels;
  one.results[0].samples = one.results[0].exact_samples = one.samples;
  one.results[1].pixels = Bytes{0, 1, 2, 255, 16, 32, 64, 127};
  const CaseResults back = list_of({one})[0];
  expect_same(one, back);
  EXPECT_TRUE(is_same_object(back.results[0].exact_pixels, back.pixels));
  EXPECT_TRUE(is_same_object(back.results[0].pixels, back.pixels));
  EXPECT_FALSE(is_same_object(back.results[1].pixels, back.pixels));
  for (const SampleImage* image : {&back.results[0].samples, &back.results[0].exact_samples}) {
    EXPECT_TRUE(is_same_object(image->pixels, back.samples.pixels));
    EXPECT_TRUE(is_same_object(image->hits, back.samples.hits));
    EXPECT_TRUE(is_same_object(image->coverage, back.samples.coverage));
  }
}

TEST(CaseList, AnAnswerThatIsChangedIsReadChanged) {
  CaseList list = list_of({filled()});
  list.answer(0, 1).standing = Standing::known;
  list.answer(0, 1).faults = {"joints"};
  const CaseResults back = list[0];
  EXPECT_EQ(back.results[1].standing, Standing::known);
  EXPECT_EQ(back.results[1].faults, std::vector<std::string>{"joints"});
  EXPECT_EQ(back.results[0].standing, Standing::flake);
}

TEST(CaseList, CopiesChangeAlone) {
  CaseList list = list_of({named("a"), named("b")});
  CaseList copy = list;
  copy.change(0, [](CaseResults& one) { one.title = "another"; });
  copy.answer(1, 0).verdict = Verdict::agree;
  copy.push_back(named("c"));
  list.replace(1, named("z"));
  EXPECT_THAT(ids_of(list), ElementsAre("a", "z"));
  EXPECT_THAT(ids_of(copy), ElementsAre("a", "b", "c"));
  EXPECT_EQ(list[0].title, "");
  EXPECT_EQ(copy[0].title, "another");
  EXPECT_EQ(list.outline(1).answers[0].verdict, Verdict::not_run);
  EXPECT_EQ(copy.outline(1).answers[0].verdict, Verdict::agree);
}

TEST(CaseList, MergesByIdFindsAndLeavesOut) {
  CaseList list = list_of({named("c"), named("a")});
  list.merge(list_of({named("d"), named("b")}));
  EXPECT_THAT(ids_of(list), ElementsAre("a", "b", "c", "d"));
  EXPECT_EQ(list.find("c"), 2u);
  EXPECT_EQ(list.find("e"), std::nullopt);
  list.erase_if([](const CaseOutline& one) { return one.id == "a" || one.id == "c"; });
  EXPECT_THAT(ids_of(list), ElementsAre("b", "d"));
  EXPECT_EQ(list.find("c"), std::nullopt);
  list.push_back(named("e"));
  EXPECT_EQ(list.find("e"), 2u);
}

// Both lists are on one shelf, and what is pushed begins its file.
TEST(CaseList, IsReadBySeveralThreadsWhileACopyGrows) {
  constexpr std::size_t kCases = 30;
  CaseList list;
  for (std::size_t i = 0; i < kCases; ++i) list.push_back(noisy(i));
  CaseList copy = list;
  std::atomic<bool> is_done = false;
  std::atomic<std::size_t> wrong = 0;
  std::vector<std::thread> readers;
  for (std::size_t t = 0; t < 3; ++t)
    readers.emplace_back([&, t] {
      for (std::size_t i = t; !is_done || i < 2 * kCases; ++i)
        if (list[i % kCases].pixels != noisy(i % kCases).pixels) ++wrong;
    });
  for (std::size_t i = kCases; i < 6 * kCases; ++i) copy.push_back(noisy(i));
  is_done = true;
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(wrong, 0u);
  ASSERT_EQ(copy.size(), 6 * kCases);
  for (std::size_t i = 0; i < copy.size(); ++i) EXPECT_EQ(copy[i].pixels, noisy(i).pixels) << i;
}

}  // namespace
}  // namespace edgecase
