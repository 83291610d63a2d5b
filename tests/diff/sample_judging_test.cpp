// SPDX-License-Identifier: MIT
//
// Renderers that multisample otherwise than they say: each is convicted of exactly that. A renderer
// here is the exact side under another policy, which reports the standard positions all the same.
#include <gtest/gtest.h>

#include <algorithm>

#include "raster/rasterizer.h"
#include "tests/diff/sample_judging.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/rules/support.h"

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

// 18.3.1 leaves colours to the implementation; what the Khronos tests would not take is contested.
TEST(SampleJudging, AResolveFarBeyondItsSamplesIsContested) {
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
  EXPECT_EQ(rules_of(beyond), std::set<std::string>{"sample.resolve"});
  ASSERT_EQ(beyond.disagreements.size(), 1u);
  EXPECT_EQ(beyond.disagreements[0].ruling, 51);
}

// Columns of pixels that are covered wholly, each with an alpha of its own, and how many samples of
// four each keeps.
Result with_kept(const std::vector<float>& alphas, const std::vector<int>& kept) {
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
  Rendering rendering = rasterize(scene, {});
  for (const Fragment& f : rendering.fragments) {
    if (f.coverage != 15) continue;
    for (int sample = 0; sample < 4; ++sample)
      rendering.hits[rendering.sample_index(f.x, f.y, sample)] =
          sample < kept[static_cast<std::size_t>(f.x / 2)] ? 1 : 0;
  }
  rendering.sample_pixels.clear();
  rendering.pixels.clear();
  return judged(scene, rendering);
}

std::set<int> rulings_of(const Result& result) {
  std::set<int> rulings;
  for (const Disagreement& d : result.disagreements) rulings.insert(d.ruling);
  return rulings;
}

// 17.3.1: the number of samples has the properties of proportionality of 14.9.3, which are intended
// there.
TEST(SampleJudging, SamplesThatAlphaKeepsAreProportional) {
  const std::vector<float> alphas{0.125F, 0.5F, 0.875F};
  for (const std::vector<int>& kept : {std::vector{0, 2, 3}, std::vector{1, 2, 4}})
    EXPECT_EQ(rulings_of(with_kept(alphas, kept)), std::set<int>{});
  EXPECT_EQ(rulings_of(with_kept(alphas, {1, 1, 4})), std::set<int>{52});
  EXPECT_EQ(rulings_of(with_kept(alphas, {4, 4, 4})), std::set<int>{52});
  // Numbers that fall as alpha grows have nothing of it.
  EXPECT_EQ(rulings_of(with_kept(alphas, {4, 2, 0})), std::set<int>{33});
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
      std::ranges::find(result.disagreements, "triangle.shared-edge", &Disagreement::rule);
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
    // Samples elsewhere in and round the pixels would be covered so (ruling 47).
    EXPECT_EQ(result.verdict, Verdict::contested) << other;
    expect_cause(result, "line.multisampled=" + std::string(other));
  }
}

// A slope along x and y, drawn without GL_MULTISAMPLE, or with it.
Scene sloped(bool multisampled) {
  const auto at = [](int x, int y) {
    return Point{Fixed::from_integer(x), Fixed::from_integer(y)};
  };
  Scene scene = multisampled_scene(8, 4, Primitive::triangles, {at(1, 1), at(7, 1), at(1, 7)});
  scene.target.depth = DepthFormat::depth32f;
  scene.draws.front().multisampling.enabled = multisampled;
  const int heights[] = {-3, 1, 2};
  for (std::size_t i = 0; i < 3; ++i)
    scene.draws.front().vertices[i].z = Fixed::from_raw(heights[i] * Fixed::kOne / 4);
  return scene;
}

// The window depth of `sloped` at a place.
double depth_at(double x, double y) {
  const double z = -0.75 + (x - 1) / 6 + (y - 1) * 1.25 / 6;
  return (z + 1) / 2;
}

// 14.3.1 and 17.3.10: without GL_MULTISAMPLE depths may be those of single-sample rasterization, of
// multisample rasterization, or all that of one sample.
TEST(SampleJudging, DepthsWithoutMultisamplingAreOfOneOfThreeKinds) {
  const Scene scene = sloped(false);
  const Rendering exact = rasterize(scene, {});
  const SamplePositions& positions = exact.sample_positions;
  const std::size_t count = positions.size();
  // Of sample s of each pixel as at the place that `place_of` says; -1 is the centre.
  const auto verdict_of = [&](auto place_of) {
    Rendering rendered = exact;
    for (const Fragment& f : exact.fragments)
      for (std::size_t s = 0; s < count; ++s) {
        const auto [dx, dy] = place_of(s);
        rendered.depths[rendered.sample_index(f.x, f.y, static_cast<int>(s))] =
            static_cast<double>(static_cast<float>(depth_at(f.x + dx, f.y + dy)));
      }
    return judged(scene, rendered).verdict;
  };
  const auto place = [&](std::size_t s) {
    return std::pair{positions[s].x.to_double(), positions[s].y.to_double()};
  };
  EXPECT_LE(verdict_of([](std::size_t) { return std::pair{0.5, 0.5}; }), Verdict::permitted);
  EXPECT_EQ(verdict_of(place), Verdict::permitted);
  for (std::size_t one = 0; one < count; ++one)
    EXPECT_EQ(verdict_of([&](std::size_t) { return place(one); }), Verdict::permitted);
  // Each that of another sample; two of one and two of another; elsewhere in the pixel.
  EXPECT_EQ(verdict_of([&](std::size_t s) { return place((s + 1) % count); }), Verdict::violation);
  EXPECT_EQ(verdict_of([&](std::size_t s) { return place(s / 2); }), Verdict::violation);
  EXPECT_EQ(verdict_of([](std::size_t) { return std::pair{0.5, 0.75}; }), Verdict::violation);
}

