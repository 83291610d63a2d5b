// SPDX-License-Identifier: MIT
#include "run/case_store.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "model/scene.h"
#include "run/selection.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

Suite suite_of(const char* folder) {
  Selection selection;
  selection.paths = {fs::path(EDGECASE_ROOT) / "cases" / folder};
  return load_suite(selection);
}

void expect_same(const Case& one, const Case& other) {
  SCOPED_TRACE(one.id);
  EXPECT_EQ(one.id, other.id);
  EXPECT_EQ(one.parts, other.parts);
  EXPECT_EQ(one.title, other.title);
  EXPECT_EQ(one.why, other.why);
  EXPECT_EQ(one.rules, other.rules);
  EXPECT_EQ(one.spec, other.spec);
  EXPECT_EQ(one.origin, other.origin);
  EXPECT_EQ(one.tags, other.tags);
  EXPECT_EQ(one.file, other.file);
  EXPECT_EQ(*one.source, *other.source);
  EXPECT_TRUE(same_scene(one.scene, other.scene));
  ASSERT_EQ(one.expect.size(), other.expect.size());
  for (std::size_t i = 0; i < one.expect.size(); ++i) {
    EXPECT_EQ(one.expect[i].policy, other.expect[i].policy);
    EXPECT_EQ(one.expect[i].coverage, other.expect[i].coverage);
    EXPECT_EQ(one.expect[i].masks, other.expect[i].masks);
    EXPECT_EQ(one.expect[i].where, other.expect[i].where);
  }
}

Case case_of(const std::string& id) {
  Case one;
  one.id = id;
  return one;
}

std::vector<std::string> ids_of(const CaseStore& cases) {
  std::vector<std::string> ids;
  for (const Case& one : cases) ids.push_back(one.id);
  return ids;
}

TEST(CaseStore, IsEmptyAtFirst) {
  const CaseStore cases;
  EXPECT_TRUE(cases.empty());
  EXPECT_EQ(cases.size(), 0U);
  EXPECT_TRUE(cases.begin() == cases.end());
}

// Each case that is read from a file comes back as it was, in whatever order it is asked for.
TEST(CaseStore, GivesBackWhatWasPutThere) {
  for (const char* folder : {"points", "samples", "textures"}) {
    const CaseStore stored = suite_of(folder).cases;
    const std::vector<Case> cases = stored.all();
    ASSERT_GT(cases.size(), 50U) << folder;
    const CaseStore again(cases);
    for (std::size_t i = 0; i < cases.size(); i += 7) expect_same(again[i], cases[i]);
    for (std::size_t i = cases.size(); i-- > 0;)
      if (i % 11 == 0) expect_same(again[i], cases[i]);
    EXPECT_EQ(again.id(5), cases[5].id);
  }
}

TEST(CaseStore, NeighboursShareTextAndTextures) {
  auto texture = std::make_shared<Texture>();
  texture->levels.resize(1);
  Case a = case_of("a");
  a.source = std::string("text");
  a.scene.textures = {texture};
  Case b = a;
  b.id = "b";
  const CaseStore cases{a, b};
  const Case first = cases[0];
  const Case second = cases[1];
  EXPECT_TRUE(is_same_object(first.source, second.source));
  ASSERT_EQ(first.scene.textures.size(), 1U);
  EXPECT_EQ(first.scene.textures[0], second.scene.textures[0]);
}

// More than are remembered at a time.
TEST(CaseStore, EachHasItsOwnTextAndTexture) {
  std::vector<Case> list;
  for (int i = 0; i < 40; ++i) {
    Case one = case_of("case " + std::to_string(i));
    one.source = "text " + std::to_string(i % 20);
    auto texture = std::make_shared<Texture>();
    texture->levels.resize(static_cast<std::size_t>(i % 20) + 1);
    one.scene.textures = {texture};
    list.push_back(one);
  }
  const CaseStore cases(list);
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::size_t at = round == 0 ? i : list.size() - 1 - i;
      EXPECT_EQ(*cases[at].source, *list[at].source);
      EXPECT_EQ(cases[at].scene.textures[0]->levels.size(), at % 20 + 1);
    }
}

