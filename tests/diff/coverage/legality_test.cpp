// SPDX-License-Identifier: MIT
//
// What legality is computed from: the bits that count, what lines tell.
#include "diff/coverage/legality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "diff/compare.h"
#include "diff/coverage/coverage_diff.h"
#include "diff/coverage/size_latitude.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

TEST(LatitudeBits, AreAtLeastFourAndNoFinerThanCoordinates) {
  EXPECT_EQ(latitude_bits(-1), 4);
  EXPECT_EQ(latitude_bits(0), 4);
  EXPECT_EQ(latitude_bits(4), 4);
  EXPECT_EQ(latitude_bits(8), 8);
  EXPECT_EQ(latitude_bits(16), 16);
  EXPECT_EQ(latitude_bits(24), 16);
}

// The same rendering is a violation of a renderer that reports 8 bits, and not of one that reports
// 4: snapping to 4 bits is what the latter announced.
TEST(LatitudeBits, DecideWhetherACoarseSnapIsAViolation) {
  const Scene& scene = scene_named("triangles off the grid");
  Policy coarse;
  coarse.rules["subpixel.snap"] = "4-half-even";
  const Rendering rendered = rasterize(scene, coarse);
  EXPECT_EQ(judged(scene, rendered).verdict, Verdict::violation);
  EXPECT_EQ(judged(scene, rendered, {}, 4).verdict, Verdict::convention);
}

// What judge() needs of a line, and what clusters and reports tell: the snaps under which some
// ruling on lines fails, the first clause that is broken, where on the line each pixel lies.
TEST(LinesInAComparison, TellTheirSnapsTheirFirstClauseAndPlaces) {
  const Scene& scene = scene_named("strip x-major");
  const Rendering exact = rasterize(scene, {});
  const auto compared = [&](const Rendering& drawn) {
    return compare(scene, {}, exact, drawn, {8});
  };
  const auto is_illegal_as_given = [](const Result& result) {
    const auto& snaps = result.illegal_line_snaps;
    return std::find(snaps.begin(), snaps.end(), "none") != snaps.end();
  };
  EXPECT_TRUE(compared(exact).illegal_line_snaps.empty());
  // Twice at the joint: legal line by line.
  Rendering doubled = exact;
  doubled.fragments.push_back(fragment_at(scene, 0, 8, 6));
  const Result joint = compared(compose(scene, doubled.fragments));
  EXPECT_TRUE(is_illegal_as_given(joint));
  ASSERT_EQ(joint.disagreements.size(), 1u);
  EXPECT_EQ(joint.disagreements[0].rule, "line.joint");
  EXPECT_EQ(joint.disagreements[0].situation,
            "line, x-major right and up, last pixel, end at the centre of its diamond");
  // A stray far away breaks ruling 1; the joint, doubled too, comes after it.
  doubled.fragments.push_back(fragment_at(scene, 0, 1, 14));
  const Result both = compared(compose(scene, doubled.fragments));
  EXPECT_TRUE(is_illegal_as_given(both));
  for (const Disagreement& d : both.disagreements) EXPECT_EQ(d.rule, "line.diamond-exit");
  ASSERT_EQ(both.evidence.size(), 1u);
  EXPECT_EQ(both.evidence[0].broken_clause,
            "pixel (1, 14) has no diamond-exit fragment within one unit");
  // Ruling 1 alone.
  Rendering stray = exact;
  stray.fragments.push_back(fragment_at(scene, 1, 1, 14));
  EXPECT_TRUE(is_illegal_as_given(compared(compose(scene, stray.fragments))));
}

// A wide line as wide as a number of pixels, whatever its own width.
Result judged_as_wide(double width, double drawn) {
  Scene scene = scene_named("strip x-major");
  scene.draws.resize(1);
  Draw& draw = scene.draws.front();
  draw.primitive = Primitive::lines;
  draw.vertices.resize(2);
  const auto set_width = [&](double pixels) {
    draw.line_width = Fixed::from_raw(static_cast<std::int64_t>(pixels * Fixed::kOne));
  };
  set_width(drawn);
  const Rendering rendered = rasterize(scene, {});
  set_width(width);
  return judged(scene, rendered);
}

