// SPDX-License-Identifier: MIT
//
// Perspective, gl_FragCoord and derivatives on the OpenGL side: not how exact a driver is, but that
// what is told is what was asked for, and belongs to its fragment.
#include <gmock/gmock.h>

#include <algorithm>
#include <optional>

#include "tests/reference/opengl_test.h"

namespace edgecase {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Eq;

constexpr double kNear = 1e-5;

class DetailsTest : public OpenGlTest {
 protected:
  // A triangle over the lower left half of an 8x8 target. Its corners have a w of 1, 4 and 2, a
  // depth of 0, 1/2 and 1, and green that grows upwards, red to the right.
  Scene perspective(Interpolation interpolation) const {
    Scene scene = blank(8, 8);
    scene.details = {true, true};
    scene.draws = {make_draw(Primitive::triangles, {{0, 0}, {8 * 256, 0}, {0, 8 * 256}})};
    scene.draws[0].interpolation = interpolation;
    auto& vertices = scene.draws[0].vertices;
    vertices[0].z = Fixed::from_integer(-1);
    vertices[1].w = 4;
    vertices[2].w = 2;
    vertices[2].z = Fixed::from_integer(1);
    vertices[0].color = {0, 0, 0, 1};
    vertices[1].color = {1, 0, 0, 1};
    vertices[2].color = {0, 1, 0, 1};
    return scene;
  }
};

const FragmentDetail& detail_of(const Rendering& rendering, const Fragment& fragment) {
  return rendering.details.at(static_cast<std::size_t>(fragment.detail));
}

const Fragment* find(const Rendering& rendering, int x, int y) {
  for (const Fragment& fragment : rendering.fragments)
    if (fragment.x == x && fragment.y == y) return &fragment;
  return nullptr;
}

TEST_P(DetailsTest, SmoothColoursAreDividedByWAndOthersAreNot) {
  for (Interpolation interpolation : {Interpolation::smooth, Interpolation::noperspective}) {
    const Rendering rendering = render(renderer(), perspective(interpolation));
    ASSERT_GE(rendering.fragments.size(), 28u);
    for (const Fragment& fragment : rendering.fragments) {
      const double right = (fragment.x + 0.5) / 8, up = (fragment.y + 0.5) / 8;
      const double inverse_w = (1 - right - up) + right / 4 + up / 2;
      const bool divides = interpolation == Interpolation::smooth;
      EXPECT_NEAR(fragment.color[0], divides ? right / 4 / inverse_w : right, kNear);
      EXPECT_NEAR(fragment.color[1], divides ? up / 2 / inverse_w : up, kNear);
      const auto& coordinates = detail_of(rendering, fragment).coordinates.value();
      EXPECT_EQ(coordinates[0], fragment.x + 0.5);
      EXPECT_EQ(coordinates[1], fragment.y + 0.5);
      EXPECT_EQ(coordinates[2], fragment.depth);
      EXPECT_NEAR(coordinates[2], right / 2 + up, kNear);
      EXPECT_NEAR(coordinates[3], inverse_w, kNear);
    }
  }
}

TEST_P(DetailsTest, ClipCoordinatesLandWhereTheirQuotientsSay) {
  // Columns 1 to 4, rows 2 to 4 of an 8x8 target, each corner with another w.
  Scene scene = blank(8, 8);
  scene.draws = {rectangle(256 + 64, 256 + 192, 5 * 256 + 64, 4 * 256 + 192)};
  float w = 0.75f;
  for (Vertex& vertex : scene.draws[0].vertices) {
    const auto clip = [&](Fixed window) {
      return static_cast<float>(window.to_double() / 4 - 1) * w;
    };
    vertex.clip = ClipPosition{clip(vertex.position.x), clip(vertex.position.y), w / 2, w};
    vertex.w = w;
    vertex.z = Fixed::from_raw(Fixed::kOne / 2);
    w *= 2;
  }
  const Rendering rendering = render(renderer(), scene);
  EXPECT_EQ(coverage(rendering),
            "........\n........\n........\n.####...\n.####...\n.####...\n........\n........\n");
  for (const Fragment& fragment : rendering.fragments) EXPECT_NEAR(fragment.depth, 0.75, kNear);
}

TEST_P(DetailsTest, DerivativesOfALinearColourAreItsSlopes) {
  Scene scene = blank(8, 8);
  scene.details.derivatives = true;
  scene.draws = {rectangle(0, 0, 8 * 256, 8 * 256)};
  scene.draws[0].interpolation = Interpolation::smooth;
  for (Vertex& vertex : scene.draws[0].vertices)
    vertex.color = {vertex.position.x.raw() > 0 ? 8.0f : 0.0f,
                    vertex.position.y.raw() > 0 ? -4.0f : 0.0f, 0.25f, 1};
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.fragments.size(), 64u);
  for (const Fragment& fragment : rendering.fragments) {
    const FragmentDetail& detail = detail_of(rendering, fragment);
    for (std::size_t i = 0; i < kDerivatives; ++i) {
      const bool along_x = i % 2 == 0;
      EXPECT_NEAR(detail.derivatives[i].value()[0], along_x ? 1 : 0, kNear);
      EXPECT_NEAR(detail.derivatives[i].value()[1], along_x ? 0 : -0.5, kNear);
      EXPECT_NEAR(detail.derivatives[i].value()[2], 0, kNear);
    }
  }
  scene.draws[0].interpolation = Interpolation::flat;
  const Rendering flat = render(renderer(), scene);
  for (const Fragment& fragment : flat.fragments)
    for (std::size_t i = 0; i < kDerivatives; ++i)
      EXPECT_THAT(detail_of(flat, fragment).derivatives[i].value(), Each(0.0));
}

