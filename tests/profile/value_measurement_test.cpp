// SPDX-License-Identifier: MIT
//
// The measurement of values measured: the exact rasterizer under a policy must be found to follow
// it, and what is put wrong must be named.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "profile/evidence/inference.h"
#include "profile/values/values.h"
#include "raster/rasterizer.h"
#include "rules/values/derivative.h"
#include "tests/profile/altered_renderer.h"
#include "tests/profile/found_traits.h"
#include "tests/profile/planted_rounds.h"

namespace edgecase {
namespace {

// As measure() asks: coverage is known, attributes are not. Scenes whose ids do not begin with the
// family are refused.
SurfaceFindings findings_of(const Choices& rules, const Alter& alter = {}, std::uint64_t seed = 1,
                            Surface surface = Surface::fbo, const char* family = "") {
  AlteredRenderer renderer(policy_of(rules), alter,
                           [&](const Task& task) { return task.id.starts_with(family); });
  SurfaceFindings before;
  before.found = resolve(policy_of(rules), surface);
  before.found.values = ValueChoice{};
  SurfaceFindings findings =
      measured(kValueSubject, renderer, {seed, surface, 100}, std::move(before));
  // Eight scenes of each depth format count as progress alone.
  EXPECT_EQ(findings.drawn.scenes + findings.drawn.not_drawn + 24, kValueSubject.scene_count(100));
  return findings;
}

SurfaceFindings findings_among(const char* family, const Alter& alter) {
  return findings_of({}, alter, 1, Surface::fbo, family);
}

const ValueErrors& row_of(const SurfaceFindings& findings, const std::string& attribute,
                          bool as_found = false) {
  for (const ValueErrors& row : findings.values)
    if (row.attribute == attribute && row.as_found == as_found) return row;
  ADD_FAILURE() << "no row " << attribute;
  static const ValueErrors none;
  return none;
}

constexpr const char* kSnap = "8-half-even";

TEST(ValueMeasurement, FindsOpenGlsOwnRules) {
  const SurfaceFindings findings = findings_of({{"triangle.snap", kSnap}, {"line.snap", kSnap}});
  expect_found(findings, "attribute.perspective", "as-set");
  expect_found(findings, "attribute.smooth", "projection");
  expect_found(findings, "attribute.positions", "unsnapped");
  expect_found(findings, "derivative.plain", "quad-fine");
  expect_found(findings, "derivative.fine", "quad-fine");
  expect_found(findings, "derivative.coarse", "quad-coarse-bottom-left");
}

TEST(ValueMeasurement, FindsSnappedPositions) {
  const std::vector<const char*> snaps{"8-half-even", "4-truncate"};
  for (std::size_t i = 0; i < snaps.size(); ++i) {
    if (!is_in_share_of_few(i, snaps.size())) continue;
    const Choices rules{
        {"triangle.snap", snaps[i]}, {"line.snap", snaps[i]}, {"attribute.positions", "snapped"}};
    expect_found(findings_of(rules), "attribute.positions", "snapped");
  }
}

TEST(ValueMeasurement, TellsNothingOfPositionsThatNothingSnaps) {
  const SurfaceFindings findings = findings_of({});
  EXPECT_EQ(trait_of(findings, "attribute.positions").rate.of, 0u);
  EXPECT_FALSE(findings.choices.contains("attribute.positions"));
}

TEST(ValueMeasurement, FindsPerspectiveThatIsNotAsSet) {
  const std::vector<const char*> choices{"always", "never"};
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (!is_in_share_of_few(i, choices.size())) continue;
    expect_found(findings_of({{"attribute.perspective", choices[i]}}), "attribute.perspective",
                 choices[i]);
  }
}

TEST(ValueMeasurement, FindsTheMajorAxis) {
  expect_found(findings_of({{"attribute.smooth", "major-axis"}}), "attribute.smooth", "major-axis");
}

TEST(ValueMeasurement, SaysThatLinesAndTrianglesDiffer) {
  Policy never;
  never.rules = {{"attribute.perspective", "never"}};
  const SurfaceFindings findings = findings_of({}, [&](const Task& task, Rendering& rendering) {
    if (task.scene->draws[0].primitive == Primitive::lines)
      rendering = rasterize(*task.scene, never);
  });
  const std::string& remark = trait_of(findings, "attribute.perspective").remark;
  EXPECT_NE(remark.find("lines are never (100 %), triangles as-set (100 %)"), std::string::npos)
      << remark;
}

TEST(ValueMeasurement, FindsEveryMethodOfDerivatives) {
  const auto methods = values_of<DerivativeMethod>();
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (!is_in_share_of_few(i, methods.size())) continue;
    const Choices rules{{"derivative.plain", name_of(methods[i])},
                        {"derivative.fine", name_of(methods[(i + 1) % methods.size()])},
                        {"derivative.coarse", name_of(methods[(i + 2) % methods.size()])}};
    const SurfaceFindings findings = findings_of(rules);
    for (const auto& [rule, method] : rules) expect_found(findings, rule, method);
  }
}

