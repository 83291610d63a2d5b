// SPDX-License-Identifier: MIT
#include "search/minimize.h"
#include "search/shrinking.h"

#include <gmock/gmock.h>

#include "generate/random_scenes.h"
#include "rules/coverage/window.h"
#include "rules/samples/sample_placement.h"
#include "search/scene_size.h"
#include "tests/search/faulty_renderer.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

Signature caused_by(const std::string& cause) {
  Signature signature;
  signature.cause = cause;
  signature.surface = "fbo";
  return signature;
}

Policy snapping_lines(const std::string& snap) {
  Policy policy;
  policy.rules["line.snap"] = snap;
  return policy;
}

Scene thin_line() {
  return scene_with(
      8, {make_draw(Primitive::lines, std::array{sixteenths(8, 8), sixteenths(72, 24)})});
}

// What it all rests on, for every grid and every coordinate of two pixels that lies on it.
TEST(SnapLimit, AGridLeavesWhatIsAsCoarseAsItself) {
  for (const Snap& snap : all_snaps()) {
    const std::int64_t step = Fixed::kOne >> snap.bits;
    for (std::int64_t raw = -Fixed::kOne; raw <= Fixed::kOne; raw += step)
      ASSERT_EQ(snap(Fixed::from_raw(raw)).raw(), raw) << name_of(snap);
    if (snap.is_none()) continue;
    // And moves something of one bit more.
    EXPECT_NE(snap(Fixed::from_raw(3 * step / 2)).raw(), 3 * step / 2) << name_of(snap);
  }
}

TEST(SnapLimit, IsABitMoreThanTheCoarserGridHas) {
  const Scene scene = thin_line();
  const auto least = [&](const std::string& cause, const std::string& policy) {
    return least_fraction_bits(caused_by(cause), snapping_lines(policy), scene);
  };
  EXPECT_EQ(least("line.snap=8-truncate", "none"), 9);
  EXPECT_EQ(least("line.snap=none", "8-half-up"), 9);
  EXPECT_EQ(least("line.snap=8-truncate", "8-half-up"), 9);
  EXPECT_EQ(least("line.snap=12-half-even", "8-half-up"), 9);
  EXPECT_EQ(least("line.snap=4-half-even", "8-half-up"), 5);
  EXPECT_EQ(least("line.algorithm=bresenham + line.snap=11-truncate", "none"), 12);
  EXPECT_EQ(least("line.snap=5-half-up + line.width=replicate", "none"), 6);
  // The policy's default for all primitives counts.
  Policy all;
  all.rules["subpixel.snap"] = "6-half-up";
  EXPECT_EQ(least_fraction_bits(caused_by("line.snap=8-truncate"), all, scene), 7);
}

TEST(SnapLimit, IsTheSameOfWideAndOfMultisampledLines) {
  const Signature snapped = caused_by("line.snap=8-truncate");
  Scene wide = thin_line();
  wide.draws[0].line_width = Fixed::from_integer(3);
  EXPECT_EQ(least_fraction_bits(snapped, snapping_lines("none"), wide), 9);
  wide.target.samples = 4;
  EXPECT_EQ(least_fraction_bits(snapped, snapping_lines("none"), wide), 9);
}

TEST(SnapLimit, IsNotKnownOfOtherCausesAndOtherScenes) {
  const Policy policy = snapping_lines("none");
  const Signature snapped = caused_by("line.snap=8-truncate");
  EXPECT_EQ(least_fraction_bits(caused_by(""), policy, thin_line()), 0);
  EXPECT_EQ(least_fraction_bits(caused_by("line.algorithm=bresenham"), policy, thin_line()), 0);
  Scene shifted = thin_line();
  shifted.supersampling.resize(1);
  EXPECT_EQ(least_fraction_bits(snapped, policy, shifted), 0);
  Scene clipped = thin_line();
  clipped.draws[0].vertices[1].clip.emplace();
  EXPECT_EQ(least_fraction_bits(snapped, policy, clipped), 0);
}

// A thin line or triangle, a wide line, or a line of 4 samples a pixel, thin or wide, its vertices
// on a grid of 2 to 13 bits.
Scene scene_on_a_grid(std::uint64_t index) {
  const std::uint64_t round = index / 4;
  if (index % 4 == 0) return random_snap_scene(3, Surface::fbo, round);
  Scene scene = index % 4 == 1
                    ? random_wide_line(3, Surface::fbo, round)
                    : random_multisampled_scene(
                          3, index % 4 == 2 ? MultisampledKind::line : MultisampledKind::wide_line,
                          standard_pattern(4), round);
  const Snap grid{static_cast<int>(2 + round % 12), Snap::Rounding::truncate};
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices) vertex.position = grid(vertex.position);
  return scene;
}

// Random scenes at and beside the steps of grids, drawn as each snap has them.
TEST(SnapLimit, NoCoarserSceneShowsASnap) {
  Dealer dealer;
  int shown = 0, at_the_limit = 0, wide_or_multisampled = 0;
  for (const char* snap :
       {"4-half-even", "6-truncate", "8-half-up", "8-truncate", "11-half-even"}) {
    Policy other;
    other.rules["subpixel.snap"] = snap;
    FaultyRenderer snapping(nullptr, other);
    for (const char* ours : {"none", "8-half-even"}) {
      TrialOptions options;
      options.policy.rules["subpixel.snap"] = ours;
      Trial trial(snapping, options);
      for (std::uint64_t index = 0; index < 1600; ++index) {
        if (!dealer.deal()) continue;
        const Scene scene = scene_on_a_grid(index);
        for (const Signature& signature : trial.ask(scene).signatures) {
          const int least = least_fraction_bits(signature, options.policy, scene);
          if (least == 0) continue;
          ++(index % 4 == 0 ? shown : wide_or_multisampled);
          at_the_limit += fraction_bits_of(scene) == least;
          EXPECT_GE(fraction_bits_of(scene), least) << signature.cause << " " << index;
        }
      }
    }
  }
  EXPECT_GT(shown, least_of(300));
  EXPECT_GT(at_the_limit, least_of(20));
  EXPECT_GT(wide_or_multisampled, least_of(300));
}

// Nothing coarser is asked, and the search is finished at the limit.
TEST(SnapLimit, EndsAMinimisation) {
  FaultyRenderer snapping(nullptr, snapping_lines("8-truncate"));
  Trial trial(snapping, {});
  int finished = 0;
  for (std::uint64_t index = 0; finished < 5; ++index) {
    ASSERT_LT(index, 3000u);
    const Scene scene = random_snap_scene(3, Surface::fbo, index);
    const auto shown = trial.ask(scene).signatures;
    const auto signature = std::ranges::find(shown, "line.snap=8-truncate", &Signature::cause);
    if (signature == shown.end() || least_fraction_bits(*signature, {}, scene) == 0) continue;
    const Minimized result = minimize(scene, *signature, trial, {});
    EXPECT_EQ(result.end, MinimizeEnd::finished);
    EXPECT_EQ(result.least_bits, 9);
    EXPECT_GE(result.fraction_bits, 9);
    EXPECT_LE(result.fraction_bits, 10);
    EXPECT_LT(result.asks, 1000u);
    ++finished;
  }
}

}  // namespace
}  // namespace edgecase
