// SPDX-License-Identifier: MIT
#include "search/trial.h"

#include <gtest/gtest.h>

#include <array>

#include "diff/compare.h"
#include "diff/judge.h"
#include "search/find.h"
#include "tests/search/faulty_renderer.h"

namespace edgecase {
namespace {

// Two triangles side by side, each of a hundred pixels and more.
Scene two_triangles() {
  return scene_with(
      32, {make_draw(Primitive::triangles,
                     std::array{sixteenths(8, 8), sixteenths(248, 8), sixteenths(8, 248)}),
           make_draw(Primitive::triangles,
                     std::array{sixteenths(264, 8), sixteenths(504, 8), sixteenths(264, 248)})});
}

// Colours are wrong everywhere, and of the second triangle the lower rows are missing.
std::optional<Failure> spoil(const Scene& scene, Rendering& rendering) {
  lose(scene, rendering, [](const Fragment& f) { return f.primitive == 1 && f.y < 3; });
  for (Fragment& fragment : rendering.fragments) fragment.color[0] = 1 - fragment.color[0];
  return std::nullopt;
}

std::vector<Shown> shown_when_judged(const Scene& scene, Result result) {
  Result* const one = &result;
  judge(std::span(&one, 1), Latitude::opengl);
  return shown_by(scene, result, Latitude::opengl);
}

TEST(Screen, KeepsFewOfWhatIsAlikeAndWhatAllOfItShows) {
  const Scene scene = two_triangles();
  FaultyRenderer faulty(spoil);
  const Screening screening =
      Screen({}, ReleaseProfiles()).ask(faulty, std::span(&scene, 1), false, nullptr);
  ASSERT_EQ(screening.suspects.size(), 1u);
  const Result& kept = screening.suspects[0].result;

  const Rendering exact = rasterize(scene, {});
  Rendering rendered = exact;
  spoil(scene, rendered);
  const Result whole = compare(scene, {}, exact, rendered, {8});
  EXPECT_GT(whole.disagreements.size(), 200u);
  EXPECT_LT(kept.disagreements.size(), 40u);
  EXPECT_EQ(kept.pixel_counts, PixelCounts{});

  const auto shown = shown_when_judged(scene, kept);
  const auto wanted = shown_when_judged(scene, whole);
  ASSERT_GE(wanted.size(), 2u);
  ASSERT_EQ(shown.size(), wanted.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(shown[i].key, wanted[i].key);
    EXPECT_EQ(shown[i].verdict, wanted[i].verdict);
  }
}

TEST(Screen, HasNoSuspectWhereNothingDiffers) {
  const Scene scene = two_triangles();
  FaultyRenderer right(nullptr);
  for (const bool coverage_only : {false, true}) {
    const Screening screening =
        Screen({}, ReleaseProfiles()).ask(right, std::span(&scene, 1), coverage_only, nullptr);
    EXPECT_TRUE(screening.suspects.empty());
    EXPECT_EQ(screening.drawn, 1u);
  }
}

}  // namespace
}  // namespace edgecase