TEST(ValueMeasurement, SaysWhereXAndYDiffer) {
  Policy other;
  other.rules = {{"derivative.plain", "quad-other-row"}};
  const SurfaceFindings findings =
      findings_among("derivative/", [&](const Task& task, Rendering& rendering) {
        const Rendering rows = rasterize(*task.scene, other);
        for (std::size_t i = 0; i < rendering.details.size(); ++i)
          rendering.details[i].derivatives[1] = rows.details[i].derivatives[1];
      });
  const std::string& remark = trait_of(findings, "derivative.plain").remark;
  EXPECT_NE(remark.find("y is quad-other-row (100 %)"), std::string::npos) << remark;
}

TEST(ValueMeasurement, FindsFromWhichEndQuadsAreCounted) {
  const std::vector<std::pair<const char*, Surface>> rounds{{"top-down", Surface::window},
                                                            {"top-down", Surface::fbo},
                                                            {"bottom-up", Surface::window},
                                                            {"bottom-up", Surface::fbo}};
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    if (!is_in_share_of_few(i, rounds.size())) continue;
    const auto& [rows, surface] = rounds[i];
    const Choices rules{{"derivative.quad-rows", rows}, {"derivative.plain", "quad-fine"}};
    const SurfaceFindings findings = findings_of(rules, {}, 1, surface);
    expect_found(findings, "derivative.plain", "quad-fine");
    expect_found(findings, "derivative.quad-rows", rows);
    EXPECT_FALSE(trait_of(findings, "derivative.quad-rows").is_undecided());
  }
}

// Stores what `round` makes of the depth times the largest integer.
Alter storing(double (*round)(double)) {
  return [=](const Task& task, Rendering& rendering) {
    const int bits = task.scene->target.depth == DepthFormat::depth16   ? 16
                     : task.scene->target.depth == DepthFormat::depth24 ? 24
                                                                        : 0;
    if (bits == 0) return;
    const double largest = std::ldexp(1.0, bits) - 1;
    for (const Fragment& fragment : rendering.fragments)
      rendering.depths[rendering.pixel_index(fragment.x, fragment.y)] =
          round(fragment.depth * largest) / largest;
  };
}

TEST(ValueMeasurement, FindsHowDepthsAreRounded) {
  const std::pair<const char*, Alter> kKinds[] = {
      {"nearest", {}},
      {"truncate", storing([](double value) { return std::floor(value); })},
      {"up", storing([](double value) { return std::ceil(value); })}};
  for (const auto& [name, alter] : kKinds) {
    const SurfaceFindings findings = findings_among("depth ", alter);
    for (const char* format : {"depth16", "depth24"}) {
      const Trait& trait = trait_of(findings, std::string("framebuffer.depth:") + format);
      EXPECT_EQ(trait.alternative, name);
      EXPECT_GT(trait.rate.of, 1000u);
      EXPECT_EQ(trait.rate.agreeing, trait.rate.of);
      EXPECT_EQ(trait.remark, "");
    }
    EXPECT_EQ(trait_of(findings, "framebuffer.depth:depth32f").alternative, "as told");
  }
}

TEST(ValueMeasurement, SaysThatStoredDepthsAreNoNeighbours) {
  const Trait trait = trait_of(
      findings_among("depth ", storing([](double value) { return std::floor(value) - 1; })),
      "framebuffer.depth:depth16");
  EXPECT_NE(trait.remark.find("neither of the two neighbours"), std::string::npos);
}

