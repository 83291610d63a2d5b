// SPDX-License-Identifier: MIT
//
// Gross faults: beyond the first disagreements in full, the rest are counted, and judged as if each
// were in full.
#include "diff/findings/add_disagreement.h"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "diff/findings/patience.h"
#include "diff/verdicts.h"
#include "raster/rasterizer.h"
#include "rules/choices.h"
#include "tests/diff/named_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

constexpr int kSize = 96;  // pixels: more in area than are reported in full

Vertex vertex_at(double x, double y) {
  Vertex vertex;
  vertex.position = {Fixed::from_raw(static_cast<std::int64_t>(x * Fixed::kOne)),
                     Fixed::from_raw(static_cast<std::int64_t>(y * Fixed::kOne))};
  vertex.color = {1, 0.5F, 0.25F, 1};
  return vertex;
}

// Two triangles with a common edge over most of the target; its samples lie near edges, too.
Scene two_triangles(int samples) {
  Scene scene;
  scene.target.width = scene.target.height = kSize;
  scene.target.samples = samples;
  scene.viewport = {0, 0, kSize, kSize};
  Draw draw;
  draw.primitive = Primitive::triangles;
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{
           {1.5, 2.5}, {93.5, 3.25}, {90.5, 94.5}, {1.5, 2.5}, {90.5, 94.5}, {2.25, 91.5}})
    draw.vertices.push_back(vertex_at(x, y));
  scene.draws = {draw};
  return scene;
}

Rendering without_fragments(Rendering rendering) {
  rendering.fragments.clear();
  return rendering;
}

// Fragments left out, added and doubled at random.
Rendering stray(const Scene& scene, Rendering rendering, std::uint32_t seed) {
  std::minstd_rand random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<Fragment> fragments;
  for (const Fragment& fragment : rendering.fragments)
    for (int times = below(3); times > 0; --times) fragments.push_back(fragment);
  for (int i = 0; i < 3000; ++i) {
    Fragment fragment;
    fragment.x = below(kSize);
    fragment.y = below(kSize);
    fragment.primitive = below(2);
    fragment.coverage = 1 + static_cast<std::uint32_t>(below((1 << scene.target.samples) - 1));
    if (scene.target.samples == 1) fragment.coverage = 1;
    fragment.has_color = fragment.has_depth = false;
    fragments.push_back(fragment);
  }
  rendering.fragments = std::move(fragments);
  sort_fragments(rendering);
  return rendering;
}

// The right rendering but for a band of rows.
Rendering band(const Rendering& exact, const Rendering& rendered, int low, int high) {
  Rendering mixed = exact;
  std::vector<Fragment> fragments;
  const auto in_band = [&](const Fragment& f) { return f.y >= low && f.y < high; };
  for (const Fragment& f : exact.fragments)
    if (!in_band(f)) fragments.push_back(f);
  for (const Fragment& f : rendered.fragments)
    if (in_band(f)) fragments.push_back(f);
  mixed.fragments = std::move(fragments);
  sort_fragments(mixed);
  return mixed;
}

// What disagrees on coverage, and how it is judged: pixel, sample, primitive, kind, rule, ruling
// and legality; with how many of them.
using Found =
    std::map<std::tuple<int, int, int, int, DisagreementKind, RuleId, int, Legality>, int>;

void add(PixelPosition pixel, const DisagreementClass& d, Found& found) {
  if (d.kind != DisagreementKind::value)
    ++found[{pixel.x, pixel.y, d.sample, d.primitive, d.kind, d.rule, d.ruling, d.legality}];
}

void add(const Result& result, Found& found) {
  for (const Disagreement& d : result.disagreements) add({d.x, d.y}, d, found);
  for (const CountedDisagreements& d : result.counted)
    for (const PixelRun& run : d.runs)
      for (int x = run.begin; x < run.end; ++x) add({x, run.y}, d, found);
}

