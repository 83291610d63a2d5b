// SPDX-License-Identifier: MIT
#include "reports/gallery.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <regex>
#include <sstream>
#include <string>

namespace edgecase {
namespace {

const std::string kHostile = "</title><script>alert(1)</script><img src=x onerror=\"a\">&amp;\x01'";

// 2 x 2 pixels of one grey each, from the bottom left.
GalleryImage image_of(std::array<int, 4> greys, std::vector<int> hits = {1, 1, 1, 1}) {
  GalleryImage image;
  for (const int grey : greys)
    for (const int component : {grey, grey, grey, 255})
      image.pixels.push_back(static_cast<std::uint8_t>(component));
  image.hits = std::move(hits);
  return image;
}

GalleryEntry entry_of(const std::string& heading) {
  GalleryEntry entry;
  entry.case_id = "lines/one";
  entry.heading = heading;
  entry.text = "Look at it.";
  entry.origin = "A line";
  entry.width = 2;
  entry.height = 2;
  entry.policy = image_of({10, 20, 30, 40});
  entry.opengl = image_of({10, 20, 30, 40});
  entry.rendered = image_of({10, 20, 30, 40}, {});
  entry.verdict = Verdict::agree;
  return entry;
}

GalleryPage page_of(std::vector<GalleryEntry> entries) {
  GalleryPage page;
  page.tool = "edgecase 0";
  page.title = "A course";
  page.about = "About it.";
  page.policy = "mine";
  page.renderer = "osmesa:llvmpipe (llvmpipe)";
  page.sources = {"https://example.org/a?b=1&c=2", "a book"};
  page.links = {{"A course", ""}, {"Another", "another.html"}};
  page.choices = {{"triangle.fill-rule", "Inside", "Borders count.", "closed", "always", "left-top",
                   "moved", "illegal", ""},
                  {"depth.test", "Depth", "", "as-set", "as asked", "", "", "mandated", ""}};
  page.entries = std::move(entries);
  return page;
}

std::string written(const GalleryPage& page) {
  std::ostringstream out;
  write_gallery(page, out);
  return out.str();
}

// The page as a tree: it must be well-formed XML but for its head's void elements.
pugi::xml_document tree_of(const std::string& page) {
  pugi::xml_document document;
  const std::size_t begin = page.find("<main>");
  const std::size_t end = page.find("</main>") + 7;
  const auto parsed = document.load_string(page.substr(begin, end - begin).c_str());
  EXPECT_TRUE(parsed) << parsed.description();
  return document;
}

std::string text_of(const pugi::xml_node& node) {
  std::string text;
  for (const auto& found : node.select_nodes(".//text()")) text += found.node().value();
  return text;
}

TEST(Gallery, DifferencesAreCountedByKind) {
  const GalleryDifference difference = difference_of(image_of({10, 20, 30, 40}, {1, 1, 1, 2}),
                                                     image_of({10, 21, 50, 40}, {1, 5, 1, 1}));
  EXPECT_EQ(difference.colored, (std::vector<bool>{false, false, true, false}));
  EXPECT_EQ(difference.slightly, (std::vector<bool>{false, true, false, false}));
  EXPECT_EQ(difference.counted, (std::vector<bool>{false, false, false, true}));
  EXPECT_EQ(difference.colors, 2U);
  EXPECT_EQ(difference.counts, 1U);
  EXPECT_EQ(difference.largest, 20);
  // Counts are compared where both are known.
  EXPECT_EQ(difference_of(image_of({1, 1, 1, 1}, {}), image_of({1, 1, 1, 1}, {2, 2, 2, 2})).counts,
            0U);
}

TEST(Gallery, WordsSayWhichRulesMakeTheDifference) {
  GalleryEntry entry = entry_of("One");
  EXPECT_EQ(describe_contrast(entry), "The policy and OpenGL draw the same here.");
  entry.policy = image_of({10, 20, 33, 44}, {1, 1, 1, 1});
  entry.alone = {"line.algorithm"};
  EXPECT_EQ(describe_contrast(entry),
            "2 pixels have another colour, by up to 4 of 255: by line.algorithm alone. With it "
            "as OpenGL has it, the two pictures are the same.");
  entry.alone = {"line.algorithm", "line.snap"};
  EXPECT_NE(
      describe_contrast(entry).find("With line.algorithm or line.snap as OpenGL has it, each"),
      std::string::npos);
  entry.alone = {};
  entry.together = {"a.b", "c.d", "e.f"};
  EXPECT_NE(
      describe_contrast(entry).find("the same with a.b, c.d and e.f as OpenGL has them, and not "
                                    "with fewer."),
      std::string::npos);
  entry.together = {"a.b", "c.d", "e.f", "g.h"};
  EXPECT_NE(describe_contrast(entry).find("and not with any three of these."), std::string::npos);
  entry.policy = image_of({10, 20, 30, 40}, {1, 1, 1, 2});
  entry.alone = {"triangle.fill-rule"};
  EXPECT_EQ(describe_contrast(entry).find("1 pixel is drawn another number of times: by "), 0U);
}

TEST(Gallery, APageHasItsChoicesAndPictures) {
  const pugi::xml_document page = tree_of(written(page_of({entry_of("One"), entry_of("Two")})));
  EXPECT_EQ(page.select_nodes("//article").size(), 2U);
  EXPECT_EQ(page.select_nodes("//article//svg[@class='picture']").size(), 6U);
  EXPECT_EQ(page.select_nodes("//tbody/tr").size(), 2U);
  EXPECT_STREQ(
      page.select_node("//tbody/tr[1]//span[@class='badge b-violation']").node().child_value(),
      "forbidden");
  EXPECT_STREQ(page.select_node("//tbody/tr[2]//span[@class='badge b-agree']").node().child_value(),
               "as OpenGL");
  // Every link within the page leads somewhere.
  for (const auto& link : page.select_nodes("//a[starts-with(@href, '#')]")) {
    const std::string id = link.node().attribute("href").value() + 1;
    EXPECT_TRUE(page.select_node(("//*[@id='" + id + "']").c_str())) << id;
  }
  for (const auto& picture : page.select_nodes("//svg"))
    EXPECT_STRNE(picture.node().attribute("aria-label").value(), "");
}

TEST(Gallery, PixelsRunFromTheTopRow) {
  const pugi::xml_document page = tree_of(written(page_of({entry_of("One")})));
  // 30 is the upper left one, 10 the lower left one.
  EXPECT_STREQ(page.select_node("//path[@fill='#1e1e1e']").node().attribute("d").value(),
               "M0 0h1v1H0z");
  EXPECT_STREQ(page.select_node("//path[@fill='#0a0a0a']").node().attribute("d").value(),
               "M0 1h1v1H0z");
}

TEST(Gallery, WhatDiffersIsMarked) {
  GalleryEntry entry = entry_of("One");
  entry.policy = image_of({10, 20, 90, 41}, {2, 1, 1, 1});
  entry.alone = {"triangle.fill-rule"};
  const pugi::xml_document page = tree_of(written(page_of({entry})));
  // The upper left pixel is surrounded, the upper right one dotted, the lower left one has a ring.
  EXPECT_STREQ(page.select_node("//path[@class='mark']").node().attribute("d").value(),
               "M0 1v-1M0 1h1M1 1v-1M0 0h1");
  EXPECT_EQ(page.select_nodes("//path[@class='slight']").size(), 1U);
  const pugi::xml_node ring = page.select_node("//circle[@class='times']").node();
  EXPECT_EQ(ring.attribute("cx").as_double(), 0.5);
  EXPECT_EQ(ring.attribute("cy").as_double(), 1.5);
  // The choice names the picture.
  EXPECT_EQ(text_of(page.select_node("//tbody/tr[1]").node()).find("Seen in picture 1") ==
                std::string::npos,
            false);
}

TEST(Gallery, APictureThatWasNotDrawnSaysWhy) {
  GalleryEntry entry = entry_of("One");
  entry.rendered = {};
  entry.verdict = Verdict::not_run;
  entry.failure = "unavailable: there is no such library";
  const pugi::xml_document page = tree_of(written(page_of({entry})));
  EXPECT_EQ(page.select_nodes("//svg").size(), 2U);
  const std::string words = text_of(page.select_node("//article").node());
  EXPECT_NE(words.find("not-run"), std::string::npos);
  EXPECT_NE(words.find(entry.failure), std::string::npos);
}

TEST(Gallery, HostileTextsStayTexts) {
  GalleryEntry entry = entry_of(kHostile);
  entry.case_id = entry.text = entry.origin = kHostile;
  entry.otherwise = {kHostile};
  entry.policy = image_of({1, 2, 3, 4});
  entry.alone = {kHostile};
  GalleryPage page = page_of({entry});
  page.title = page.about = page.policy = page.renderer = page.tool = kHostile;
  page.sources = {"https://example.org/\"><script>alert(1)</script>", "javascript:alert(1)"};
  page.links = {{kHostile, ""}, {kHostile, "other.html"}};
  page.choices = {
      {kHostile, kHostile, kHostile, kHostile, kHostile, kHostile, kHostile, kHostile, kHostile}};
  const std::string html = written(page);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_EQ(html.find("href=\"javascript:"), std::string::npos);
  const pugi::xml_document tree = tree_of(html);
  EXPECT_EQ(tree.select_nodes("//*[@onerror]").size(), 0U);
  EXPECT_NE(text_of(tree.select_node("//h1").node()).find("<script>alert(1)</script>"),
            std::string::npos);
}

TEST(Gallery, LoadsNothing) {
  const std::string page = written(page_of({entry_of("One")}));
  EXPECT_NE(page.find("default-src 'none'; base-uri 'none'; form-action 'none'; style-src "
                      "'sha256-"),
            std::string::npos);
  EXPECT_EQ(page.find("unsafe-inline"), std::string::npos);
  EXPECT_EQ(page.find("script-src"), std::string::npos);
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_EQ(page.find("url("), std::string::npos);
  EXPECT_EQ(page.find("style=\""), std::string::npos);
  EXPECT_FALSE(std::regex_search(page, std::regex("<(script|link|img|iframe|object|embed|form)")));
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|srcset|poster|action|xlink:href)\\s*=")));
  EXPECT_EQ(page.find("{{"), std::string::npos);
}

TEST(Gallery, TheSamePageGivesTheSameBytes) {
  const GalleryPage page = page_of({entry_of("One"), entry_of("Two")});
  EXPECT_EQ(written(page), written(page));
  EXPECT_NE(written(page), written(page_of({entry_of("One")})));
}

}  // namespace
}  // namespace edgecase
