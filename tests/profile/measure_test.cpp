// SPDX-License-Identifier: MIT
//
// The measurement measured: a renderer whose rules are known must be found to follow them. Whatever
// the policy, the exact rasterizer under it is such a renderer.
#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "profile/profile.h"
#include "raster/rasterizer.h"
#include "tests/profile/altered_renderer.h"
#include "tests/profile/planted_rounds.h"

namespace edgecase {
namespace {

constexpr std::size_t kScenes = 500;

Profile profile_of(const Policy& policy, const MeasureOptions& options,
                   const IsDrawn& is_drawn = {}) {
  return measure([&] { return std::make_unique<AlteredRenderer>(policy, Alter{}, is_drawn); },
                 options);
}

MeasureOptions options_of(const char* name, std::size_t scenes) {
  MeasureOptions options;
  options.name = name;
  options.scenes_per_kind = scenes;
  return options;
}

bool is_random_coverage(const Task& task) {
  return task.id.starts_with("triangle/") || task.id.starts_with("line/") ||
         task.id.starts_with("point/");
}

// Tests that measure all there is, though they assert little but of coverage: in other shares than
// theirs, random scenes of coverage are drawn and probes of colours. The first share is nobody's.
enum class WholeMeasurement : std::size_t { other_seed = 1, odd, no_lines };
bool is_measured(const Task& task, WholeMeasurement test) {
  return is_in_share_of_few(static_cast<std::size_t>(test), 4) || is_random_coverage(task) ||
         task.id.starts_with("probe/");
}

const Trait& trait_of(const SurfaceProfile& surface, const std::string& id) {
  for (const Trait& trait : surface.findings.traits)
    if (text_of(trait.id) == id) return trait;
  ADD_FAILURE() << "no trait " << id;
  static const Trait none;
  return none;
}

// Everything that the policy chooses must be found, and be agreed with wholly; where another
// alternative does as well on all scenes, it may be found in its place.
void expect_found(const Policy& policy, const Profile& profile) {
  for (const SurfaceProfile& surface : profile.surfaces) {
    EXPECT_EQ(surface.unavailable, "");
    EXPECT_EQ(surface.findings.drawn.not_drawn, 0u) << surface.findings.drawn.first_failure;
    for (const auto& [rule, alternative] : policy.rules) {
      const Trait& trait = trait_of(surface, rule);
      EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << rule;
      EXPECT_TRUE(trait.alternative == alternative ||
                  (trait.is_undecided() && trait.runner_up == alternative))
          << rule << " is " << alternative << ", found " << trait.alternative << ", then "
          << trait.runner_up << " " << trait.runner_up_rate.agreeing;
    }
    // Nothing differs from the profile itself; what is found breaks the letter of the
    // specification.
    for (const ProfileCluster& found : surface.clusters)
      EXPECT_NE(found.cluster.legality, Legality::legal) << found.cluster.cause;
  }
}

struct Known {
  const char* name;
  Choices rules;
};

// Points, lines, triangles, values and textures hide nothing of each other.
const std::vector<Known> kKnown{{"opengl", {}},
                                {"direct3d, with values and textures of others",
                                 {{"triangle.fill-rule", "left-top"},
                                  {"triangle.snap", "8-half-even"},
                                  {"line.snap", "8-half-even"},
                                  {"line.diamond-exit", "direct3d"},
                                  {"attribute.positions", "snapped"},
                                  {"attribute.smooth", "major-axis"},
                                  {"derivative.plain", "quad-coarse-top-left"},
                                  {"derivative.coarse", "quad-fine"},
                                  {"derivative.quad-rows", "top-down"},
                                  {"texture.scale-factor", "largest-partial"},
                                  {"texture.log2", "mantissa-8"},
                                  {"texture.derivatives", "quad-coarse-top-left"},
                                  {"texture.nearest-level", "up-at-ties"},
                                  {"texture.level-weight", "floor-8"},
                                  {"texture.texel-grid", "linear-even-8"},
                                  {"texture.lod-bias", "sampler-nearest-8"},
                                  {"mipmap.filter", "bilinear-centre"},
                                  {"mipmap.rounding", "half-up-by-rows"}}},
                                {"course, with points and wide lines of others",
                                 {{"line.algorithm", "walk-ends-tested"},
                                  {"line.diamond-exit", "scotty3d"},
                                  {"triangle.fill-rule", "closed"},
                                  {"point.offset", "right-down"},
                                  {"point.ownership", "right-bottom"},
                                  {"line.width", "shifted-triangles"}}},
                                {"coarse",
                                 {{"triangle.fill-rule", "right-bottom"},
                                  {"triangle.snap", "4-truncate"},
                                  {"point.snap", "4-half-up"},
                                  {"line.snap", "4-half-even"},
                                  {"line.algorithm", "midpoint"}}},
                                {"areas, with scanned triangles",
                                 {{"line.algorithm", "rectangle"},
                                  {"line.width", "rectangle"},
                                  {"triangle.algorithm", "scan"}}},
                                {"upside-down",
                                 {{"line.algorithm", "bresenham"},
                                  {"line.row-order", "top-down"},
                                  {"triangle.algorithm", "scan"},
                                  {"triangle.row-order", "top-down"}}}};

TEST(Measure, FindsKnownPolicies) {
  const std::vector<Surface> surfaces{Surface::fbo, Surface::window};
  for (std::size_t i = 0; i < 2 * kKnown.size(); ++i) {
    if (!is_in_share_of_few(i, 2 * kKnown.size())) continue;
    const Known& known = kKnown[i / 2];
    SCOPED_TRACE(known.name);
    Policy policy;
    policy.rules = known.rules;
    MeasureOptions options = options_of("known", kScenes);
    options.surfaces = {surfaces[i % 2]};
    expect_found(policy, profile_of(policy, options));
  }
}

TEST(Measure, TellsSurfacesApart) {
  Policy policy;
  policy.rules = {{"triangle.fill-rule", "left-bottom"}};
  policy.surfaces[Surface::window] = {{"triangle.fill-rule", "right-top"}};
  const Profile profile = profile_of(policy, options_of("known", kScenes), is_random_coverage);
  EXPECT_EQ(profile.policy.rules.at("triangle.fill-rule"), "left-bottom");
  EXPECT_EQ(profile.policy.surfaces.at(Surface::window),
            (Choices{{"triangle.fill-rule", "right-top"}}));
}

TEST(Measure, FindsTheSameWithAnotherSeed) {
  Policy policy;
  policy.rules = {{"triangle.snap", "8-half-up"}, {"line.diamond-exit", "top-right"}};
  const auto found = [&](std::uint64_t seed) {
    MeasureOptions options = options_of("known", kScenes);
    options.seed = seed;
    return profile_of(
               policy, options,
               [](const Task& task) { return is_measured(task, WholeMeasurement::other_seed); })
        .policy;
  };
  const Policy first = found(1);
  const Policy second = found(2);
  EXPECT_EQ(first.rules.at("triangle.snap"), "8-half-up");
  EXPECT_EQ(first.rules.at("line.diamond-exit"), "top-right");
  EXPECT_EQ(first.rules, second.rules);
  EXPECT_EQ(first.surfaces, second.surfaces);
}

// A renderer that does what no alternative does: every seventh triangle lacks its last pixel, and
// flat colours are those of the first vertex, whatever the scene says.
class OddRenderer final : public Renderer {
 public:
  const RendererInfo& info() const override {
    static const RendererInfo info{"odd", "", "", "odd", 8, {}};
    return info;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    Policy policy;
    policy.rules = {{"attribute.provoking-vertex", "first"}};
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (!is_measured(tasks[i], WholeMeasurement::odd)) {
        sink(i, Failure{FailureKind::unsupported, "another share's"});
        continue;
      }
      Rendering rendering = rasterize(*tasks[i].scene, policy);
      const bool triangle = tasks[i].scene->draws[0].primitive == Primitive::triangles;
      if (triangle && tasks[i].id.starts_with("triangle/") && i % 7 == 0 &&
          !rendering.fragments.empty())
        rendering.fragments.pop_back();
      if (i % 100 == 99)
        sink(i, Failure{FailureKind::unsupported, "not every hundredth"});
      else
        sink(i, std::move(rendering));
    }
  }
};

TEST(Measure, KeepsWhatNothingExplainsAndWhatWasNotDrawn) {
  MeasureOptions options = options_of("odd", 700);
  options.surfaces = {Surface::fbo};
  const Profile profile = measure([] { return std::make_unique<OddRenderer>(); }, options);
  const SurfaceProfile& surface = profile.surfaces.at(0);
  EXPECT_EQ(surface.findings.drawn.first_failure, "unsupported: not every hundredth");
  EXPECT_GT(surface.findings.drawn.not_drawn, 50u);
  EXPECT_EQ(trait_of(surface, "attribute.provoking-vertex").alternative, "first");
  EXPECT_EQ(profile.policy.rules.at("attribute.provoking-vertex"), "first");
  const Trait& fill = trait_of(surface, "triangle.fill-rule");
  EXPECT_EQ(fill.alternative, "left-top");
  EXPECT_LT(fill.rate.agreeing, fill.rate.of);
  EXPECT_GT(fill.rate.share(), 0.8);
  std::size_t missing = 0;
  for (const ProfileCluster& found : surface.clusters)
    if (found.cluster.kind == "missing" || !found.cluster.cause.empty())
      missing += found.cluster.disagreements;
  EXPECT_EQ(missing, fill.rate.of - fill.rate.agreeing);
}

// What is measured of multisampled targets is part of the policy, of framebuffer objects alone.
TEST(Measure, FindsRulesOfMultisampledTargets) {
  Policy policy;
  policy.rules = {{"sample.resolve", "truncated"}, {"attribute.centroid", "first-covered"}};
  const Profile profile = profile_of(policy, options_of("known", 100), [](const Task& task) {
    return task.scene->target.samples > 1 || is_random_coverage(task);
  });
  EXPECT_EQ(profile.policy.rules.at("sample.resolve"), "truncated");
  EXPECT_EQ(profile.policy.rules.at("attribute.centroid"), "first-covered");
  EXPECT_TRUE(profile.policy.surfaces.empty());
  EXPECT_EQ(profile.surfaces.at(0).findings.samples.samples, 4);
  EXPECT_EQ(profile.surfaces.at(0).findings.samples.positions.size(), 4u);
  EXPECT_EQ(profile.surfaces.at(1).findings.samples.unavailable,
            "a window's samples cannot be chosen");
}

// A renderer without lines has a profile of the rest.
TEST(Measure, LeavesOutWhatARendererDoesNotDraw) {
  class NoLines final : public Renderer {
   public:
    const RendererInfo& info() const override {
      static const RendererInfo info{"no lines", "", "", "", 8, {}};
      return info;
    }
    void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
      for (std::size_t i = 0; i < tasks.size(); ++i) {
        if (kind_of(tasks[i].scene->draws[0].primitive) == PrimitiveKind::line)
          sink(i, Failure{FailureKind::unsupported, "no lines"});
        else if (!is_measured(tasks[i], WholeMeasurement::no_lines))
          sink(i, Failure{FailureKind::unsupported, "another share's"});
        else
          sink(i, rasterize(*tasks[i].scene, {}));
      }
    }
  };
  MeasureOptions options = options_of("no-lines", 100);
  options.surfaces = {Surface::fbo};
  const Profile profile = measure([] { return std::make_unique<NoLines>(); }, options);
  const SurfaceProfile& surface = profile.surfaces.at(0);
  EXPECT_EQ(surface.unavailable, "");
  EXPECT_EQ(surface.findings.drawn.first_failure, "unsupported: no lines");
  EXPECT_EQ(profile.policy.rules.at("triangle.fill-rule"), "left-top");
  EXPECT_FALSE(profile.policy.rules.contains("line.algorithm"));
  EXPECT_FALSE(profile.policy.rules.contains("line.width"));
  EXPECT_EQ(trait_of(surface, "line.ends").rate.of, 0u);
}

TEST(Measure, SaysThatNothingCouldBeMeasured) {
  class Absent final : public Renderer {
   public:
    const RendererInfo& info() const override {
      static const RendererInfo info{"absent", "", "", "", 4, {}};
      return info;
    }
    void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
      for (std::size_t i = 0; i < tasks.size(); ++i)
        sink(i, Failure{FailureKind::unavailable, "not here"});
    }
  };
  const MeasureOptions options = options_of("absent", 100);
  const Profile profile = measure([] { return std::make_unique<Absent>(); }, options);
  for (const SurfaceProfile& surface : profile.surfaces)
    EXPECT_EQ(surface.unavailable, "unavailable: not here");
  EXPECT_TRUE(profile.policy.rules.empty());
}

}  // namespace
}  // namespace edgecase