TEST(ValueMeasurement, SaysWhyADepthFormatIsNotAvailable) {
  class NoDepth final : public Renderer {
   public:
    const RendererInfo& info() const override {
      static const RendererInfo info{"no depth", "", "", "", 8, {}};
      return info;
    }
    void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
      for (std::size_t i = 0; i < tasks.size(); ++i) {
        if (tasks[i].scene->target.depth == DepthFormat::depth16)
          sink(i, Failure{FailureKind::unsupported, "no 16 bits"});
        else
          sink(i, rasterize(*tasks[i].scene, {}));
      }
    }
  };
  NoDepth renderer;
  const SurfaceFindings findings = measured(kValueSubject, renderer, {1, Surface::fbo, 100});
  const Trait& trait = trait_of(findings, "framebuffer.depth:depth16");
  EXPECT_EQ(trait.alternative, "not available");
  EXPECT_EQ(trait.remark, "unsupported: no 16 bits");
  EXPECT_EQ(trait_of(findings, "framebuffer.depth:depth24").alternative, "nearest");
  EXPECT_EQ(findings.drawn.not_drawn, 0u);
}

TEST(ValueMeasurement, RoundedCorrectlyIsNoError) {
  const SurfaceFindings findings = findings_of({}, [](const Task&, Rendering& rendering) {
    for (Fragment& fragment : rendering.fragments) {
      fragment.depth = static_cast<double>(static_cast<float>(fragment.depth));
      for (double& c : fragment.color) c = static_cast<double>(static_cast<float>(c));
    }
  });
  EXPECT_EQ(findings.values.size(), 14u);  // ten modes, depth and 1/w of both kinds
  for (const ValueErrors& row : findings.values) {
    EXPECT_GT(row.components, 500u) << row.attribute;
    EXPECT_EQ(row.correct, row.components) << row.attribute;
    EXPECT_EQ(row.mean_ulp(), 0) << row.attribute;
    EXPECT_TRUE(row.histogram.empty()) << row.attribute;
    EXPECT_EQ(row.beyond, 0u) << row.attribute;
    EXPECT_FALSE(row.worst_ulp || row.worst_relative || row.smallest_beyond) << row.attribute;
  }
}

TEST(ValueMeasurement, NamesTheWorstFragment) {
  PixelPosition pixel;
  int primitive = -1;
  const SurfaceFindings findings = findings_of({}, [&](const Task& task, Rendering& rendering) {
    const bool whole = task.id == "line noperspective/00003";
    // The line alone shows the same.
    if ((!whole && task.id.rfind("alone/", 0) != 0) || rendering.fragments.empty()) return;
    Fragment& fragment = rendering.fragments[rendering.fragments.size() / 2];
    if (whole) {
      pixel = {fragment.x, fragment.y};
      primitive = fragment.primitive;
      fragment.color[2] += 1e-3;
      return;
    }
    for (Fragment& other : rendering.fragments)
      if (PixelPosition{other.x, other.y} == pixel) other.color[2] += 1e-3;
  });
  const ValueErrors& row = row_of(findings, "line noperspective");
  EXPECT_EQ(row.correct + 1, row.components);
  ASSERT_TRUE(row.worst_ulp);
  for (const ValueExample& worst : {*row.worst_ulp, *row.worst_relative}) {
    EXPECT_EQ(worst.id, "line noperspective/00003");
    EXPECT_EQ(worst.pixel, pixel);
    EXPECT_EQ(worst.component, 2);
    EXPECT_NEAR(worst.rendered - worst.exact, 1e-3, 1e-9);
    // Alone, as it shows the same.
    EXPECT_EQ(primitives_of(worst.scene).size(), 1u);
    EXPECT_EQ(worst.primitive, 0);
  }
  EXPECT_GE(primitive, 0);
  for (const ValueErrors& other : findings.values)
    if (other.attribute != row.attribute) {
      EXPECT_EQ(other.correct, other.components);
    }
}

TEST(ValueMeasurement, CountsWhatIsBeyondWhatIsPermitted) {
  const SurfaceFindings findings = findings_of({}, [](const Task& task, Rendering& rendering) {
    if (task.id.rfind("triangle smooth/", 0) != 0) return;
    for (Fragment& fragment : rendering.fragments) fragment.color[0] += 1e15;
  });
  const ValueErrors& row = row_of(findings, "triangle smooth");
  EXPECT_GT(row.beyond, row.fragments / 2);
  ASSERT_TRUE(row.smallest_beyond && row.smallest_beyond->permitted);
  EXPECT_FALSE(row.smallest_beyond->permitted->contains(row.smallest_beyond->rendered));
  EXPECT_LE(row.smallest_beyond->scene.target.width, 16);
}

