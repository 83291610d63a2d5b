// SPDX-License-Identifier: MIT
//
// Names are what case files, JSON and reports share: every value has one of its own, and it reads
// back.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "model/figure.h"
#include "model/renderer.h"
#include "model/scene.h"
#include "model/verdict.h"

namespace edgecase {
namespace {

template <class Enum>
void expect_distinct(const std::vector<Enum>& values) {
  std::set<std::string> names;
  for (Enum value : values) {
    EXPECT_STRNE(name_of(value), "?");
    EXPECT_TRUE(names.insert(name_of(value)).second) << name_of(value);
  }
  EXPECT_STREQ(name_of(static_cast<Enum>(99)), "?");
}

template <class Enum>
void expect_round_trip(const std::vector<Enum>& values) {
  expect_distinct(values);
  for (Enum value : values) {
    // Start from another value, so that a parse that does nothing is found out.
    Enum read = values.front() == value ? values.back() : values.front();
    EXPECT_TRUE(parse_name(name_of(value), read)) << name_of(value);
    EXPECT_EQ(read, value);
  }
  for (const std::string wrong : {"", "?", "Points", "points ", "none"}) {
    Enum untouched = values.back();
    EXPECT_FALSE(parse_name(wrong, untouched)) << wrong;
    EXPECT_EQ(untouched, values.back());
  }
}

TEST(Names, OfScenesReadBack) {
  expect_round_trip<Primitive>({Primitive::points, Primitive::lines, Primitive::line_strip,
                                Primitive::line_loop, Primitive::triangles,
                                Primitive::triangle_strip, Primitive::triangle_fan});
  expect_round_trip<Interpolation>(
      {Interpolation::flat, Interpolation::smooth, Interpolation::noperspective});
  expect_round_trip<ProvokingVertex>({ProvokingVertex::first, ProvokingVertex::last});
  expect_round_trip<Surface>({Surface::fbo, Surface::window});
  expect_round_trip<ColorFormat>({ColorFormat::rgba8});
}

TEST(Names, OfVerdictsReadBack) {
  expect_round_trip<Verdict>({Verdict::agree, Verdict::convention, Verdict::permitted,
                              Verdict::contested, Verdict::violation, Verdict::not_run});
  EXPECT_STREQ(name_of(Verdict::not_run), "not-run");
}

TEST(Names, OfKindsRolesAndFailuresAreDistinct) {
  expect_distinct<PrimitiveKind>(
      {PrimitiveKind::point, PrimitiveKind::line, PrimitiveKind::triangle});
  expect_distinct<DisagreementKind>({DisagreementKind::missing, DisagreementKind::extra,
                                     DisagreementKind::duplicate, DisagreementKind::value});
  expect_distinct<MarkRole>({MarkRole::primitive, MarkRole::vertex, MarkRole::snapped_vertex,
                             MarkRole::region, MarkRole::owned, MarkRole::sample, MarkRole::edge});
  expect_distinct<FailureKind>({FailureKind::unsupported, FailureKind::crashed,
                                FailureKind::timed_out, FailureKind::garbage,
                                FailureKind::unavailable, FailureKind::internal});
}

}  // namespace
}  // namespace edgecase
