// SPDX-License-Identifier: MIT
//
// What a primitive's fragments carry, under the choices of a policy.
#include "raster/attributes.h"

#include <gtest/gtest.h>

#include "raster/texture_stage.h"
#include "tests/raster/random_scenes.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

// Off every grid of 4 bits by half a step.
constexpr double kHalfStep = 1.0 / 32;

class Attributes : public ::testing::Test {
 protected:
  Attributes() {
    const Point positions[] = {at(1 + kHalfStep, 1), at(14, 2), at(3, 13 + kHalfStep)};
    scene_.draws = {make_draw(Primitive::triangles, positions)};
    draw().interpolation = Interpolation::smooth;
    for (std::size_t i = 0; i < 3; ++i) {
      draw().vertices[i].z = Fixed::from_raw(Fixed::kOne / 4 * static_cast<int>(i));
      draw().vertices[i].color[3] = 0.25F * static_cast<float>(i);
    }
    choices_.triangles.snap = *find_snap("4-half-up");
  }
  Draw& draw() { return scene_.draws[0]; }
  ScenePrimitive primitive() const { return primitives_of(scene_).at(0); }
  PrimitiveAttributes attributes() const {
    return attributes_of(primitive(), choices_, scene_.target);
  }
  FragmentDetail details_at(const PrimitiveAttributes& given, const QuadPixel& pixel,
                            const Details& asked, const ExactLookup* lookup = nullptr) const {
    CentreColors colors(scene_.target.width);
    colors.take(given.color);
    return shade_details(given, colors, pixel, choices_.values, asked, lookup);
  }
  void give_clip(std::size_t vertex, ClipPosition clip) {
    draw().vertices[vertex].clip = clip;
    draw().vertices[vertex].w = clip.w;
  }

  Scene scene_ = blank_scene(16, 15);
  RuleChoices choices_;
};

bool at_same_place(const HomogeneousPoint& a, Point b) {
  return same_point(a, homogeneous(b));
}

TEST_F(Attributes, PositionsAreTheVerticesUnlessSnapped) {
  for (const auto& [choice, x, y] :
       {std::tuple{AttributePositions::unsnapped, 1 + kHalfStep, 13 + kHalfStep},
        std::tuple{AttributePositions::snapped, 1 + 2 * kHalfStep, 13 + 2 * kHalfStep}}) {
    choices_.values.positions = choice;
    const PrimitiveAttributes result = attributes();
    for (const Interpolant* f :
         {&result.color[0], &result.color[3], &result.depth, &result.inverse_w}) {
      EXPECT_TRUE(at_same_place(f->positions[0], at(x, 1)));
      EXPECT_TRUE(at_same_place(f->positions[1], at(14, 2)));
      EXPECT_TRUE(at_same_place(f->positions[2], at(3, y)));
    }
  }
}

TEST_F(Attributes, SnappingSeesTheRowsAsCoverageDoes) {
  const CoverageChoice& choice = choices_.triangles;
  EXPECT_TRUE(at_same_place(snapped_position(primitive(), 2, choice, scene_.target),
                            at(3, 13 + 2 * kHalfStep)));
  choices_.triangles.rows = RowOrder::top_down;
  EXPECT_TRUE(at_same_place(snapped_position(primitive(), 2, choice, scene_.target), at(3, 13)));
  EXPECT_TRUE(at_same_place(snapped_position(primitive(), 0, choice, scene_.target),
                            at(1 + 2 * kHalfStep, 1)));
}

TEST_F(Attributes, QuadsAreCountedFromEitherEnd) {
  EXPECT_EQ(quad_of({4, 4}, choices_.values, scene_.target).quad.y, 4);
  // An odd height: the lowest row is the upper one of a quad that is not there.
  choices_.values.quad_rows = RowOrder::top_down;
  EXPECT_EQ(quad_of({4, 4}, choices_.values, scene_.target).quad.y, 3);
}

TEST_F(Attributes, UnsnappedCoverageLeavesQuotients) {
  give_clip(1, {0.3F, -0.2F, 0.1F, 0.7F});
  choices_.triangles.snap = Snap{};
  choices_.values.positions = AttributePositions::snapped;
  const ScenePrimitive one = primitive();
  EXPECT_TRUE(same_point(attributes().depth.positions[1], one.positions[1]));
  EXPECT_FALSE(at_same_place(one.positions[1], nearest_point(one.positions[1])));
}

