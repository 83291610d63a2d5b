// SPDX-License-Identifier: MIT
#include "model/text.h"

#include <gtest/gtest.h>

#include "model/fnv.h"

namespace edgecase {
namespace {

TEST(Counted, GroupsDigitsByThree) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(30718), "30,718");
  EXPECT_EQ(grouped(1234567), "1,234,567");
}

TEST(Counted, OneIsSingular) {
  EXPECT_EQ(counted(0, "case", "cases"), "0 cases");
  EXPECT_EQ(counted(1, "case", "cases"), "1 case");
  EXPECT_EQ(counted(2000, "case is", "cases are"), "2,000 cases are");
}

TEST(Fnv, HasThePublishedValues) {
  EXPECT_EQ(fnv_of(""), 0xcbf29ce484222325u);
  EXPECT_EQ(fnv_of("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(fnv_of("foobar"), 0x85944171f73967e8u);
  EXPECT_EQ(fnv_of("bar", fnv_of("foo")), fnv_of("foobar"));
}

}  // namespace
}  // namespace edgecase
