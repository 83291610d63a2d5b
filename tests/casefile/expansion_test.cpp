// SPDX-License-Identifier: MIT
//
// Sweeps: how many cases a file stands for, what they are called and what they draw.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "casefile/loader.h"

namespace edgecase {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Texts = std::vector<std::string>;

// A file with one line from (1, 2) to (3, 2) in a 4 x 4 target, and whatever else is asked for.
LoadedCases load(const std::string& rest, const std::string& id = "a") {
  return load_cases_text(R"({"title": "t", "rules": ["line.diamond-exit"],
 "target": {"width": 4, "height": 4},
 "draws": [{"primitive": "lines", "vertices": [[1, 2], {"at": [3, 2], "color": [1, 0, 0]}]}]
)" + rest + "}",
                         "a.json", id);
}

LoadedCases sweep(const std::string& axes, const std::string& rest = "") {
  return load(", \"sweep\": {" + axes + "}" + rest);
}

Texts ids(const LoadedCases& loaded) {
  Texts result;
  for (const Case& one : loaded.cases) result.push_back(one.id);
  return result;
}

Texts faults(const LoadedCases& loaded) {
  Texts result;
  for (const Diagnostic& one : loaded.diagnostics) result.push_back(to_string(one));
  return result;
}

const Vertex& vertex(const Case& one, std::size_t index) {
  return one.scene.draws[0].vertices[index];
}

const std::string kDx = R"("dx": {"add_to": ["/draws/0/vertices/0/x"], "values": ["-1/256", 0]})";
const std::string kDy =
    R"("dy": {"add_to": ["/draws/0/vertices/1/y"], "range": {"from": -1, "to": 1.5, "step": 1}})";
const std::string kRows = R"(["....", "....", "....", "...."])";

TEST(Expansion, AFileWithoutSweepKeepsItsId) {
  const LoadedCases loaded = load("");
  EXPECT_THAT(ids(loaded), ElementsAre("a"));
  EXPECT_TRUE(loaded.cases[0].parts.empty());
}

TEST(Expansion, AxesMultiplyInTheOrderOfTheFile) {
  const LoadedCases loaded = sweep(kDx + "," + kDy);
  EXPECT_THAT(ids(loaded),
              ElementsAre("a:dx=-0.00390625:dy=-1", "a:dx=-0.00390625:dy=0",
                          "a:dx=-0.00390625:dy=1", "a:dx=0:dy=-1", "a:dx=0:dy=0", "a:dx=0:dy=1"));
  EXPECT_THAT(loaded.cases[2].parts, ElementsAre("dx=-0.00390625", "dy=1"));
  EXPECT_EQ(vertex(loaded.cases[2], 0).position.x.raw(), Fixed::kOne - 256);
  EXPECT_EQ(vertex(loaded.cases[2], 1).position.y.raw(), 3 * Fixed::kOne);
  EXPECT_EQ(vertex(loaded.cases[3], 0).position.x.raw(), Fixed::kOne);
  EXPECT_FALSE(loaded.cases[2].source->empty());
}

TEST(Expansion, ARangeNeedNotMeetItsEnd) {
  EXPECT_EQ(sweep(kDy).cases.size(), 3U);
  EXPECT_EQ(sweep(R"("x": {"set": ["/draws/0/vertices/0/x"],
                           "range": {"from": 0, "to": 1, "step": "1/256"}})")
                .cases.size(),
            257U);
}

TEST(Expansion, ZippedAxesRunTogether) {
  const LoadedCases loaded = sweep(
      R"("x": {"set": ["/draws/0/vertices/0/x"], "values": [0, 1, 2], "zip": "g"},)" + kDx + R"(,
         "y": {"set": ["/draws/0/vertices/0/y"], "values": [3, 2, 1], "zip": "g", "base": 2})",
      R"(, "expect": [{"coverage": )" + kRows + "}]");
  EXPECT_TRUE(loaded.diagnostics.empty()) << faults(loaded)[0];
  EXPECT_THAT(ids(loaded),
              ElementsAre("a:x=0:dx=-0.00390625:y=3", "a:x=0:dx=0:y=3", "a:x=1:dx=-0.00390625:y=2",
                          "a:x=1:dx=0:y=2", "a:x=2:dx=-0.00390625:y=1", "a:x=2:dx=0:y=1"));
  // The group's base is the one of its axis that says one.
  EXPECT_EQ(loaded.cases[2].expect.size(), 1U);
}