TEST(ValueMeasurement, CountsWhatIsNoNumberApart) {
  const SurfaceFindings findings = findings_of({}, [](const Task& task, Rendering& rendering) {
    if (task.id.rfind("triangle smooth/", 0) != 0 || rendering.fragments.empty()) return;
    rendering.fragments[0].color[1] = std::numeric_limits<double>::quiet_NaN();
    rendering.fragments[0].color[3] = std::numeric_limits<double>::infinity();
  });
  const ValueErrors& row = row_of(findings, "triangle smooth");
  EXPECT_GT(row.not_numbers, 0u);
  EXPECT_EQ(row.not_numbers, row.beyond);
  EXPECT_EQ(row.not_asked, 0u);
  EXPECT_EQ(row.correct + row.not_numbers, row.components);
  EXPECT_EQ(row.mean_ulp(), 0);
}

// A flat colour of the wrong vertex is no small error: every one is beyond.
TEST(ValueMeasurement, FlatColorsHaveNoLatitude) {
  const SurfaceFindings findings = findings_of({{"attribute.provoking-vertex", "first"}});
  const ValueErrors& row = row_of(findings, "triangle flat");
  EXPECT_LT(row.correct, row.components);
  EXPECT_EQ(row.correct + row.beyond, row.components);
}

TEST(ValueMeasurement, HoldsErrorsAgainstWhatIsFoundToo) {
  const SurfaceFindings findings = findings_of({{"attribute.smooth", "major-axis"}});
  EXPECT_LT(row_of(findings, "line smooth").correct, row_of(findings, "line smooth").components);
  const ValueErrors& found = row_of(findings, "line smooth", true);
  EXPECT_EQ(found.correct, found.components);
  for (const ValueErrors& row : findings.values)
    if (row.as_found) {
      EXPECT_EQ(row.attribute.rfind("line", 0), 0u) << row.attribute;
    }
}

// Off by a unit in the last place where the pixel says so.
void err(const Task&, Rendering& rendering) {
  for (Fragment& fragment : rendering.fragments)
    for (double& c : fragment.color)
      c = static_cast<double>((fragment.x + fragment.y) % 3 == 0
                                  ? std::nextafterf(static_cast<float>(c), HUGE_VALF)
                                  : static_cast<float>(c));
}

bool same(const ValueErrors& a, const ValueErrors& b) {
  return a.attribute == b.attribute && a.fragments == b.fragments && a.correct == b.correct &&
         a.histogram == b.histogram && a.ulp_sum == b.ulp_sum && a.beyond == b.beyond &&
         a.worst_ulp.has_value() == b.worst_ulp.has_value() &&
         (!a.worst_ulp ||
          (a.worst_ulp->id == b.worst_ulp->id && a.worst_ulp->ulp == b.worst_ulp->ulp));
}

TEST(ValueMeasurement, TheSameSeedGivesTheSame) {
  const SurfaceFindings first = findings_of({}, err, 7);
  const SurfaceFindings again = findings_of({}, err, 7);
  const SurfaceFindings other = findings_of({}, err, 8);
  ASSERT_EQ(first.values.size(), again.values.size());
  bool any_differs = false;
  for (std::size_t i = 0; i < first.values.size(); ++i) {
    EXPECT_TRUE(same(first.values[i], again.values[i])) << first.values[i].attribute;
    any_differs |= !same(first.values[i], other.values[i]);
  }
  EXPECT_TRUE(any_differs);
}

TEST(ValueMeasurement, AnotherSeedFindsTheSameRules) {
  const std::vector<Choices> rounds{
      {{"triangle.snap", kSnap}, {"line.snap", kSnap}, {"attribute.positions", "snapped"}},
      {{"attribute.perspective", "always"}, {"derivative.coarse", "quad-coarse-top-right"}},
      {{"attribute.smooth", "major-axis"}, {"derivative.plain", "forward"}}};
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    if (!is_in_share_of_few(i, rounds.size())) continue;
    EXPECT_EQ(findings_of(rounds[i], {}, 3).choices, findings_of(rounds[i], {}, 4).choices);
  }
}

}  // namespace
}  // namespace edgecase