TEST_F(Attributes, FlatIsTheProvokingVertexWhateverIsChosenElse) {
  draw().interpolation = Interpolation::flat;
  choices_.values.perspective = PerspectiveChoice::always;
  draw().vertices[1].w = 2;
  for (const auto& [choice, vertex] :
       {std::pair{ProvokingChoice::first, 0}, std::pair{ProvokingChoice::last, 2}}) {
    choices_.values.provoking = choice;
    const Fragment fragment = shade(primitive(), attributes(), {4, 4});
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_EQ(fragment.color[c],
                static_cast<double>(draw().vertices[static_cast<std::size_t>(vertex)].color[c]));
  }
}

// The order of the vertices matters to flat attributes, and to no others.
TEST_F(Attributes, TurningTheVerticesChangesFlatAlone) {
  for (const Interpolation interpolation :
       {Interpolation::flat, Interpolation::smooth, Interpolation::noperspective}) {
    draw().interpolation = interpolation;
    const Fragment given = shade(primitive(), attributes(), {4, 4});
    std::rotate(draw().vertices.begin(), draw().vertices.begin() + 1, draw().vertices.end());
    const Fragment turned = shade(primitive(), attributes(), {4, 4});
    EXPECT_NEAR(given.depth, turned.depth, 1e-15);
    if (interpolation == Interpolation::flat)
      EXPECT_GT(std::fabs(given.color[0] - turned.color[0]), 1e-3);
    else
      EXPECT_NEAR(given.color[0], turned.color[0], 1e-15);
  }
}

TEST_F(Attributes, SmoothIsDividedByWAndNoperspectiveIsNot) {
  draw().vertices[2].w = 4;
  for (const auto& [interpolation, choice, divided] :
       {std::tuple{Interpolation::smooth, PerspectiveChoice::as_set, true},
        std::tuple{Interpolation::noperspective, PerspectiveChoice::as_set, false},
        std::tuple{Interpolation::noperspective, PerspectiveChoice::always, true},
        std::tuple{Interpolation::smooth, PerspectiveChoice::never, false}}) {
    draw().interpolation = interpolation;
    choices_.values.perspective = choice;
    const PrimitiveAttributes result = attributes();
    for (const Interpolant& component : result.color) EXPECT_EQ(component.perspective, divided);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(result.color[0].w[i].low, i < 2 ? 1 : 4);
    // Depth and 1/w run linearly in the window whatever is chosen.
    EXPECT_FALSE(has_perspective(result.depth));
    EXPECT_FALSE(has_perspective(result.inverse_w));
  }
}

// 1/w is 1 + x/16 and red over w x/8: at x = 4 red over w is 1/2, w 4/5, and half a pixel farther
// right, at the centre, 32/41.
TEST_F(Attributes, WMayBeThatOfTheCentre) {
  const Point positions[] = {at(0, 0), at(16, 0), at(0, 16)};
  draw() = make_draw(Primitive::triangles, positions);
  draw().interpolation = Interpolation::smooth;
  for (std::size_t i = 0; i < 3; ++i) draw().vertices[i].color[0] = i == 1 ? 1 : 0;
  draw().vertices[1].w = 0.5F;
  EXPECT_FALSE(PrimitiveAttributes{}.w_of_centre);
  for (const auto& [choice, red] :
       {std::pair{PerspectiveChoice::as_set, 2.0 / 5},
        std::pair{PerspectiveChoice::always, 2.0 / 5}, std::pair{PerspectiveChoice::never, 1.0 / 4},
        std::pair{PerspectiveChoice::w_of_centre, 16.0 / 41}}) {
    choices_.values.perspective = choice;
    const PrimitiveAttributes result = attributes();
    EXPECT_NEAR(middle(color_exact(result, 0, at(4, 4), {4, 4})), red, 1e-15);
    EXPECT_NEAR(middle(color_inexact(result, 0, at(4, 4), {4, 4})), red, 1e-6);
    const Fragment fragment =
        shade(primitive(), result, {4, 4}, ShadingPlaces{at(4, 4), at(4, 4), at(4, 4)});
    EXPECT_NEAR(fragment.color[0], red, 1e-15);
  }
}

TEST_F(Attributes, TheLineParameterIsTheChosenOne) {
  choices_.values.line_parameter = LineParameter::major_axis;
  EXPECT_EQ(attributes().color[2].line_parameter, LineParameter::major_axis);
  EXPECT_EQ(attributes().depth.line_parameter, LineParameter::major_axis);
}

