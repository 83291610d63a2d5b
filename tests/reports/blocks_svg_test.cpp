// SPDX-License-Identifier: MIT
#include "reports/blocks_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <sstream>
#include <string>

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using Kind = DrawnBlock::Kind;

// Two by two blocks of 4 of which one is of each kind, all parts of one that is divided.
BlocksPanel panel() {
  BlocksPanel panel;
  panel.name = "primitive 3";
  panel.outline = {MarkRole::primitive, true, {{0, 0}, {8, 0}, {8, 8}}, ""};
  panel.blocks = {{Kind::divided, 0, 0, 8, 8, -1},
                  {Kind::tested, 0, 0, 4, 4, -1},
                  {Kind::accepted, 4, 0, 4, 4, -1},
                  {Kind::rejected, 0, 4, 4, 4, 2},
                  {Kind::tested, 4, 4, 4, 4, -1}};
  panel.samples = {{{0.5, 0.5}, true}, {{0.5, 1.5}, false}, {{4.5, 5.5}, false}};
  panel.caption = {"one line", "another & <one>"};
  return panel;
}

std::string text_of(const BlocksPicture& picture) {
  std::ostringstream out;
  write_blocks_svg(picture, out);
  return out.str();
}

pugi::xml_document drawn(std::size_t panels) {
  BlocksPicture picture{8, 8, "A\ntitle", {}};
  for (std::size_t i = 0; i < panels; ++i) picture.panels.push_back(panel());
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(text_of(picture).c_str()));
  return document;
}

std::size_t count(const pugi::xml_document& document, const std::string& path) {
  return document.select_nodes(path.c_str()).size();
}

TEST(BlocksSvg, EachBlockHasThePatternOfItsKind) {
  const auto document = drawn(1);
  EXPECT_EQ(count(document, "/svg/g/rect[@class='accepted']"), 1u);
  EXPECT_EQ(count(document, "/svg/g/rect[@class='rejected']"), 1u);
  EXPECT_EQ(count(document, "/svg/g/rect[@class='tested']"), 2u);
  EXPECT_EQ(count(document, "/svg/g/rect[@class='divided']"), 1u);
  EXPECT_EQ(count(document, "/svg/defs/pattern[@id='accepted' or @id='rejected']"), 2u);
  EXPECT_THAT(document.child("svg").child("style").text().get(),
              HasSubstr(".accepted{fill:url(#accepted)}"));
  // The number of the edge that rejects a block stands in its middle.
  const auto number = document.select_node("/svg/g/text[@class='number']").node();
  EXPECT_STREQ(number.text().get(), "2");
  const auto block = document.select_node("/svg/g/rect[@class='rejected']").node();
  EXPECT_EQ(number.attribute("x").as_double(),
            block.attribute("x").as_double() + block.attribute("width").as_double() / 2);
}

TEST(BlocksSvg, BlocksLieWhereTheirPixelsDoWithYUp) {
  const auto document = drawn(1);
  const auto target = document.select_node("/svg/g/rect[@class='target']").node();
  const auto accepted = document.select_node("/svg/g/rect[@class='accepted']").node();
  const double half = target.attribute("width").as_double() / 2;
  EXPECT_EQ(accepted.attribute("x").as_double(), half);
  EXPECT_EQ(accepted.attribute("y").as_double(), target.attribute("y").as_double() + half);
  EXPECT_EQ(accepted.attribute("width").as_double(), half);
}

TEST(BlocksSvg, SamplesOfTestedBlocksAreFullOrEmptyDots) {
  const auto document = drawn(1);
  EXPECT_EQ(count(document, "/svg/g/circle[@class='covered']"), 1u);
  EXPECT_EQ(count(document, "/svg/g/circle[@class='uncovered']"), 2u);
}

// Edges along the target's border have theirs within.
TEST(BlocksSvg, EachEdgeHasItsNumberOnTheTarget) {
  const auto document = drawn(1);
  const auto target = document.select_node("/svg/g/rect[@class='target']").node();
  const double right = target.attribute("width").as_double();
  const double top = target.attribute("y").as_double();
  const auto badges = document.select_nodes("/svg/g/g/circle[@class='edge']");
  ASSERT_EQ(badges.size(), 3u);
  for (const auto& badge : badges) {
    EXPECT_GE(badge.node().attribute("cx").as_double(), 8);
    EXPECT_LE(badge.node().attribute("cx").as_double(), right - 8);
    EXPECT_GE(badge.node().attribute("cy").as_double(), top + 8);
    EXPECT_LE(badge.node().attribute("cy").as_double(), top + right - 8);
  }
  // The diagonal's lies above it, where the triangle does not.
  const auto diagonal = badges[2].node();
  EXPECT_LT(diagonal.attribute("cy").as_double() - top,
            right - diagonal.attribute("cx").as_double());
}

TEST(BlocksSvg, PanelsAreLaidOutInRowsOnPaperOfTheirSize) {
  const auto one = drawn(1), five = drawn(5);
  EXPECT_EQ(count(five, "/svg/g"), 5u);
  const auto paper = five.select_node("/svg/rect[@class='paper']").node();
  EXPECT_STREQ(paper.attribute("height").value(), five.child("svg").attribute("height").value());
  const auto target = one.select_node("/svg/g/rect[@class='target']").node();
  EXPECT_GT(
      five.child("svg").attribute("height").as_double(),
      one.child("svg").attribute("height").as_double() + target.attribute("height").as_double());
  EXPECT_LE(five.child("svg").attribute("width").as_double(), 1130);
}

TEST(BlocksSvg, TextIsEscapedAndTheSameEachTime) {
  BlocksPicture picture{8, 8, "A\ntitle", {panel()}};
  EXPECT_THAT(text_of(picture), HasSubstr("another &amp; &lt;one&gt;"));
  EXPECT_EQ(text_of(picture), text_of(picture));
}

}  // namespace
}  // namespace edgecase