// The text has no rule for ties of widths; what is less than the nearest integer breaks a ruling of
// its own.
TEST(WidthsOfLines, ATieIsRoundedEitherWay) {
  for (const double drawn : {2.0, 3.0})
    EXPECT_LE(judged_as_wide(2.5, drawn).verdict, Verdict::permitted) << drawn;
  for (const double drawn : {1.0, 4.0})
    EXPECT_EQ(judged_as_wide(2.5, drawn).verdict, Verdict::violation) << drawn;
  const auto rulings = [](const Result& result) {
    std::set<int> numbers;
    for (const Disagreement& d : result.disagreements)
      if (!is_legal(d) && d.kind != DisagreementKind::value) numbers.insert(d.ruling);
    return numbers;
  };
  EXPECT_EQ(rulings(judged_as_wide(2.75, 2)), std::set<int>{56});
  EXPECT_EQ(rulings(judged_as_wide(2.25, 3)), std::set<int>{12});
}

// 14.4.1: a size that is not supported becomes the nearest that is.
TEST(SupportedSizes, AreAskedFor) {
  const auto raw = [](double size) {
    return Fixed::from_raw(static_cast<std::int64_t>(size * Fixed::kOne));
  };
  const auto supported = [](std::map<std::string, std::string> traits) {
    RendererInfo info;
    info.traits = std::move(traits);
    return claims_of(info).sizes;
  };
  const SupportedSizes reported =
      supported({{"point_size_steps", "1 by 0.5"}, {"sampled_line_width_steps", "nonsense"}});
  EXPECT_EQ(reported.points.step, 0.5);
  EXPECT_EQ(reported.lines.step, 0);
  const auto range = [&](double size, const SizeSteps& steps) {
    const SizeRange sizes = permitted_sizes(raw(size), steps);
    return std::pair{sizes.low.to_double(), sizes.high.to_double()};
  };
  EXPECT_EQ(range(2.5, reported.points), (std::pair{2.5, 2.5}));
  EXPECT_EQ(range(2.25, reported.points), (std::pair{2.0, 2.5}));
  EXPECT_EQ(range(0.125, reported.points), (std::pair{1.0 / Fixed::kOne, 1.0}));
  EXPECT_EQ(range(2.25, reported.lines), (std::pair{2.25, 2.25}));
  EXPECT_EQ(range(1, SizeSteps{0.3, 0.7}), (std::pair{1.0, 1.0})) << "1 must be supported";

  // A point of size 3.5 drawn as one of 3 or 4 by a renderer whose sizes are whole numbers.
  const auto verdict = [&](double drawn, const SupportedSizes& sizes) {
    Scene scene = scene_named("strip x-major");
    scene.draws.resize(1);
    Draw& draw = scene.draws.front();
    draw.primitive = Primitive::points;
    draw.vertices.resize(1);
    draw.vertices[0].position = {raw(7.375), raw(7.375)};
    draw.point_size = raw(drawn);
    const Rendering rendered = rasterize(scene, {});
    draw.point_size = raw(3.5);
    const Rendering exact = rasterize(scene, {});
    Result result = compare(scene, {}, exact, rendered, {8, nullptr, sizes});
    Result* const only = &result;
    judge({&only, 1}, Latitude::opengl);
    return result.verdict;
  };
  const SupportedSizes whole = supported({{"point_size_steps", "1 by 1"}});
  for (const double drawn : {3.0, 4.0}) EXPECT_LE(verdict(drawn, whole), Verdict::permitted);
  EXPECT_EQ(verdict(4, {}), Verdict::violation);
  EXPECT_EQ(verdict(5.5, whole), Verdict::violation);
  EXPECT_EQ(verdict(4, supported({{"point_size_steps", "1 by 0.5"}})), Verdict::violation);
}

// Whoever claims steps of 1,000 has no size but 1 near 2.5, and others only if they are as near.
TEST(SupportedSizes, ExcuseNoMoreThanTheNearest) {
  const auto raw = [](double size) {
    return Fixed::from_raw(static_cast<std::int64_t>(size * Fixed::kOne));
  };
  const auto range = [&](double size, const char* steps) {
    RendererInfo info;
    info.traits["point_size_steps"] = steps;
    const SizeRange sizes = permitted_sizes(raw(size), claims_of(info).sizes.points);
    return std::pair{sizes.low.to_double(), sizes.high.to_double()};
  };
  EXPECT_EQ(range(2.5, "1 by 1000"), (std::pair{1.0, 4.0}));
  EXPECT_EQ(range(2.5, "0.5 by 8.5"), (std::pair{1.0, 4.0})) << "1 is supported, too";
  EXPECT_EQ(range(8, "1 by 8"), (std::pair{7.0, 9.0}));
  EXPECT_EQ(range(0.5, "0 by 2"), (std::pair{1.0 / Fixed::kOne, 1.0}));
  for (const char* none : {"9 by 9", "1 by 0", "1 by -1", "-1 by 3", "nan by 1", "1 by inf",
                           "1 by 3 or so", "1 by", "", "1 by 1e-300"})
    EXPECT_EQ(range(2.5, none), (std::pair{2.5, 2.5})) << none;
}