TEST(Expansion, SetReachesEveryKindOfValue) {
  const LoadedCases loaded = sweep(R"(
    "shape": {"set": ["/draws/0/primitive"], "values": ["line_strip", "points"]},
    "provoking": {"set": ["/draws/0/state/provoking_vertex"], "values": ["first"]},
    "width": {"set": ["/draws/0/state/line_width"], "values": ["3/2"]},
    "size": {"set": ["/target/width"], "values": [16]},
    "z": {"set": ["/draws/0/vertices/0/z"], "values": ["1/2"]},
    "color": {"set": ["/draws/0/vertices/0/color"], "values": [[0, 1, 0], [0, 0, 1]]})");
  EXPECT_THAT(ids(loaded),
              ElementsAre("a:shape=line_strip:provoking=first:width=1.5:size=16:z=0.5:color=#0",
                          "a:shape=line_strip:provoking=first:width=1.5:size=16:z=0.5:color=#1",
                          "a:shape=points:provoking=first:width=1.5:size=16:z=0.5:color=#0",
                          "a:shape=points:provoking=first:width=1.5:size=16:z=0.5:color=#1"));
  const Case& one = loaded.cases[1];
  EXPECT_EQ(one.scene.draws[0].primitive, Primitive::line_strip);
  EXPECT_EQ(one.scene.draws[0].provoking_vertex, ProvokingVertex::first);
  EXPECT_EQ(one.scene.draws[0].line_width, Fixed::from_raw(3 * Fixed::kOne / 2));
  EXPECT_EQ(one.scene.target.width, 16);
  EXPECT_EQ(vertex(one, 0).z, Fixed::from_raw(Fixed::kOne / 2));
  EXPECT_EQ(vertex(one, 0).position.x, Fixed::from_integer(1));
  EXPECT_EQ(vertex(one, 0).color, (Color{0, 0, 1, 1}));
}

TEST(Expansion, PointsReplaceVerticesAndSmallerMovesFollow) {
  const LoadedCases loaded = sweep(R"(
    "x": {"set": ["/draws/0/vertices/1/x"], "values": [2]},
    "p": {"set": ["/draws/0/vertices/1"], "points": [[0, 1, 0.5], {"at": [3, 3], "color": [0, 0, 1]}]},
    "dx": {"add_to": ["/draws/0/vertices/1/x"], "values": ["1/2"]})");
  EXPECT_THAT(ids(loaded), ElementsAre("a:x=2:p=#0:dx=0.5", "a:x=2:p=#1:dx=0.5"));
  const Fixed x = Fixed::from_raw(5 * Fixed::kOne / 2);
  EXPECT_EQ(vertex(loaded.cases[0], 1).position, (Point{x, Fixed::from_integer(1)}));
  EXPECT_EQ(vertex(loaded.cases[0], 1).z, Fixed::from_raw(Fixed::kOne / 2));
  EXPECT_EQ(vertex(loaded.cases[0], 1).color, (Color{1, 0, 0, 1}));
  EXPECT_EQ(vertex(loaded.cases[1], 1).position, (Point{x, Fixed::from_integer(3)}));
  EXPECT_EQ(vertex(loaded.cases[1], 1).color, (Color{0, 0, 1, 1}));
}

TEST(Expansion, ColoursAreSaltedByTheWholeId) {
  const LoadedCases loaded = sweep(kDx);
  ASSERT_EQ(loaded.cases.size(), 2U);
  EXPECT_NE(vertex(loaded.cases[0], 0).color, vertex(loaded.cases[1], 0).color);
  EXPECT_NE(loaded.cases[0].scene.target.clear, loaded.cases[1].scene.target.clear);
}

