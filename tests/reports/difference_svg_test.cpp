// SPDX-License-Identifier: MIT
#include "reports/difference_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>
#include <string>

#include "tests/reports/sample.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Disagreement difference(int x, int y, DisagreementKind kind, double exact, double rendered,
                        bool legal = false) {
  Disagreement d = sample::disagreement(x, y, kind, legal);
  d.rule = rule_named("line.diamond-exit");
  d.ruling = 1;
  d.exact = {exact};
  d.rendered = {rendered};
  return d;
}

// A line along the middle row of 4 x 3 pixels, of which the renderer draws one pixel elsewhere and
// one twice.
DifferencePicture picture() {
  DifferencePicture picture;
  picture.width = 4;
  picture.height = 3;
  picture.title = "A line";
  picture.renderer = "exec:mine";
  picture.verdict = Verdict::violation;
  picture.exact_hits = {0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0};
  picture.figure.marks = {{MarkRole::primitive, false, {{0.5, 1.5}, {30, 1.5}}, "0"}};
  picture.disagreements = {difference(0, 1, DisagreementKind::missing, 1, 0),
                           difference(1, 1, DisagreementKind::duplicate, 1, 2),
                           difference(3, 2, DisagreementKind::extra, 0, 1)};
  picture.disagreements[0].figure.marks = {
      {MarkRole::region, true, {{0, 1.5}, {0.5, 1}, {1, 1.5}, {0.5, 2}}, ""},
      {MarkRole::sample, false, {{0.5, 1.5}}, ""}};
  picture.rendered_hits = rendered_hits(picture.exact_hits, picture.width, picture.disagreements);
  return picture;
}

std::string text_of(const DifferencePicture& picture) {
  std::ostringstream out;
  write_difference_svg(picture, out);
  return out.str();
}

pugi::xml_document parsed(const std::string& text) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(text.c_str()));
  return document;
}

std::size_t count(const pugi::xml_document& document, const std::string& path) {
  return document.select_nodes(path.c_str()).size();
}

TEST(DifferenceSvg, WhatTheRendererDrewFollowsFromTheDisagreements) {
  EXPECT_THAT(picture().rendered_hits, ElementsAre(0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0, 1));
}

TEST(DifferenceSvg, AValueChangesNoCoverage) {
  const auto value = difference(1, 1, DisagreementKind::value, 0.25, 0.75);
  EXPECT_EQ(rendered_hits(picture().exact_hits, 4, {value}), picture().exact_hits);
}

TEST(DifferenceSvg, EachPaneHasThePixelsOfItsSide) {
  const auto document = parsed(text_of(picture()));
  EXPECT_EQ(count(document, "/svg/g/g[1]/rect[@class='once']"), 3U);
  EXPECT_EQ(count(document, "/svg/g/g[1]/rect[@class='more']"), 0U);
  EXPECT_EQ(count(document, "/svg/g/g[2]/rect[@class='pale']"), 4U);
  EXPECT_EQ(count(document, "/svg/g/g[3]/rect[@class='once']"), 2U);
  EXPECT_EQ(count(document, "/svg/g/g[3]/rect[@class='more']"), 1U);
  EXPECT_EQ(count(document, "/svg/g/g[3]/rect[@class='none']"), 9U);
}

// A line of so many pixels in the middle of a large target.
DifferencePicture long_line(int length) {
  DifferencePicture large;
  large.width = 100;
  large.height = 50;
  large.exact_hits.assign(5000, 0);
  for (int x = 0; x < length; ++x)
    large.exact_hits[static_cast<std::size_t>(25 * 100 + 40 + x)] = 1;
  large.disagreements = {difference(41, 25, DisagreementKind::missing, 1, 0)};
  large.rendered_hits = rendered_hits(large.exact_hits, 100, large.disagreements);
  return large;
}

TEST(DifferenceSvg, PanesAreCroppedToWhatIsDrawnAndAPixelMore) {
  const auto document = parsed(text_of(long_line(4)));
  EXPECT_EQ(count(document, "/svg/g/g[1]/rect[@class='once' or @class='none']"), 6U * 3U);
  EXPECT_STREQ(document.select_node("/svg/g/g[1]/text[@class='column']").node().text().get(), "39");
}

TEST(DifferenceSvg, PanesOfALargeDrawingAreCroppedToWhatDiffers) {
  const auto document = parsed(text_of(long_line(60)));
  EXPECT_EQ(count(document, "/svg/g/g[1]/rect[@class='once' or @class='none']"), 9U * 9U);
  EXPECT_EQ(count(document, "/svg/g/g[1]/rect[@class='once']"), 6U);
}

TEST(DifferenceSvg, APaneAloneHasNoWords) {
  for (const char* name : {"exact", "difference", "renderer"}) {
    std::ostringstream out;
    write_pane_svg(picture(), *pane_named(name), out);
    const auto document = parsed(out.str());
    EXPECT_EQ(count(document, "//text[not(@class='digit')]"), 0U) << name;
    EXPECT_EQ(count(document, "//rect[@class='forbidden']"), 3U) << name;
    EXPECT_EQ(count(document, "//rect[@class='badge']"), name[0] == 'd' ? 3U : 0U) << name;
  }
  EXPECT_EQ(pane_named("all"), std::nullopt);
}

