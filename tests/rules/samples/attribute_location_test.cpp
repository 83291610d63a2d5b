// SPDX-License-Identifier: MIT
//
// Where attributes are evaluated, for every mask of the standard pattern of 4.
#include "rules/samples/attribute_location.h"

#include <gtest/gtest.h>

#include <bit>

#include "rules/samples/sample_placement.h"

namespace edgecase {
namespace {

// No constant of this file: those that it is made of may be initialised later.
const SamplePositions& pattern() {
  static const SamplePositions positions = standard_pattern(4);
  return positions;
}

Point sixteenths(int x, int y) {
  return {Fixed::from_raw(x * Fixed::kOne / 16), Fixed::from_raw(y * Fixed::kOne / 16)};
}

Point first_of(std::uint32_t mask) {
  for (std::size_t s = 0; s < 4; ++s)
    if ((mask >> s & 1) != 0) return pattern()[s];
  return {};
}

Point place(AttributeLocation qualifier, std::uint32_t mask, const LocationChoice& choice = {},
            PrimitiveKind kind = PrimitiveKind::triangle) {
  return attribute_location(qualifier, {kind, mask, false}, pattern(), choice);
}

TEST(AttributeLocation, OfEveryMask) {
  LocationChoice first;
  first.plain = PlainLocation::first_covered;
  first.centroid = CentroidLocation::first_covered;
  LocationChoice centre;
  centre.centroid = CentroidLocation::centre;
  for (std::uint32_t mask = 1; mask < 16; ++mask) {
    const Point covered = first_of(mask);
    EXPECT_EQ(place(AttributeLocation::center, mask), centre_of_pixel());
    EXPECT_EQ(place(AttributeLocation::center, mask, first), covered);
    EXPECT_EQ(place(AttributeLocation::centroid, mask), mask == 15 ? centre_of_pixel() : covered);
    EXPECT_EQ(place(AttributeLocation::centroid, mask, first), covered);
    EXPECT_EQ(place(AttributeLocation::centroid, mask, centre), centre_of_pixel());
    if (std::popcount(mask) != 1) continue;
    // Of an invocation for one sample all attributes are the sample's.
    for (AttributeLocation qualifier :
         {AttributeLocation::center, AttributeLocation::centroid, AttributeLocation::sample})
      EXPECT_EQ(attribute_location(qualifier, {PrimitiveKind::line, mask, true}, pattern(), centre),
                covered);
    EXPECT_EQ(coordinates_location({PrimitiveKind::line, mask, true}, pattern()), covered);
    EXPECT_EQ(fragment_depth_location({PrimitiveKind::line, mask, true}, pattern(), {}), covered);
  }
  EXPECT_EQ(coordinates_location({PrimitiveKind::line, 5, false}, pattern()), centre_of_pixel());
}

TEST(AttributeLocation, MeansOfCoveredSamples) {
  LocationChoice mean;
  mean.centroid = CentroidLocation::mean_covered;
  const auto at = [&](std::uint32_t mask) {
    return place(AttributeLocation::centroid, mask, mean);
  };
  EXPECT_EQ(at(15), sixteenths(8, 8));
  EXPECT_EQ(at(0b0101), sixteenths(4, 6));
  EXPECT_EQ(at(0b0110), sixteenths(8, 8));
  EXPECT_EQ(at(0b1000), sixteenths(10, 14));
  // 22/3 of a sixteenth: 30037.33 of 2^-16.
  EXPECT_EQ(at(0b0111).x.raw(), 30037);
  EXPECT_EQ(at(0b0111).y, sixteenths(0, 6).y);
}

TEST(AttributeLocation, HalfAPixelOffOfPointsAndLines) {
  LocationChoice off;
  off.plain = PlainLocation::half_pixel_off;
  off.depth = DepthLocation::half_pixel_off;
  for (PrimitiveKind kind : {PrimitiveKind::point, PrimitiveKind::line}) {
    EXPECT_EQ(place(AttributeLocation::center, 1, off, kind), sixteenths(16, 16));
    EXPECT_EQ(place(AttributeLocation::centroid, 1, off, kind), sixteenths(14, 10));
    EXPECT_EQ(sample_depth_location(kind, pattern()[1], off), sixteenths(22, 14));
    EXPECT_EQ(fragment_depth_location({kind, 1, false}, pattern(), off), sixteenths(16, 16));
    EXPECT_EQ(coordinates_location({kind, 1, false}, pattern()), sixteenths(8, 8));
  }
  EXPECT_EQ(place(AttributeLocation::center, 1, off), sixteenths(8, 8));
  EXPECT_EQ(sample_depth_location(PrimitiveKind::triangle, pattern()[1], off), pattern()[1]);
}

TEST(AttributeLocation, DepthOfSamples) {
  const auto at = [](DepthLocation depth) {
    LocationChoice choice;
    choice.depth = depth;
    return std::pair{
        sample_depth_location(PrimitiveKind::triangle, pattern()[2], choice),
        fragment_depth_location({PrimitiveKind::triangle, 4, true}, pattern(), choice)};
  };
  EXPECT_EQ(at(DepthLocation::at_sample), (std::pair{sixteenths(2, 10), sixteenths(2, 10)}));
  EXPECT_EQ(at(DepthLocation::centre), (std::pair{sixteenths(8, 8), sixteenths(8, 8)}));
  EXPECT_EQ(at(DepthLocation::mirrored_x), (std::pair{sixteenths(14, 10), sixteenths(10, 2)}));
}

// One that nothing is said of stands for sample 0 of a triangle, and for others if it likes.
TEST(AttributeLocation, OfAnInvocationThatNothingIsSaidOf) {
  LocationChoice first;
  first.plain = PlainLocation::first_covered;
  EXPECT_EQ(attribute_location(AttributeLocation::center, {}, pattern(), first), pattern()[0]);
  EXPECT_EQ(attribute_location(AttributeLocation::center, {}, pattern(), {}), centre_of_pixel());
}

TEST(AttributeLocation, DepthOfAFragmentWithoutSample0) {
  LocationChoice zero;
  zero.depth = DepthLocation::mirrored_x_or_zero;
  Multisampling use;
  EXPECT_FALSE(fragment_depth_is_zero(use, zero));
  use.mask = 0b0001;
  EXPECT_FALSE(fragment_depth_is_zero(use, zero));
  use.mask = 0b1110;
  EXPECT_TRUE(fragment_depth_is_zero(use, zero));
  EXPECT_FALSE(fragment_depth_is_zero(use, {}));
  use.enabled = false;
  EXPECT_FALSE(fragment_depth_is_zero(use, zero));
}

TEST(AttributeLocation, NamesAreReadBack) {
  for (PlainLocation choice : values_of<PlainLocation>()) {
    PlainLocation read = PlainLocation::centre;
    EXPECT_TRUE(parse_name(name_of(choice), read));
    EXPECT_EQ(read, choice);
    EXPECT_FALSE(parse_name("corner", read));
  }
  for (CentroidLocation choice : values_of<CentroidLocation>()) {
    CentroidLocation read = CentroidLocation::centre;
    EXPECT_TRUE(parse_name(name_of(choice), read));
    EXPECT_EQ(read, choice);
    EXPECT_FALSE(parse_name("corner", read));
  }
  for (DepthLocation choice : values_of<DepthLocation>()) {
    DepthLocation read = DepthLocation::centre;
    EXPECT_TRUE(parse_name(name_of(choice), read));
    EXPECT_EQ(read, choice);
    EXPECT_FALSE(parse_name("corner", read));
  }
}

}  // namespace
}  // namespace edgecase