TEST(CaseStore, SortsAndKeepsASample) {
  CaseStore cases{case_of("d"), case_of("b"), case_of("a"), case_of("e"), case_of("c")};
  const CaseStore before = cases;
  cases.sort_by_id();
  EXPECT_EQ(ids_of(cases), (std::vector<std::string>{"a", "b", "c", "d", "e"}));
  cases.keep_sample(1, 2);
  EXPECT_EQ(ids_of(cases), (std::vector<std::string>{"b", "d"}));
  EXPECT_EQ(ids_of(before), (std::vector<std::string>{"d", "b", "a", "e", "c"}));
}

// Cases of weights that differ a hundredfold.
std::vector<Case> uneven_cases(int count) {
  std::vector<Case> list;
  for (int i = 0; i < count; ++i) {
    list.push_back(case_of(fmt::format("case-{:04}", i)));
    list.back().scene.target.width = list.back().scene.target.height = i % 97 == 0 ? 160 : i % 13;
  }
  return list;
}

std::size_t weight_of(const CaseStore& cases) {
  std::size_t weight = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) weight += cases.weight(i);
  return weight;
}

TEST(CaseStore, SharesHaveEachCaseOnceAndWeighTheSame) {
  for (const int size : {0, 1, 5, 31, 2000})
    for (const std::size_t count : {1U, 2U, 3U, 7U, 40U}) {
      const CaseStore whole(uneven_cases(size));
      std::vector<std::string> together;
      std::vector<std::size_t> weights;
      for (std::size_t index = 0; index < count; ++index) {
        CaseStore share = whole;
        share.keep_share(index, count);
        const std::vector<std::string> ids = ids_of(share);
        EXPECT_TRUE(std::ranges::is_sorted(ids));
        together.insert(together.end(), ids.begin(), ids.end());
        weights.push_back(weight_of(share));
      }
      std::ranges::sort(together);
      EXPECT_EQ(together, ids_of(whole));
      // They differ by one stretch at most: an eighth of a share, or one heavy case.
      const auto [least, most] = std::ranges::minmax(weights);
      EXPECT_LE(most - least, weight_of(whole) / (8 * count) + 256 + 160 * 160) << size << count;
    }
}

// The first half has textures: each of its cases costs as much as four of the others.
TEST(CaseStore, SharesCostTheSame) {
  std::vector<Case> list;
  for (int i = 0; i < 2000; ++i) {
    list.push_back(case_of(fmt::format("case-{:04}", i)));
    if (i < 1000) list.back().scene.textures = {std::make_shared<Texture>()};
  }
  const CaseStore whole(list);
  for (const std::size_t count : {2U, 3U, 7U})
    for (std::size_t index = 0; index < count; ++index) {
      CaseStore share = whole;
      share.keep_share(index, count);
      const std::vector<std::string> ids = ids_of(share);
      const auto textured =
          std::ranges::count_if(ids, [](const auto& id) { return id < "case-1"; });
      const std::ptrdiff_t cost = std::ssize(ids) + 3 * textured;
      EXPECT_NEAR(static_cast<double>(cost), 5000.0 / static_cast<double>(count), 64 * 4);
    }
}

TEST(CaseStore, SharesAreStretchesOfNeighbours) {
  CaseStore share(uneven_cases(2000));
  share.keep_share(1, 2);
  const std::vector<std::string> ids = ids_of(share);
  int breaks = 0;
  for (std::size_t i = 1; i < ids.size(); ++i)
    breaks += std::stoi(ids[i].substr(5)) != std::stoi(ids[i - 1].substr(5)) + 1;
  EXPECT_LE(breaks, 30);
}

TEST(CaseStore, SeveralThreadsRead) {
  const CaseStore cases = suite_of("points").cases;
  const std::vector<Case> expected = cases.all();
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (std::size_t i = t; i < expected.size(); i += 5)
        EXPECT_TRUE(same_scene(cases[i].scene, expected[i].scene));
    });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace edgecase