TEST(Expansion, DrawingsHoldForTheBaseOrWhereWhenSays) {
  const std::string base = R"("dx": {"add_to": ["/draws/0/vertices/0/x"], "values": [-1, 0],
                                     "base": "0/4"})";
  const LoadedCases loaded =
      sweep(base + "," + kDy, R"(, "variants": ["reverse"], "expect": [{"coverage": )" + kRows +
                                  R"(}, {"when": {"dx": 0, "dy": "2/2"}, "coverage": )" + kRows +
                                  R"(}, {"when": {"dy": 0, "variant": "reverse"}, "coverage": )" +
                                  kRows + "}]");
  EXPECT_TRUE(loaded.diagnostics.empty()) << faults(loaded)[0];
  Texts with;
  for (const Case& one : loaded.cases)
    for (const Expect& expect : one.expect)
      with.push_back(one.id + expect.where.substr(expect.where.find(" /")));
  EXPECT_THAT(
      with,
      ElementsAre("a:dx=-1:dy=0:reverse /expect/2/coverage", "a:dx=0:dy=-1 /expect/0/coverage",
                  "a:dx=0:dy=0:reverse /expect/2/coverage", "a:dx=0:dy=1 /expect/1/coverage"));
}

TEST(Expansion, AFaultOfSomeCasesNamesTheFirst) {
  const LoadedCases loaded =
      sweep(kDx + R"(, "w": {"set": ["/draws/0/state/line_width"], "values": [1, 64, 65]})");
  EXPECT_TRUE(loaded.cases.empty());
  EXPECT_THAT(faults(loaded),
              ElementsAre(HasSubstr("/draws/0/state/line_width: line_width is 65, out of range "
                                    "(with dx=-0.00390625, w=65, and in 1 more)")));
}

TEST(Expansion, FaultsOfTheWholeFileAreToldOnceAndWithoutValues) {
  const LoadedCases loaded = sweep(kDx + "," + kDy, R"(, "tags": ["Odd"])");
  EXPECT_THAT(faults(loaded), ElementsAre(HasSubstr("/tags/0: \"Odd\" is no tag; ")));
}

TEST(Expansion, ManyFaultsEndTheReading) {
  const LoadedCases loaded = sweep(R"("w": {"set": ["/draws/0/state/line_width"],
                                            "range": {"from": 65, "to": 1000, "step": 1}})");
  ASSERT_EQ(loaded.diagnostics.size(), 21U);
  Texts told = faults(loaded);
  EXPECT_THAT(told, testing::Contains(HasSubstr("only 20 of 936 combinations were read")));
}

TEST(Expansion, NotesAreToldOnce) {
  const LoadedCases loaded =
      sweep(kDx + R"(, "y": {"set": ["/draws/0/vertices/0/y"], "values": ["~0.1", "~0.2"]})",
            R"(, "expect": [{"when": {"y": "~0.1", "dx": 0}, "coverage": )" + kRows + "}]");
  EXPECT_EQ(loaded.cases.size(), 4U);
  EXPECT_EQ(loaded.notes.size(), 2U);
}

TEST(Expansion, TheLimitCountsImages) {
  const auto range = [](const char* to) {
    return std::string(R"("x": {"set": ["/draws/0/vertices/0/x"], "range": {"from": 0, "to": )") +
           to + R"(, "step": "1/4096"}})";
  };
  EXPECT_EQ(sweep(range("\"4095/4096\"")).cases.size(), 4096U);
  EXPECT_EQ(sweep(range("\"511/4096\""), R"(, "variants": ["octants"])").cases.size(), 4096U);
  const LoadedCases loaded = sweep(range("\"512/4096\""), R"(, "variants": ["octants"])");
  EXPECT_THAT(faults(loaded), ElementsAre(HasSubstr("stands for 4104 cases")));
}

}  // namespace
}  // namespace edgecase