// Fine derivatives are differences of a fragment's own row and column of its quad, where all four
// are there: that they belong to this fragment, and to the colour that was chosen.
TEST_P(DetailsTest, FineDerivativesAreTheFragmentsOwnDifferences) {
  for (Interpolation interpolation : {Interpolation::smooth, Interpolation::noperspective}) {
    const Rendering rendering = render(renderer(), perspective(interpolation));
    int quads = 0;
    for (int x = 0; x < 8; x += 2) {
      for (int y = 0; y < 8; y += 2) {
        const Fragment* const corners[] = {find(rendering, x, y), find(rendering, x + 1, y),
                                           find(rendering, x, y + 1),
                                           find(rendering, x + 1, y + 1)};
        if (std::count(std::begin(corners), std::end(corners), nullptr) > 0) continue;
        ++quads;
        for (std::size_t i = 0; i < 4; ++i) {
          const auto& derivatives = detail_of(rendering, *corners[i]).derivatives;
          for (std::size_t part = 0; part < 4; ++part) {
            const auto red = [&](std::size_t corner) { return corners[corner]->color[part]; };
            EXPECT_NEAR(derivatives[2].value()[part], red(i | 1) - red(i & 2), kNear);
            EXPECT_NEAR(derivatives[3].value()[part], red(i | 2) - red(i & 1), kNear);
          }
        }
      }
    }
    EXPECT_GE(quads, 6);
  }
}

TEST_P(DetailsTest, WhatWasNotAskedForIsNotTold) {
  Scene scene = perspective(Interpolation::smooth);
  scene.details = {};
  const Rendering plain = render(renderer(), scene);
  EXPECT_TRUE(plain.details.empty());
  scene.details.coordinates = true;
  const Rendering coordinates = render(renderer(), scene);
  ASSERT_EQ(coordinates.details.size(), coordinates.fragments.size());
  for (const FragmentDetail& detail : coordinates.details) {
    EXPECT_TRUE(detail.coordinates.has_value());
    EXPECT_FALSE(detail.derivatives.has_any());
  }
  scene.details = {false, true};
  const Rendering derivatives = render(renderer(), scene);
  const bool all = renderer().info().traits.at("derivatives") == "plain fine coarse";
  ASSERT_EQ(derivatives.details.size(), derivatives.fragments.size());
  for (const FragmentDetail& detail : derivatives.details) {
    EXPECT_FALSE(detail.coordinates.has_value());
    for (std::size_t i = 0; i < kDerivatives; ++i)
      EXPECT_EQ(detail.derivatives[i].has_value(), i < 2 || all) << i;
  }
  // The detailed record changes nothing of the rest.
  EXPECT_EQ(derivatives.pixels, plain.pixels);
  EXPECT_EQ(derivatives.hits, plain.hits);
  for (std::size_t i = 0; i < plain.fragments.size(); ++i) {
    EXPECT_EQ(derivatives.fragments[i].color, plain.fragments[i].color);
    EXPECT_EQ(derivatives.fragments[i].depth, plain.fragments[i].depth);
  }
}

TEST_P(DetailsTest, CoverageAloneHasNone) {
  const Scene scene = perspective(Interpolation::smooth);
  const Task task{"test", &scene, true};
  std::optional<Outcome> outcome;
  renderer().render({&task, 1}, [&](std::size_t, Outcome got) { outcome = std::move(got); });
  ASSERT_TRUE(outcome && std::holds_alternative<Rendering>(*outcome));
  EXPECT_TRUE(std::get<Rendering>(*outcome).details.empty());
  EXPECT_FALSE(std::get<Rendering>(*outcome).fragments.empty());
}

TEST_P(DetailsTest, CapturesMoreDetailsThanItFirstHasRoomFor) {
  Scene scene = blank(128, 128);
  scene.details = {true, true};
  scene.draws = {rectangle(0, 0, 128 * 256, 128 * 256), rectangle(0, 0, 128 * 256, 128 * 256)};
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.details.size(), 2u * 128 * 128);
  for (const Fragment& fragment : rendering.fragments)
    ASSERT_EQ(detail_of(rendering, fragment).coordinates.value()[1], fragment.y + 0.5);
}

TEST_P(DetailsTest, ColoursBeyondOneAreCapturedAsTheyAre) {
  Scene scene = blank(2, 1);
  scene.draws = {rectangle(0, 0, 2 * 256, 256, {-2.5f, 1000, 3e38f, 1e-30f})};
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.fragments.size(), 2u);
  EXPECT_THAT(rendering.fragments[0].color,
              ElementsAre(-2.5, 1000, static_cast<double>(3e38f), static_cast<double>(1e-30f)));
  EXPECT_THAT(pixel(rendering, 0, 0), ElementsAre(0, 255, 255, 0));
}

INSTANTIATE_TEST_SUITE_P(OpenGl, DetailsTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