// All samples of a point have one size: one side by the size 1 and another by 4 is neither.
TEST(SupportedSizes, AreOneForAPoint) {
  Scene scene = scene_named("strip x-major");
  scene.draws.resize(1);
  Draw& draw = scene.draws.front();
  draw.primitive = Primitive::points;
  draw.vertices.resize(1);
  draw.vertices[0].position = pixel_centre(7, 7);
  const auto of_size = [&](int size) {
    draw.point_size = Fixed::from_integer(size);
    return rasterize(scene, {});
  };
  const Rendering small = of_size(3);
  const Rendering large = of_size(7);
  Rendering ragged = small;
  for (const Fragment& f : large.fragments)
    if (f.x > 8 && f.y >= 6 && f.y <= 8) ragged.fragments.push_back(f);
  std::ranges::sort(ragged.fragments, {}, [](const Fragment& f) { return std::pair(f.y, f.x); });
  const Rendering exact = of_size(5);
  const auto is_legally_covered = [&](const Rendering& rendered) {
    const Result result = compare(scene, {}, exact, rendered, {8, nullptr, {{1, 6}, {}}});
    return std::ranges::all_of(result.disagreements, [](const Disagreement& d) {
      return d.kind == DisagreementKind::value || is_legal(d);
    });
  };
  EXPECT_TRUE(is_legally_covered(small)) << "a size that may be supported and is as near as 7";
  EXPECT_TRUE(is_legally_covered(large));
  EXPECT_FALSE(is_legally_covered(ragged));
}

// 14.5.2.2: the fragments of a column share what the line has in its middle, or each has its own:
// along this line, of width 5, the parameter grows by 1/25 from row to row, and no fragment lies
// more than two rows from the middle.
TEST(WidthsOfLines, ValuesAreThoseOfTheMiddleOfTheColumnOrTheirOwn) {
  const auto at = [](double x, double y) {
    return Point{Fixed::from_raw(static_cast<std::int64_t>(x * Fixed::kOne)),
                 Fixed::from_raw(static_cast<std::int64_t>(y * Fixed::kOne))};
  };
  Scene scene = scene_named("strip x-major");
  scene.target.depth = DepthFormat::none;
  scene.draws.resize(1);
  Draw& draw = scene.draws.front();
  draw.primitive = Primitive::lines;
  draw.interpolation = Interpolation::smooth;
  draw.line_width = Fixed::from_integer(5);
  draw.vertices.resize(2);
  draw.vertices[0].position = at(2.5, 4.5);
  draw.vertices[1].position = at(12.5, 9.5);
  draw.vertices[0].color = {0, 0, 0, 1};
  draw.vertices[1].color = {1, 0, 0, 1};
  const Rendering exact = rasterize(scene, {});
  const auto verdict_of = [&](double rows) {
    Rendering rendered = exact;
    rendered.pixels.clear();
    for (Fragment& f : rendered.fragments)
      f.color[0] = (10 * (f.x - 2) + 5 * (f.y - 4)) / 125.0 + rows / 25;
    return judged(scene, rendered).verdict;
  };
  for (const double rows : {-1.99, -1.0, 0.0, 1.0, 1.99})
    EXPECT_EQ(verdict_of(rows), Verdict::permitted) << rows;
  // Up to the whole height of the column the ruling is contested.
  for (const double rows : {-3.9, -2.2, 2.2, 3.9})
    EXPECT_EQ(verdict_of(rows), Verdict::contested) << rows;
  for (const double rows : {-4.2, 4.2}) EXPECT_EQ(verdict_of(rows), Verdict::violation) << rows;
}

}  // namespace
}  // namespace edgecase
