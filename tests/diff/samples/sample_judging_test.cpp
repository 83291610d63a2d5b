// SPDX-License-Identifier: MIT
//
// Renderers that multisample otherwise than they say: each is convicted of exactly that. A renderer
// here is the exact side under another policy, which reports the standard positions all the same.
#include <gtest/gtest.h>

#include <algorithm>

#include "raster/rasterizer.h"
#include "tests/diff/samples/sample_judging.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/support/causes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

// Of every sample that is missing or extra.
void expect_cause(const Result& result, const std::string& cause) {
  for (const Disagreement& d : result.disagreements) {
    if (d.kind == DisagreementKind::value) continue;
    EXPECT_EQ(d.cause, cause) << d.explanation;
  }
}

TEST(SampleJudging, ExactAgreesWithItself) {
  for (const int samples : {2, 4, 8, 16}) {
    const Scene scene = partly_covered(samples);
    const Result result = judged(scene, rasterize(scene, {}));
    EXPECT_EQ(result.verdict, Verdict::agree) << samples;
    EXPECT_TRUE(result.disagreements.empty());
  }
}

TEST(SampleJudging, OtherPositionsAreNoFaultWhereTheyAreReported) {
  const Scene scene = partly_covered();
  const SamplePositions mirrored =
      rasterize(scene, policy_with("sample.positions", "mirrored-y")).sample_positions;
  EXPECT_EQ(judged(scene, rasterize(scene, {}, mirrored)).verdict, Verdict::agree);
}

TEST(SampleJudging, PositionsOtherThanReportedAreContested) {
  for (const char* placement : {"swapped", "mirrored-x", "mirrored-y", "turned", "centre"}) {
    for (const int samples : {4, 8, 16}) {
      const Scene scene = partly_covered(samples);
      const Result result = judged(scene, rendered_with(scene, "sample.positions", placement));
      EXPECT_EQ(result.verdict, Verdict::contested) << placement << samples;
      expect_cause(result, "sample.positions=" + std::string(placement));
    }
  }
}

TEST(SampleJudging, ASwappedPairIsFoundWhicheverItIs) {
  const Scene scene = partly_covered(8);
  const SamplePositions standard = rasterize(scene, {}).sample_positions;
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t j = i + 1; j < 8; ++j) {
      SamplePositions swapped = standard;
      std::swap(swapped[i], swapped[j]);
      Rendering rendering = rasterize(scene, {}, swapped);
      rendering.sample_positions = standard;
      const Result result = judged(scene, rendering);
      EXPECT_EQ(result.verdict, Verdict::contested) << i << j;
      expect_cause(result, "sample.positions=swapped");
    }
  }
}

TEST(SampleJudging, AResolveThatTruncatesIsAConvention) {
  const Scene scene = partly_covered();
  const Result result = judged(scene, rendered_with(scene, "sample.resolve", "truncated"));
  EXPECT_EQ(result.verdict, Verdict::convention);
  EXPECT_EQ(causes_of(result), std::set<std::string>{"sample.resolve=truncated"});
}

// 18.3.1 leaves the method to the implementation, and the Khronos tests accept 12 codes: no more.
TEST(SampleJudging, AResolveFarBeyondItsSamplesIsAViolation) {
  const Scene scene = partly_covered();
  const Rendering exact = rasterize(scene, {});
  // A pixel that nothing covers holds the clear colour in all samples, and so do its neighbours.
  ASSERT_EQ(exact.pixels[0], exact.sample_pixels[0]);
  const auto resolved_to = [&](int code) {
    Rendering rendering = exact;
    rendering.pixels[0] = static_cast<std::uint8_t>(exact.pixels[0] + code);
    return judged(scene, rendering);
  };
  EXPECT_EQ(resolved_to(12).verdict, Verdict::permitted);
  const Result beyond = resolved_to(13);
  EXPECT_EQ(beyond.verdict, Verdict::violation);
  EXPECT_EQ(rules_of(beyond), std::set<std::string>{"sample.resolve"});
  ASSERT_EQ(beyond.disagreements.size(), 1u);
  EXPECT_EQ(beyond.disagreements[0].ruling, 51);
}

