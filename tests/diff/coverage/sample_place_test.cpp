// SPDX-License-Identifier: MIT
//
// Where a sample lies by what is covered: the box holds the place with which the scene was drawn,
// wherever in the pixel or beside it that is; and there is none where a sample would have to lie in
// two places.
#include "diff/coverage/sample_place.h"

#include <gtest/gtest.h>

#include <random>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

constexpr int kSide = 12;  // pixels

Fixed sixteenths(int n) {
  return Fixed::from_raw(n * (Fixed::kOne / 16));
}

class Places {
 public:
  explicit Places(Primitive primitive) {
    scene_.target.width = scene_.target.height = kSide;
    scene_.target.samples = 2;
    scene_.viewport = {0, 0, kSide, kSide};
    Draw draw;
    draw.primitive = primitive;
    draw.line_width = Fixed::from_integer(2);
    scene_.draws.push_back(std::move(draw));
  }

  void add(Point p) {
    Vertex vertex;
    vertex.position = p;
    scene_.draws.front().vertices.push_back(vertex);
  }

  // Draws the scene with both samples at a place; changes are made before `box()`.
  std::vector<PrimitiveCoverage>& drawn_at(Point place) {
    primitives_ = primitives_of(scene_);
    for (const ScenePrimitive& primitive : primitives_) {
      const SampleCoverage covered =
          covered_samples(primitive, scene_.target, standard_choices().of(primitive.kind),
                          SamplePositions{place, place});
      coverage_.push_back({covered, covered});
    }
    return coverage_;
  }

  std::optional<PlaceBox> box() const {
    const CoverageContext context{scene_, primitives_, coverage_, standard_choices()};
    return SamplePlaces(context).of(1);
  }

 private:
  Scene scene_;
  std::vector<ScenePrimitive> primitives_;
  std::vector<PrimitiveCoverage> coverage_;
};

Point random_place(std::mt19937& random, int low, int high) {
  const auto one = [&] {
    return sixteenths(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
  };
  const Fixed x = one();
  return {x, one()};
}

TEST(SamplePlace, TheBoxHoldsThePlace) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    Places places(i % 3 == 0 ? Primitive::lines : Primitive::triangles);
    for (int n = 0; n < 6; ++n) places.add(random_place(random, 16, 16 * (kSide - 1)));
    const Point place = random_place(random, -15, 31);
    places.drawn_at(place);
    const auto box = places.box();
    ASSERT_TRUE(box) << i;
    EXPECT_TRUE(box->x.contains(place.x.to_double())) << i;
    EXPECT_TRUE(box->y.contains(place.y.to_double())) << i;
  }
}

// The diagonals of the target, in steps of whole pixels, pass the sample at every distance.
TEST(SamplePlace, EdgesOfManySlopesNarrowIt) {
  std::mt19937 random(2);
  Places places(Primitive::triangles);
  for (int n = 0; n < 120; ++n) places.add(random_place(random, 16, 16 * (kSide - 1)));
  places.drawn_at({sixteenths(5), sixteenths(11)});
  const auto box = places.box();
  ASSERT_TRUE(box);
  EXPECT_LT(box->x.high - box->x.low, 0.5);
  EXPECT_LT(box->y.high - box->y.low, 0.5);
}

TEST(SamplePlace, WhatIsCoveredOnAllSidesLiesNowhere) {
  Places places(Primitive::triangles);
  for (const auto& [x, y] : {std::pair(40, 40), std::pair(120, 44), std::pair(60, 130)})
    places.add({sixteenths(x), sixteenths(y)});
  std::vector<PrimitiveCoverage>& coverage = places.drawn_at(centre_of_pixel());
  // Everything that the triangle touches, as a conservative rasterizer has it.
  std::vector<PixelPosition>& drawn = coverage[0].drawn[1];
  std::vector<PixelPosition> wider;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      if (std::ranges::any_of(drawn, [&](PixelPosition p) {
            return std::abs(p.x - x) <= 1 && std::abs(p.y - y) <= 1;
          }))
        wider.push_back({x, y});
  drawn = wider;
  EXPECT_FALSE(places.box());
}

TEST(SamplePlace, ALineThatIsLostLiesNowhere) {
  Places places(Primitive::lines);
  for (const auto& [x, y] : {std::pair(40, 40), std::pair(120, 44)})
    places.add({sixteenths(x), sixteenths(y)});
  places.drawn_at(centre_of_pixel())[0].drawn[1].clear();
  EXPECT_FALSE(places.box());
}

// One hole says no more than that the sample lies elsewhere; beside an edge it may.
TEST(SamplePlace, APixelBesideAnEdgeMovesIt) {
  Places places(Primitive::triangles);
  for (const auto& [x, y] : {std::pair(40, 40), std::pair(136, 40), std::pair(40, 136)})
    places.add({sixteenths(x), sixteenths(y)});
  std::vector<PixelPosition>& drawn = places.drawn_at(centre_of_pixel())[0].drawn[1];
  std::erase_if(drawn, [](PixelPosition p) { return p.y == 2; });
  const auto box = places.box();
  ASSERT_TRUE(box);
  EXPECT_LE(box->y.high, 0.5 + 1.0 / 16 + 1.0 / 256);  // a step of 4 bits, and a square
}

}  // namespace
}  // namespace edgecase