TEST(SampleJudging, ValuesWithoutMultisamplingMayBeOfAnyPlaceInThePixel) {
  Scene scene = sloped(false);
  scene.target.depth = DepthFormat::none;
  scene.details.coordinates = true;
  scene.draws.front().interpolation = Interpolation::smooth;
  scene.draws.front().multisampling.location = AttributeLocation::centroid;
  for (std::size_t i = 0; i < 3; ++i)
    scene.draws.front().vertices[i].color = {i == 1 ? 1.0F : 0.0F, 0, 0, 1};
  const Rendering exact = rasterize(scene, {});
  const auto verdict_off_by = [&](double pixels) {
    Rendering rendered = exact;
    rendered.pixels.clear();
    rendered.sample_pixels.clear();
    for (Fragment& f : rendered.fragments) f.color[0] += pixels / 6;
    for (FragmentDetail& detail : rendered.details) {
      detail.coordinates[0] += pixels;
      detail.coordinates[2] += pixels / 12;
    }
    for (Fragment& f : rendered.fragments) f.depth += pixels / 12;
    return judged(scene, rendered).verdict;
  };
  EXPECT_EQ(verdict_off_by(0), Verdict::agree);
  EXPECT_EQ(verdict_off_by(0.49), Verdict::permitted);
  EXPECT_EQ(verdict_off_by(-0.49), Verdict::permitted);
  EXPECT_EQ(verdict_off_by(0.52), Verdict::violation);
}

// `centroid` does not concern gl_FragCoord (GLSL 4.60, 7.1.5): z is that of any place in the pixel,
// that of the centre above all, where the primitive does not cover it.
TEST(SampleJudging, FragCoordIsNotOfTheCentroid) {
  Scene scene = sloped(true);
  scene.target.depth = DepthFormat::none;
  scene.details.coordinates = true;
  scene.draws.front().interpolation = Interpolation::smooth;
  scene.draws.front().multisampling.location = AttributeLocation::centroid;
  const Rendering exact = rasterize(scene, {});
  EXPECT_EQ(judged(scene, exact).verdict, Verdict::agree);
  const auto partly = std::ranges::find_if(
      exact.fragments, [](const Fragment& f) { return f.coverage != 15 && f.coverage != 0; });
  ASSERT_NE(partly, exact.fragments.end());
  const auto place = static_cast<std::size_t>(partly - exact.fragments.begin());
  const auto verdict_at = [&](double x, double y) {
    Rendering rendered = exact;
    Fragment& f = rendered.fragments[place];
    f.depth = depth_at(f.x + x, f.y + y);
    rendered.details[static_cast<std::size_t>(f.detail)].coordinates[2] = f.depth;
    return judged(scene, rendered).verdict;
  };
  for (const double x : {0.01, 0.25, 0.75, 0.99})
    for (const double y : {0.01, 0.5, 0.99}) EXPECT_EQ(verdict_at(x, y), Verdict::permitted);
  EXPECT_EQ(verdict_at(1.02, 1.02), Verdict::violation);
  EXPECT_EQ(verdict_at(-0.02, -0.02), Verdict::violation);
}

// Where the points lie by which samples are covered is not told: what some place in or around the
// pixel explains breaks ruling 47 alone.
TEST(SampleJudging, CoverageElsewhereThanReportedBreaksARulingOfItsOwn) {
  const Scene scene = partly_covered();
  const Result moved = judged(scene, rendered_with(scene, "sample.positions", "mirrored-x"));
  ASSERT_FALSE(moved.disagreements.empty());
  for (const Disagreement& d : moved.disagreements)
    if (d.kind != DisagreementKind::value && !is_legal(d)) {
      EXPECT_EQ(d.ruling, 47) << d.explanation;
    }
  // A sample in the midst of a large triangle is covered wherever it lies, and one far away is not.
  const auto at = [](int x, int y) {
    return Point{Fixed::from_integer(x), Fixed::from_integer(y)};
  };
  const Scene large =
      multisampled_scene(12, 4, Primitive::triangles, {at(0, 0), at(12, 0), at(0, 12)});
  Rendering rendered = rasterize(large, {});
  for (Fragment& f : rendered.fragments)
    if (f.x == 2 && f.y == 2) f.coverage = 7;
  for (Fragment& f : rendered.fragments)
    if (f.x == 2 && f.y == 0) f.coverage = 7;
  Fragment far = rendered.fragments.back();
  far.x = far.y = 10;
  far.coverage = 1;
  rendered.fragments.push_back(far);
  const Result result = judged(large, rendered);
  for (const Disagreement& d : result.disagreements)
    if (d.kind != DisagreementKind::value) {
      EXPECT_EQ(d.ruling, d.x == 2 && d.y == 0 ? 47 : 4) << d.explanation;
      EXPECT_FALSE(is_legal(d));
    }
  EXPECT_GE(result.disagreements.size(), 3U);
}

}  // namespace
}  // namespace edgecase