// Whatever a renderer tells of its samples: a picture that is black, white or inverted.
TEST(SampleJudging, AResolvedPictureOfOtherColoursIsAViolation) {
  const Scene scene = partly_covered();
  const Rendering exact = rasterize(scene, {});
  const auto with = [&](const auto& code_of, bool tells_samples) {
    Rendering rendering = exact;
    std::ranges::transform(rendering.pixels, rendering.pixels.begin(), code_of);
    if (!tells_samples) rendering.sample_pixels.clear();
    return judged(scene, rendering).verdict;
  };
  for (const bool tells_samples : {true, false}) {
    const auto constant = [](int code) {
      return [code](std::uint8_t) { return static_cast<std::uint8_t>(code); };
    };
    EXPECT_EQ(with(constant(0), tells_samples), Verdict::violation);
    EXPECT_EQ(with(constant(255), tells_samples), Verdict::violation);
    EXPECT_EQ(with([](std::uint8_t code) { return static_cast<std::uint8_t>(255 - code); },
                   tells_samples),
              Verdict::violation);
  }
}

// Where a case leaves the places to the renderer, two samples at one place give fewer shades along
// edges than the Khronos tests want. Whoever tells such places, and draws so, is contested.
TEST(SampleJudging, SamplesThatShareAPlaceAreContested) {
  Scene scene = partly_covered();
  SamplePositions shared = standard_pattern(scene.target.samples);
  shared[2] = shared[0];
  const Result result = judged(scene, rasterize(scene, {}, shared));
  EXPECT_EQ(result.verdict, Verdict::contested);
  ASSERT_EQ(result.disagreements.size(), 1u);
  EXPECT_EQ(result.disagreements[0].ruling, 62);
  EXPECT_EQ(result.disagreements[0].sample, 2);
  scene.target.sample_positions = shared;
  EXPECT_EQ(judged(scene, rasterize(scene, {}, shared)).verdict, Verdict::agree);
}

// Squares of 2x2 pixels of four samples, each with an alpha of its own. Of each square the pixels
// on the diagonal are covered by one fragment as a whole.
Scene squares_with(const std::vector<float>& alphas) {
  Scene scene = multisampled_scene(8, 4, Primitive::triangles, {});
  scene.draws.clear();
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    const auto x = static_cast<double>(2 * i);
    Draw draw =
        multisampled_scene(8, 4, Primitive::triangles,
                           {at(x, 0), at(x + 2, 0), at(x, 2), at(x + 2, 0), at(x + 2, 2), at(x, 2)})
            .draws.front();
    draw.interpolation = Interpolation::smooth;
    draw.multisampling.alpha_to_coverage = true;
    for (Vertex& vertex : draw.vertices) vertex.color = {1, 1, 1, alphas[i]};
    scene.draws.push_back(draw);
  }
  return scene;
}

// A renderer that tells how often samples were written, of which each square keeps so many.
Rendering kept_of(const Scene& scene, const std::vector<int>& kept) {
  Rendering rendering = rasterize(scene, {});
  for (const Fragment& f : rendering.fragments) {
    if (f.coverage != 15) continue;
    for (int sample = 0; sample < 4; ++sample)
      rendering.hits[rendering.sample_index(f.x, f.y, sample)] =
          sample < kept[static_cast<std::size_t>(f.x / 2)] ? 1 : 0;
  }
  rendering.sample_pixels.clear();
  rendering.pixels.clear();
  return rendering;
}

Result with_kept(const std::vector<float>& alphas, const std::vector<int>& kept) {
  const Scene scene = squares_with(alphas);
  return judged(scene, kept_of(scene, kept));
}

// 17.3.1: the number of samples has the properties of proportionality of 14.9.3, which are intended
// there.
TEST(SampleJudging, SamplesThatAlphaKeepsAreProportional) {
  const std::vector<float> alphas{0.125F, 0.5F, 0.875F};
  for (const std::vector<int>& kept : {std::vector{0, 2, 3}, std::vector{1, 2, 4}})
    EXPECT_EQ(rulings_of(with_kept(alphas, kept)), std::set<int>{});
  EXPECT_EQ(rulings_of(with_kept(alphas, {4, 4, 4})), std::set<int>{52});
  // 14.9.3: another pixel may have other thresholds, and so fewer samples for a larger alpha.
  EXPECT_EQ(rulings_of(with_kept(alphas, {1, 1, 4})), std::set<int>{});
  EXPECT_EQ(rulings_of(with_kept(alphas, {2, 1, 4})), std::set<int>{});
  // Numbers that fall steeply as alpha grows have nothing of it.
  EXPECT_EQ(rulings_of(with_kept(alphas, {4, 2, 0})), std::set<int>{33});
}