TEST(DifferenceSvg, YPointsUp) {
  const auto document = parsed(text_of(picture()));
  // (3, 2) is extra: of the frames the rightmost and the uppermost.
  double x = 0;
  double y = 1e9;
  for (const auto& node : document.select_nodes("/svg/g/g[3]/rect[@class='forbidden']")) {
    x = std::max(x, node.node().attribute("x").as_double());
    y = std::min(y, node.node().attribute("y").as_double());
  }
  EXPECT_NEAR(x, 3 * 42 + 1.2, 1e-9);
  EXPECT_NEAR(y, 22 + 1.2, 1e-9);
}

TEST(DifferenceSvg, KindsDifferInTheirSignsAndInTheLegend) {
  const auto document = parsed(text_of(picture()));
  EXPECT_EQ(count(document, "/svg/g/g[2]/rect[@class='badge']"), 3U);
  EXPECT_EQ(count(document, "/svg/g/g[2]/path[@class='sign']"), 2U);
  EXPECT_STREQ(document.select_node("/svg/g/g[2]/text[@class='digit']").node().text().get(), "2");
  const std::string text = text_of(picture());
  for (const char* words : {"1 missing", "1 extra", "1 drawn 2 times"})
    EXPECT_THAT(text, HasSubstr(words));
  EXPECT_THAT(text, Not(HasSubstr("allowed</text>")));
}

TEST(DifferenceSvg, APixelThatTwoPrimitivesDrawIsDrawnTwice) {
  DifferencePicture shared = picture();
  shared.disagreements = {difference(1, 1, DisagreementKind::extra, 0, 1)};
  shared.rendered_hits = rendered_hits(shared.exact_hits, 4, shared.disagreements);
  EXPECT_THAT(text_of(shared), HasSubstr("1 drawn 2 times"));
}

TEST(DifferenceSvg, WhatIsAllowedIsDashedAndSaysSo) {
  DifferencePicture allowed = picture();
  for (Disagreement& d : allowed.disagreements) d.legality = Legality::legal;
  const auto document = parsed(text_of(allowed));
  EXPECT_EQ(count(document, "//rect[@class='forbidden']"), 0U);
  EXPECT_EQ(count(document, "//rect[@class='allowed']"), 9U);
  EXPECT_THAT(text_of(allowed), HasSubstr("1 missing, allowed"));
}

TEST(DifferenceSvg, TheEvidenceIsInThePaneOfTheDifference) {
  const auto document = parsed(text_of(picture()));
  EXPECT_EQ(count(document, "//polygon[@class='region']"), 1U);
  EXPECT_EQ(count(document, "/svg/g/g[2]//polygon[@class='region']"), 1U);
  EXPECT_EQ(count(document, "//path[@class='sample']"), 1U);
  EXPECT_EQ(count(document, "//polyline[@class='line']"), 3U);
}

TEST(DifferenceSvg, WhatIsContestedHasASignOfItsOwn) {
  DifferencePicture contested = picture();
  for (Disagreement& d : contested.disagreements) d.legality = Legality::contested;
  const std::string text = text_of(contested);
  EXPECT_THAT(text, HasSubstr("class=\"contested\""));
  EXPECT_THAT(text, HasSubstr("class=\"badge contested-badge\""));
  EXPECT_THAT(text, HasSubstr(", contested</text>"));
  EXPECT_THAT(text, Not(HasSubstr("class=\"forbidden\"")));
}

TEST(DifferenceSvg, TheCaptionNamesTheFirstThatIsNotAllowed) {
  DifferencePicture mixed = picture();
  mixed.disagreements[0].legality = Legality::legal;
  EXPECT_THAT(text_of(mixed),
              HasSubstr("violation: pixel (1, 1) duplicate, line.diamond-exit, ruling 1"));
}

TEST(DifferenceSvg, WithoutDifferenceItSaysSo) {
  DifferencePicture same = picture();
  same.disagreements.clear();
  same.rendered_hits = same.exact_hits;
  same.verdict = Verdict::agree;
  const std::string text = text_of(same);
  EXPECT_THAT(text, HasSubstr("agree: nothing differs."));
  EXPECT_EQ(count(parsed(text), "//rect[@class='badge']"), 0U);
}

TEST(DifferenceSvg, HostileTextStaysText) {
  DifferencePicture hostile = picture();
  hostile.title = sample::kHostile;
  hostile.renderer = sample::kHostile;
  const std::string text = text_of(hostile);
  EXPECT_THAT(text, Not(HasSubstr("<script")));
  EXPECT_EQ(count(parsed(text), "//script"), 0U);
}

TEST(DifferenceSvg, TheSamePictureGivesTheSameBytes) {
  EXPECT_EQ(text_of(picture()), text_of(picture()));
}

}  // namespace
}  // namespace edgecase
