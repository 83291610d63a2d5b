// SPDX-License-Identifier: MIT
//
// A renderer that has all of its picture one pixel off: what is illegal of it has no cause.
#include "diff/moved_answer.h"

#include <gtest/gtest.h>

#include <deque>
#include <set>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "tests/diff/judged_results.h"
#include "tests/diff/named_scenes.h"

namespace edgecase {
namespace {

// What is drawn of a scene, moved; the rest of the target is what it was cleared to.
Rendering moved(const Scene& scene, int dx, int dy) {
  std::vector<Fragment> fragments = rasterize(scene, {}).fragments;
  for (Fragment& f : fragments) {
    f.x += dx;
    f.y += dy;
  }
  std::erase_if(fragments, [&](const Fragment& f) {
    return f.x < 0 || f.x >= scene.target.width || f.y < 0 || f.y >= scene.target.height;
  });
  return compose(scene, fragments);
}

std::deque<Result> run_moved_by(int dx, int dy) {
  std::deque<Result> results;
  for (const NamedScene& named : named_scenes())
    results.push_back(
        compare(named.scene, {}, rasterize(named.scene, {}), moved(named.scene, dx, dy), {8}));
  return results;
}

// Causes of what is illegal of coverage.
std::set<std::string> illegal_causes(const std::deque<Result>& results) {
  std::set<std::string> causes;
  for (const Result& result : results)
    for (const Disagreement& d : result.disagreements)
      if (!is_legal(d) && d.kind != DisagreementKind::value) causes.insert(d.cause);
  return causes;
}

TEST(MovedAnswers, AreRecognizedWhicheverWayTheyAreMoved) {
  for (const NamedScene& named : named_scenes()) {
    const Rendering exact = rasterize(named.scene, {});
    if (exact.fragments.empty()) continue;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, -1}, {-1, 1}})
      EXPECT_TRUE(is_covered_moved(exact, moved(named.scene, dx, dy))) << named.name;
    EXPECT_FALSE(is_covered_moved(exact, moved(named.scene, 2, 0))) << named.name;
    EXPECT_FALSE(is_covered_moved(exact, compose(named.scene, {}))) << named.name;
  }
}

TEST(MovedAnswers, HaveNoCause) {
  std::deque<Result> results = run_moved_by(1, 0);
  RunReading reading = read_run(pointers(results));
  EXPECT_TRUE(reading.is_moved);
  judge(pointers(results), Latitude::opengl, reading);
  EXPECT_EQ(illegal_causes(results), std::set<std::string>{""});
  // By chance alternatives draw so now and then.
  reading.is_moved = false;
  judge(pointers(results), Latitude::opengl, reading);
  EXPECT_GT(illegal_causes(results).size(), 1u);
}

// One answer that is moved among others that break rulings otherwise keeps its cause.
TEST(MovedAnswers, AreNoneWhereTheRunIsNotMoved) {
  std::deque<Result> results;
  for (const NamedScene& named : named_scenes())
    results.push_back(compare(named.scene, {}, rasterize(named.scene, {}),
                              moved(named.scene, results.empty() ? 1 : 3, 0), {8}));
  EXPECT_FALSE(read_run(pointers(results)).is_moved);
}

}  // namespace
}  // namespace edgecase