// Each band has few enough disagreements to be reported in full.
Found found_in_bands(const Scene& scene, const Rendering& exact, const Rendering& rendered) {
  Found found;
  const int height = 4 / std::min(scene.target.samples, 4);
  for (int y = 0; y < kSize; y += height) {
    const Result result = judged(scene, band(exact, rendered, y, y + height));
    EXPECT_TRUE(result.counted.empty());
    add(result, found);
  }
  return found;
}

TEST(GrossFaults, AreJudgedAsIfEachDisagreementWereInFull) {
  for (const int samples : {1, 4}) {
    const Scene scene = two_triangles(samples);
    Rendering exact = rasterize(scene, Policy{});
    // Whoever reports places has each sample at one (ruling 65), which bands do not know.
    exact.sample_positions.clear();
    for (const Rendering& rendered :
         {without_fragments(exact), stray(scene, exact, 1), stray(scene, exact, 2)}) {
      const Result result = judged(scene, rendered);
      EXPECT_FALSE(result.counted.empty());
      Found found;
      add(result, found);
      EXPECT_EQ(found, found_in_bands(scene, exact, rendered)) << samples << " samples";
    }
  }
}

TEST(GrossFaults, AreFewInFullWithExamplesOfEachKind) {
  const Scene scene = two_triangles(4);
  const Rendering exact = rasterize(scene, Policy{});
  const Result result = judged(scene, stray(scene, exact, 3));
  EXPECT_GE(result.disagreements.size(), kMostInFull);
  EXPECT_LT(result.disagreements.size(), kMostInFull + 40 * kExamplesOfKind);
  for (const CountedDisagreements& counted : result.counted) {
    const auto is_example = [&](const Disagreement& d) {
      return d.kind == counted.kind && d.rule == counted.rule;
    };
    EXPECT_GE(std::ranges::count_if(result.disagreements, is_example), 1) << name_of(counted.rule);
  }
}

TEST(GrossFaults, CountEachPixelByItsWorst) {
  const Scene scene = two_triangles(1);
  const Rendering exact = rasterize(scene, Policy{});
  const Result result = judged(scene, without_fragments(exact));
  PixelCounts expected;
  expected.same = kSize * kSize;
  std::map<std::pair<int, int>, Verdict> worst;
  for (int y = 0; y < kSize; ++y)
    for (const Disagreement& d :
         judged(scene, band(exact, without_fragments(exact), y, y + 1)).disagreements) {
      Verdict& verdict = worst[{d.x, d.y}];
      verdict = std::max(verdict, verdict_of(d, Latitude::opengl));
    }
  for (const auto& [pixel, verdict] : worst) ++expected[verdict];
  expected[Verdict::agree] = expected.same - worst.size();
  EXPECT_EQ(result.verdict, Verdict::violation);
  const PixelCounts& found = result.pixel_counts;
  EXPECT_EQ(found[Verdict::violation] + found[Verdict::contested],
            expected[Verdict::violation] + expected[Verdict::contested]);
  EXPECT_EQ(found[Verdict::agree], expected[Verdict::agree]);
}

