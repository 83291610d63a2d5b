// SPDX-License-Identifier: MIT
#include "rules/coverage/triangle_fill.h"

#include <gtest/gtest.h>

#include "tests/support/points.h"

namespace edgecase {
namespace {

std::string draw(const Triangle& triangle, std::string_view ties, int size) {
  std::string rows;
  for (int y = size - 1; y >= 0; --y) {
    for (int x = 0; x < size; ++x)
      rows += triangle_covers(triangle, x, y, *find_tie_rule(ties)) ? '#' : '.';
    rows += '/';
  }
  return rows;
}

// Legs through pixel centres; the right angle at the lower left.
const Triangle kLowerLeft{at(0.5, 0.5), at(2.5, 0.5), at(0.5, 2.5)};

TEST(TriangleFill, EachOrderOwnsTheEdgesThatItsNameSays) {
  EXPECT_EQ(draw(kLowerLeft, "left-bottom", 3), ".../#../##./");
  EXPECT_EQ(draw(kLowerLeft, "left-top", 3), ".../#../.../");
  EXPECT_EQ(draw(kLowerLeft, "right-top", 3), ".../.#./.../");
  EXPECT_EQ(draw(kLowerLeft, "open", 3), ".../.../.../");
  EXPECT_EQ(draw(kLowerLeft, "closed", 3), "#../##./###/");
}

TEST(TriangleFill, WindingDoesNotMatter) {
  const Triangle reversed{kLowerLeft[0], kLowerLeft[2], kLowerLeft[1]};
  for (const TieRule& rule : all_tie_rules())
    EXPECT_EQ(draw(kLowerLeft, rule.name, 3), draw(reversed, rule.name, 3)) << rule.name;
}

TEST(TriangleFill, WithoutAreaNothingIsDrawn) {
  for (const TieRule& rule : all_tie_rules())
    EXPECT_EQ(draw({at(0, 0), at(1.5, 1.5), at(3, 3)}, rule.name, 3), ".../.../.../") << rule.name;
}

TEST(TriangleFill, CoordinatesAtTheEndOfTheRangeDoNotOverflow) {
  const Triangle huge{at(-8192, -8192), at(8192, -8192), at(-8192, 8192)};
  EXPECT_TRUE(triangle_covers(huge, -8192, -8192, *find_tie_rule("left-top")));
  EXPECT_TRUE(triangle_covers(huge, 0, -2, *find_tie_rule("left-top")));
  EXPECT_FALSE(triangle_covers(huge, 8191, 8191, *find_tie_rule("left-top")));
}

TEST(TriangleFill, ExplanationNamesEdgeOwnershipAndDistance) {
  const TieRule& rule = *find_tie_rule("left-top");
  const std::string tie = explain_triangle(kLowerLeft, 0, 1, rule).text;
  EXPECT_NE(tie.find("exactly on the left edge (0.5, 2.5) to (0.5, 0.5), which left-top counts as "
                     "inside"),
            std::string::npos)
      << tie;
  const std::string outside = explain_triangle(kLowerLeft, 2, 2, rule).text;
  EXPECT_NE(outside.find("1.41421 pixels outside the right edge"), std::string::npos) << outside;
}

}  // namespace
}  // namespace edgecase