TEST_F(Attributes, DepthIsHalfOfZPlusHalf) {
  const PrimitiveAttributes result = attributes();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(result.depth.values[i].low, 0.5 + 0.125 * static_cast<double>(i));
    EXPECT_EQ(result.depth.values[i].high, result.depth.values[i].low);
    EXPECT_EQ(result.inverse_w.values[i].low, 1);
    EXPECT_EQ(result.inverse_w.values[i].high, 1);
  }
}

// Of clip coordinates: a number where the quotient is one, else an interval around it.
TEST_F(Attributes, DepthOfClipCoordinatesIsTheirQuotient) {
  give_clip(0, {0, 0, 0, 3});
  give_clip(1, {0, 0, -1.5F, 6});
  give_clip(2, {0.1F, 0.5F, 1, 3});
  const PrimitiveAttributes result = attributes();
  EXPECT_EQ(result.depth.values[0].low, 0.5);
  EXPECT_EQ(result.depth.values[0].high, 0.5);
  EXPECT_EQ(result.depth.values[1].low, 0.375);
  EXPECT_EQ(result.depth.values[1].high, 0.375);
  EXPECT_TRUE(holds(result.depth.values[2], static_cast<Wide>(2) / 3));
  EXPECT_LT(width_of(result.depth.values[2]), 1e-15);
  EXPECT_TRUE(holds(result.inverse_w.values[1], static_cast<Wide>(1) / 6));
  EXPECT_LT(width_of(result.inverse_w.values[1]), 1e-16);
}

TEST_F(Attributes, TheInverseOfAPowerOfTwoIsANumber) {
  for (const float w : {0.25F, 1.0F, 4.0F}) {
    for (Vertex& vertex : draw().vertices) vertex.w = w;
    const Interval inverse = attributes().inverse_w.values[1];
    EXPECT_EQ(inverse.low, 1 / static_cast<double>(w));
    EXPECT_EQ(inverse.high, inverse.low);
  }
}

TEST_F(Attributes, DetailsAreOnlyWhatWasAsked) {
  const PrimitiveAttributes given = attributes();
  const QuadPixel pixel{{5, 4}, {4, 4}};
  const Fragment fragment = shade(primitive(), given, pixel.pixel);
  for (const bool coordinates : {false, true})
    for (const bool derivatives : {false, true}) {
      const FragmentDetail detail = details_at(given, pixel, {coordinates, derivatives});
      for (std::size_t i = 0; i < kDerivatives; ++i)
        EXPECT_EQ(detail.derivatives[i].has_value(), derivatives);
      const std::array<double, 4> expected{5.5, 4.5, fragment.depth, 1};
      EXPECT_EQ(detail.coordinates, coordinates ? std::optional(expected) : std::nullopt);
      EXPECT_EQ(detail.derivatives[0].value_or(std::array<double, 4>{})[0] != 0, derivatives);
    }
}

TEST_F(Attributes, EachFormOfADerivativeFollowsItsOwnMethod) {
  draw().vertices[2].w = 4;
  choices_.values.derivatives = {DerivativeMethod::analytic, DerivativeMethod::forward,
                                 DerivativeMethod::coarse_top_right};
  const PrimitiveAttributes given = attributes();
  const QuadPixel pixel{{5, 4}, {4, 4}};
  const FragmentDetail detail = details_at(given, pixel, {false, true});
  EXPECT_NE(detail.derivatives[0].value()[3], 0);
  for (std::size_t d = 0; d < kDerivatives; ++d)
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_EQ(detail.derivatives[d].value()[c],
                middle(derivative_exact(given.color[c], pixel, d % 2 == 0 ? Axis::x : Axis::y,
                                        choices_.values.derivatives[d / 2])));
}

void expect_derivatives_of_each(const PrimitiveAttributes& given, PixelPosition at,
                                CentreColors& colors) {
  const QuadPixel pixel = in_quad(at, RowOrder::bottom_up, 8);
  for (const DerivativeMethod method : values_of<DerivativeMethod>())
    for (const Axis axis : {Axis::x, Axis::y}) {
      const CentreColors::Derivatives known = colors.derivatives(pixel, axis, method);
      for (std::size_t c = 0; c < 4; ++c) {
        const Interval alone = derivative_exact(given.color[c], pixel, axis, method);
        ASSERT_EQ(known.exact[c].low, alone.low);
        ASSERT_EQ(known.exact[c].high, alone.high);
        ASSERT_EQ(known.middles[c], middle(alone));
      }
    }
}