// The one illegal difference comes last.
TEST(GrossFaults, AreNotMilderThanTheWorstThatIsCounted) {
  Result result;
  DisagreementClass legal;
  legal.rule = RuleId::triangle_fill_rule;
  legal.legality = Legality::legal;
  legal.ruling = 4;
  for (int i = 0; i < 10'000; ++i) add_disagreement(result, {i % 100, i / 100}, legal);
  DisagreementClass illegal = legal;
  illegal.legality = Legality::illegal;
  for (std::size_t i = 0; i <= kExamplesOfKind; ++i) add_disagreement(result, {0, 0}, illegal);
  EXPECT_EQ(result.disagreements.size(), kMostInFull + kExamplesOfKind);
  EXPECT_EQ(count_disagreements(result), 10'000 + kExamplesOfKind + 1);
  std::erase_if(result.disagreements,
                [](const Disagreement& d) { return d.legality == Legality::illegal; });
  Result* const alone[] = {&result};
  judge(alone, Latitude::opengl);
  EXPECT_EQ(result.verdict, Verdict::violation);
}

TEST(GrossFaults, ShowInTheFingerprintBeyondWhatIsInFull) {
  const Scene scene = two_triangles(1);
  const Rendering exact = rasterize(scene, Policy{});
  const Rendering blank = without_fragments(exact);
  const Result all = judged(scene, blank);
  const Result most = judged(scene, band(exact, blank, 0, kSize - 20));
  ASSERT_EQ(all.disagreements.size(), most.disagreements.size());
  EXPECT_NE(all.fingerprint, most.fingerprint);
}

// Alternatives are drawn at a few pixels first where a drawing is large; both find the same.
TEST(GrossFaults, HaveTheCausesOfSmallOnes) {
  Scene scene = two_triangles(1);
  scene.draws[0].vertices.resize(3);
  const Policy closed = policy_with("triangle.fill-rule", "closed");
  scene.draws[0].vertices = {vertex_at(0.5, 0.5), vertex_at(90.5, 0.5), vertex_at(0.5, 90.5)};
  const Result result = judged(scene, rasterize(scene, closed));
  ASSERT_EQ(result.evidence.size(), 1U);
  EXPECT_FALSE(result.evidence[0].causes.empty());
}

std::vector<PixelPosition> at_pixel(const std::vector<PixelPosition>& pixels, PixelPosition pixel) {
  return std::vector<PixelPosition>(static_cast<std::size_t>(std::ranges::count(pixels, pixel)),
                                    pixel);
}

// What lets one pixel refute an alternative for the whole: with the pixel as its scissor rectangle,
// a point or triangle covers there what it covers without, under every alternative.
TEST(GrossFaults, APixelIsDrawnAloneAsItIsInTheWhole) {
  for (const int samples : {1, 4})
    for (NamedScene named : named_scenes()) {
      named.scene.target.samples = samples;
      const Target& target = named.scene.target;
      const RuleChoices standard = standard_choices();
      for (const ScenePrimitive& primitive : primitives_of(named.scene)) {
        if (primitive.kind == PrimitiveKind::line) continue;
        std::vector<RuleChoices> all{standard};
        for (const Changes& rule : coverage_changes(coverage_traits(primitive, target), standard))
          for (const Change& change : rule) all.push_back(change.applied_to(standard));
        for (const RuleChoices& choices : all) {
          const CoverageChoice& choice = choices.of(primitive.kind);
          const SampleCoverage whole = covered_samples(primitive, target, choice, {});
          for (const PixelPosition pixel :
               {PixelPosition{4, 4}, {7, 8}, {8, 6}, {3, 10}, {11, 5}}) {
            Draw state = *primitive.state;
            state.scissor = Viewport{pixel.x, pixel.y, 1, 1};
            ScenePrimitive alone = primitive;
            alone.state = &state;
            const SampleCoverage there = covered_samples(alone, target, choice, {});
            for (std::size_t s = 0; s < whole.size(); ++s)
              EXPECT_EQ(there[s], at_pixel(whole[s], pixel)) << named.name;
          }
        }
      }
    }
}

TEST(Patience, EndsAComparison) {
  const Scene scene = two_triangles(1);
  const Rendering exact = rasterize(scene, Policy{});
  const Rendering blank = without_fragments(exact);
  {
    const Patience none(nullptr, std::chrono::milliseconds(-1));
    EXPECT_THROW(judged(scene, blank), ComparisonTooLong);
  }
  {
    const std::atomic<bool> stop = true;
    const Patience told(&stop, std::chrono::hours(1));
    EXPECT_THROW(judged(scene, blank), ComparisonStopped);
  }
  EXPECT_NO_THROW(judged(scene, blank));
}

}  // namespace
}  // namespace edgecase
