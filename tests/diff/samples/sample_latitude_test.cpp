// SPDX-License-Identifier: MIT
//
// Where samples have depths, values and coverage by the specification's leave: without
// GL_MULTISAMPLE, of gl_FragCoord, and at places other than are reported.
#include <gtest/gtest.h>

#include "raster/rasterizer.h"
#include "tests/diff/samples/sample_judging.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

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
      detail.coordinates.value()[0] += pixels;
      detail.coordinates.value()[2] += pixels / 12;
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
    rendered.details[static_cast<std::size_t>(f.detail)].coordinates.value()[2] = f.depth;
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
    if (f.x == 2 && f.y == 0) f.coverage = 7;
  const Result beside_an_edge = judged(large, rendered);
  for (const Disagreement& d : beside_an_edge.disagreements)
    if (d.kind != DisagreementKind::value) {
      EXPECT_EQ(d.ruling, 47) << d.explanation;
    }
  // Nor does any place explain the one beside the edge, once another pixel forbids all of them.
  for (Fragment& f : rendered.fragments)
    if (f.x == 2 && f.y == 2) f.coverage = 7;
  Fragment far = rendered.fragments.back();
  far.x = far.y = 10;
  far.coverage = 1;
  rendered.fragments.push_back(far);
  const Result result = judged(large, rendered);
  for (const Disagreement& d : result.disagreements)
    if (d.kind != DisagreementKind::value) {
      EXPECT_EQ(d.ruling, 4) << d.explanation;
      EXPECT_FALSE(is_legal(d));
    }
  EXPECT_GE(result.disagreements.size(), 3U);
}

// Four samples, each with an invocation of its own by a share of 1; the depth is x/8.
Scene share_of_one() {
  Scene scene = multisampled_scene(8, 4, Primitive::triangles, {at(0, 0), at(8, 0), at(0, 8)});
  scene.details.coordinates = true;
  Draw& draw = scene.draws.front();
  draw.multisampling.min_sample_shading = 1;
  for (Vertex& vertex : draw.vertices)
    vertex.z = Fixed::from_integer(vertex.position.x == Fixed() ? -1 : 1);
  return scene;
}

// gl_FragCoord of the pixel's centre instead of the sample: x and y, or z, or both.
Rendering with_centre(const Scene& scene, bool xy, bool z) {
  Rendering rendering = rasterize(scene, {});
  for (Fragment& f : rendering.fragments) {
    auto& coordinates = *rendering.details[static_cast<std::size_t>(f.detail)].coordinates;
    if (xy) coordinates[0] = f.x + 0.5;
    if (xy) coordinates[1] = f.y + 0.5;
    if (!z) continue;
    f.depth = (f.x + 0.5) / 8;
    coordinates[2] = f.depth;
  }
  return rendering;
}

// GLSL 4.60, 7.1.5, has gl_FragCoord be "for any location within the pixel", 14.3.1.1 has it be at
// the sample. A depth that is at neither place is at fault.
TEST(SampleLatitude, CoordinatesOfAnotherPlaceAreContestedWithAShareOfOne) {
  const Scene scene = share_of_one();
  EXPECT_EQ(judged(scene, with_centre(scene, false, false)).verdict, Verdict::agree);
  for (const bool z : {false, true}) {
    const Result result = judged(scene, with_centre(scene, true, z));
    EXPECT_EQ(result.verdict, Verdict::contested);
    EXPECT_EQ(broken_rulings(result), std::set<int>{63});
  }
  EXPECT_EQ(judged(scene, with_centre(scene, false, true)).verdict, Verdict::violation);
  Rendering beyond = with_centre(scene, true, true);
  (*beyond.details.front().coordinates)[0] += 1;
  EXPECT_EQ(judged(scene, beyond).verdict, Verdict::violation);
  // With any other share the place is open.
  Scene half = scene;
  half.draws.front().multisampling.min_sample_shading = 0.75F;
  EXPECT_EQ(judged(half, with_centre(half, true, true)).verdict, Verdict::permitted);
}

}  // namespace
}  // namespace edgecase
