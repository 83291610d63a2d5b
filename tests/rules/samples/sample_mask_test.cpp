// SPDX-License-Identifier: MIT
#include "rules/samples/sample_mask.h"

#include <gtest/gtest.h>

namespace edgecase {
namespace {

TEST(MultisampleSwitch, WhatBecomesOfEachKindOfPrimitive) {
  using Switch = MultisampleSwitch;
  for (const PrimitiveKind kind :
       {PrimitiveKind::point, PrimitiveKind::line, PrimitiveKind::triangle}) {
    EXPECT_EQ(unsampled(kind, Switch::honoured), Unsampled::by_centre);
    EXPECT_EQ(unsampled(kind, Switch::depth_of_first), Unsampled::by_centre);
    EXPECT_EQ(unsampled(kind, Switch::ignored), Unsampled::by_each_sample);
    if (kind == PrimitiveKind::line) continue;
    EXPECT_EQ(unsampled(kind, Switch::ignored_but_for_lines), Unsampled::by_each_sample);
    EXPECT_EQ(unsampled(kind, Switch::ignored_but_whole_lines), Unsampled::by_each_sample);
  }
  EXPECT_EQ(unsampled(PrimitiveKind::line, Switch::ignored_but_for_lines), Unsampled::by_centre);
  EXPECT_EQ(unsampled(PrimitiveKind::line, Switch::ignored_but_whole_lines),
            Unsampled::whole_pixels);
}

}  // namespace
}  // namespace edgecase
