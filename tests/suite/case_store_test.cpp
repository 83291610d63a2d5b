// SPDX-License-Identifier: MIT
#include "suite/case_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "model/scene.h"
#include "suite/selection.h"

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