// To the bit, whatever was asked for before: of narrow targets, too, where neighbours are kept in
// one place, of rows in either order, and of one primitive after another.
TEST_F(Attributes, DerivativesOfManyPixelsAreThoseOfEach) {
  draw().vertices[2].w = 4;
  const PrimitiveAttributes one = attributes();
  draw().vertices[1].w = 2;
  const PrimitiveAttributes another = attributes();
  draw().interpolation = Interpolation::noperspective;
  draw().vertices[0].color[1] = 0.3F;
  PrimitiveAttributes other = attributes();
  // A quotient of which no more is known, the same at all vertices.
  other.color[2].values.fill(Interval(0.25, 0.5));
  for (const int width : {1, 2, 16}) {
    CentreColors colors(width);
    for (const auto* given :
         std::array<const PrimitiveAttributes*, 4>{&one, &another, &other, &one}) {
      colors.take(given->color);
      for (const bool upwards : {true, false})
        for (int row = 0; row < 8; ++row)
          for (int x = 0; x < width; ++x)
            expect_derivatives_of_each(*given, {x, upwards ? row : 7 - row}, colors);
    }
  }
}

TEST_F(Attributes, TexturedDrawsInterpolateWhereTheyAreLookedUp) {
  for (std::size_t v = 0; v < 3; ++v)
    draw().vertices[v].texture_coordinates = {1 + static_cast<float>(v), 7 - static_cast<float>(v)};
  EXPECT_EQ(attributes().color[0].values[1].low, static_cast<double>(draw().vertices[1].color[0]));
  draw().texture.emplace();
  for (const Interpolation interpolation : {Interpolation::smooth, Interpolation::flat}) {
    draw().interpolation = interpolation;
    const PrimitiveAttributes given = attributes();
    for (std::size_t v = 0; v < 3; ++v) {
      const auto shown = static_cast<double>(interpolation == Interpolation::flat ? 2 : v);
      const std::array<double, 4> expected{1 + shown, 7 - shown, 0, 1};
      for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_EQ(given.color[c].values[v].low, expected[c]);
        EXPECT_EQ(given.color[c].values[v].high, expected[c]);
      }
    }
  }
}

TEST_F(Attributes, LookupsAreReportedOnRequest) {
  ExactLookup lookup;
  lookup.coordinates = {Interval(0.25), Interval(3)};
  lookup.queried = {2, 2.5};
  lookup.color = {Interval(0.125), Interval(0.5, 0.75), Interval(7), Interval(1)};
  const PrimitiveAttributes given = attributes();
  const QuadPixel pixel{{5, 4}, {4, 4}};
  EXPECT_EQ(shade(primitive(), given, pixel.pixel, &lookup).color,
            (std::array<double, 4>{0.125, 0.625, 7, 1}));
  for (const bool asked : {false, true})
    for (const bool textured : {false, true}) {
      const FragmentDetail detail =
          details_at(given, pixel, {false, false, asked}, textured ? &lookup : nullptr);
      const bool reported = asked && textured;
      using Pair = std::optional<std::array<double, 2>>;
      EXPECT_EQ(detail.texture_coordinates, reported ? Pair({0.25, 3}) : Pair());
      EXPECT_EQ(detail.level_of_detail, reported ? Pair({2, 2.5}) : Pair());
    }
}

TEST_F(Attributes, AFragmentIsThatOfItsPixelAndPrimitive) {
  scene_.draws.push_back(scene_.draws[0]);
  const ScenePrimitive second = primitives_of(scene_).at(1);
  const PrimitiveAttributes given = attributes_of(second, choices_, scene_.target);
  const Fragment fragment = shade(second, given, {7, 5});
  EXPECT_EQ(fragment.x, 7);
  EXPECT_EQ(fragment.y, 5);
  EXPECT_EQ(fragment.primitive, 1);
  EXPECT_EQ(fragment.depth, middle(interpolate_exact(given.depth, at(7.5, 5.5))));
  for (std::size_t c = 0; c < 4; ++c)
    EXPECT_EQ(fragment.color[c], middle(interpolate_exact(given.color[c], at(7.5, 5.5))));
}

TEST(Middle, LiesHalfway) {
  EXPECT_EQ(middle(Interval(0.25, 0.75)), 0.5);
  EXPECT_EQ(middle(Interval(-3, -1)), -2);
  EXPECT_EQ(middle(Interval(0.1)), 0.1);
}

}  // namespace
}  // namespace edgecase