// The pixel's other samples are not counted for its neighbour, or for no pixel at all.
TEST(SampleJudging, OneHitTooManyIsToldOfItsSampleAlone) {
  const Scene scene = squares_with({0.5F});
  for (const PixelPosition pixel : {PixelPosition{0, 0}, {1, 1}}) {
    Rendering rendering = kept_of(scene, {2});
    for (int sample = 0; sample < 4; ++sample)
      rendering.hits[rendering.sample_index(pixel.x, pixel.y, sample)] = sample == 0 ? 2 : 1;
    const Result result = judged(scene, rendering);
    ASSERT_EQ(result.disagreements.size(), 1u);
    const Disagreement& d = result.disagreements.front();
    EXPECT_EQ((PixelPosition{d.x, d.y}), pixel);
    EXPECT_EQ(d.sample, 0);
    EXPECT_EQ(d.rendered, std::vector<double>{2});
  }
}

TEST(SampleJudging, ACentroidAtTheCentreIsAViolation) {
  Scene scene = partly_covered();
  scene.draws.front().multisampling.location = AttributeLocation::centroid;
  const Result result = judged(scene, rendered_with(scene, "attribute.centroid", "centre"));
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_TRUE(rules_of(result).contains("attribute.centroid"));
  for (const Disagreement& d : result.disagreements)
    EXPECT_EQ(d.cause, "attribute.centroid=centre") << d.explanation;
}

TEST(SampleJudging, AnOpenPlaceOfAttributesIsAConvention) {
  Scene scene = partly_covered();
  Result result = judged(scene, rendered_with(scene, "attribute.location", "first-covered"));
  EXPECT_EQ(result.verdict, Verdict::convention);
  EXPECT_EQ(causes_of(result), std::set<std::string>{"attribute.location=first-covered"});
  scene.draws.front().multisampling.location = AttributeLocation::centroid;
  result = judged(scene, rendered_with(scene, "attribute.centroid", "first-covered"));
  EXPECT_EQ(result.verdict, Verdict::convention);
  EXPECT_EQ(causes_of(result), std::set<std::string>{"attribute.centroid=first-covered"});
}

TEST(SampleJudging, DepthsEvaluatedElsewhereAreViolations) {
  Scene scene = partly_covered();
  scene.target.depth = DepthFormat::depth32f;
  const std::int64_t heights[] = {-50000, 20000, 60000};
  for (std::size_t i = 0; i < scene.draws.front().vertices.size(); ++i)
    scene.draws.front().vertices[i].z = Fixed::from_raw(heights[i % 3]);
  EXPECT_EQ(judged(scene, rasterize(scene, {})).verdict, Verdict::agree);
  for (const char* place : {"centre", "mirrored-x"}) {
    const Result result = judged(scene, rendered_with(scene, "sample.depth", place));
    EXPECT_EQ(result.verdict, Verdict::violation) << place;
    for (const Disagreement& d : result.disagreements)
      if (d.rule != "fragment.depth") {
        EXPECT_EQ(d.rule, "sample.depth");
        EXPECT_EQ(d.cause, "sample.depth=" + std::string(place)) << d.explanation;
      }
  }
}

TEST(SampleJudging, AnIgnoredMaskIsAViolation) {
  Scene scene = partly_covered();
  scene.draws.front().multisampling.mask = 0b0101;
  const Result result = judged(scene, rendered_with(scene, "sample.mask", "ignored"));
  EXPECT_EQ(result.verdict, Verdict::violation);
  expect_cause(result, "sample.mask=ignored");
}

TEST(SampleJudging, AnIgnoredSwitchIsAViolation) {
  Scene scene = partly_covered();
  scene.draws.front().multisampling.enabled = false;
  const Result result = judged(scene, rendered_with(scene, "sample.enable", "ignored"));
  EXPECT_EQ(result.verdict, Verdict::violation);
  expect_cause(result, "sample.enable=ignored");
}

TEST(SampleJudging, FewerInvocationsThanAskedForAreAViolation) {
  Scene scene = partly_covered();
  scene.draws.front().multisampling.min_sample_shading = 1;
  const Result result = judged(scene, rendered_with(scene, "sample.shading-rate", "per-pixel"));
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_TRUE(rules_of(result).contains("sample.shading-rate"));
}

TEST(SampleJudging, MoreInvocationsThanAskedForAreAConvention) {
  Scene scene = partly_covered();
  scene.draws.front().interpolation = Interpolation::flat;
  const Result result = judged(scene, rendered_with(scene, "sample.shading-rate", "per-sample"));
  EXPECT_EQ(result.verdict, Verdict::convention);
  EXPECT_EQ(causes_of(result), std::set<std::string>{"sample.shading-rate=per-sample"});
}

TEST(SampleJudging, AlphaToCoverageIsOpenBetweenItsEnds) {
  Scene scene = partly_covered();
  scene.draws.front().multisampling.alpha_to_coverage = true;
  for (const char* choice : {"above-quotient", "spread"}) {
    const Result result = judged(scene, rendered_with(scene, "sample.alpha-to-coverage", choice));
    EXPECT_NE(result.verdict, Verdict::violation) << choice;
  }
  for (Vertex& vertex : scene.draws.front().vertices) vertex.color[3] = 0;
  const Result result = judged(scene, rendered_with(scene, "sample.alpha-to-coverage", "ignored"));
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_TRUE(rules_of(result).contains("sample.alpha-to-coverage"));
}

TEST(SampleJudging, SamplesThatFragmentsDoNotCoverAreSeen) {
  const Scene scene = partly_covered();
  Rendering rendering = rasterize(scene, {});
  // One sample that is covered holds the clear colour, and was not written.
  const auto covered = std::ranges::find_if(rendering.hits, [](auto hits) { return hits == 1; });
  ASSERT_NE(covered, rendering.hits.end());
  const auto place = static_cast<std::size_t>(covered - rendering.hits.begin());
  *covered = 0;
  std::fill_n(rendering.sample_pixels.begin() + static_cast<std::ptrdiff_t>(4 * place), 3, 0);
  rendering.sample_pixels[4 * place + 3] = 255;
  const Result result = judged(scene, rendering);
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_TRUE(rules_of(result).contains("sample.mask"));
}

// Both sides of a square: a sample on the diagonal belongs to one of them.
TEST(SampleJudging, AHoleInASharedEdgeIsAViolation) {
  const auto at = [](int x, int y) {
    return Point{Fixed::from_integer(x), Fixed::from_integer(y)};
  };
  const Scene scene = multisampled_scene(
      8, 2, Primitive::triangles, {at(1, 1), at(7, 1), at(7, 7), at(1, 1), at(7, 7), at(1, 7)});
  const Point on{Fixed::from_raw(Fixed::kOne / 4), Fixed::from_raw(Fixed::kOne / 4)};
  const Point off{Fixed::from_raw(Fixed::kOne / 4), Fixed::from_raw(Fixed::kOne / 2)};
  Rendering rendering = rasterize(scene, {}, {off, on});
  EXPECT_EQ(judged(scene, rendering).verdict, Verdict::agree);
  Fragment& fragment = *std::ranges::find_if(rendering.fragments, [](const Fragment& f) {
    return (f.coverage & 2) != 0 && f.x == 3 && f.y == 3;
  });
  fragment.coverage &= 1;
  const Result result = judged(scene, rendering);
  EXPECT_EQ(result.verdict, Verdict::violation);
  const auto fault =
      std::ranges::find(result.disagreements, RuleId::triangle_shared_edge, &Disagreement::rule);
  ASSERT_NE(fault, result.disagreements.end());
  EXPECT_EQ(fault->sample, 1);
  EXPECT_EQ(fault->x, 3);
}

TEST(SampleJudging, MultisampledLinesAreRectangles) {
  const auto at = [](int x, int y) {
    return Point{Fixed::from_raw(x * 4096), Fixed::from_raw(y * 4096)};
  };
  Scene scene = multisampled_scene(16, 4, Primitive::lines,
                                   {at(20, 30), at(200, 90), at(40, 220), at(120, 40)});
  scene.draws.front().line_width = Fixed::from_raw(5 * Fixed::kOne / 2);
  EXPECT_EQ(judged(scene, rasterize(scene, {})).verdict, Verdict::agree);
  for (const char* other : {"parallelogram", "single-sampled"}) {
    const Result result = judged(scene, rendered_with(scene, "line.multisampled", other));
    // Samples elsewhere in and round the pixels would be covered so, but not one in all of them.
    EXPECT_EQ(result.verdict, Verdict::violation) << other;
    expect_cause(result, "line.multisampled=" + std::string(other));
  }
}

}  // namespace
}  // namespace edgecase
