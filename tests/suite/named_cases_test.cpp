// SPDX-License-Identifier: MIT
//
// Words that name cases, in a suite of a few files.
#include "suite/selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace edgecase {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kPlain = R"({"title": "t", "rules": ["point.ownership"],
 "target": {"width": 8, "height": 8}, "draws": [{"primitive": "points", "vertices": [[1, 1]]}]})";
constexpr const char* kSwept = R"({"title": "t", "rules": ["point.ownership"],
 "target": {"width": 8, "height": 8}, "draws": [{"primitive": "points", "vertices": [[1, 1]]}],
 "sweep": {"dx": {"add_to": ["/draws/0/vertices/0/x"], "values": [0, 0.5]},
           "dy": {"add_to": ["/draws/0/vertices/0/y"], "values": [0, 1]}}})";

class NamedCases : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(::testing::TempDir()) /
            ("edgecase-named-" +
             std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(root_);
    write("lines/short/ends.json", kPlain);
    write("lines/short/starts.json", kPlain);
    write("lines/ramp.json", kSwept);
    write("points/centre.json", kPlain);
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const char* text) {
    const fs::path path = suite() / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  fs::path suite() const { return root_ / "cases"; }

  // Ids of what the words select; faults are told behind them.
  std::vector<std::string> selected(const std::vector<std::string>& words) const {
    const Suite found = load_suite(selection_of(words, suite()));
    std::vector<std::string> ids;
    for (const Case& one : found.cases) ids.push_back(one.id);
    for (const Diagnostic& fault : found.diagnostics) ids.push_back(to_string(fault));
    return ids;
  }

  fs::path root_;
};

TEST_F(NamedCases, IdsOfFilesAndFolders) {
  EXPECT_THAT(selected({"points/centre"}), ElementsAre("points/centre"));
  EXPECT_THAT(selected({"lines/short"}), ElementsAre("lines/short/ends", "lines/short/starts"));
  EXPECT_THAT(selected({"lines/short/"}), ElementsAre("lines/short/ends", "lines/short/starts"));
  EXPECT_EQ(selected({"lines/ramp"}).size(), 4U);
}

TEST_F(NamedCases, PathsStayPaths) {
  EXPECT_THAT(selected({(suite() / "points/centre.json").string()}), ElementsAre("points/centre"));
  EXPECT_THAT(selected({(suite() / "points").string(), "points/centre"}),
              ElementsAre("points/centre"));
  EXPECT_THAT(selected({(suite() / "points/centre").string()}), ElementsAre("points/centre"));
  EXPECT_THAT(selected({(suite() / "lines/ramp.json").string() + ":dx=0.5:dy=1"}),
              ElementsAre("lines/ramp:dx=0.5:dy=1"));
}

TEST_F(NamedCases, Globs) {
  EXPECT_THAT(selected({"*/short/*", "points/?entre"}),
              ElementsAre("lines/short/ends", "lines/short/starts", "points/centre"));
  EXPECT_THAT(selected({"*:dx=0.5:dy=*"}),
              ElementsAre("lines/ramp:dx=0.5:dy=0", "lines/ramp:dx=0.5:dy=1"));
}

TEST_F(NamedCases, CasesOfASweep) {
  EXPECT_THAT(selected({"lines/ramp:dx=0:dy=1"}), ElementsAre("lines/ramp:dx=0:dy=1"));
  EXPECT_THAT(selected({"lines/ramp:dy=1"}),
              ElementsAre("lines/ramp:dx=0.5:dy=1", "lines/ramp:dx=0:dy=1"));
  EXPECT_THAT(
      selected({"lines/ramp:dx=0*:dy=0", "lines/ramp:dx=0:dy=1"}),
      ElementsAre("lines/ramp:dx=0.5:dy=0", "lines/ramp:dx=0:dy=0", "lines/ramp:dx=0:dy=1"));
  // Named as a whole as well, by id or within its folder.
  EXPECT_EQ(selected({"lines/ramp:dy=1", "lines/ramp"}).size(), 4U);
  EXPECT_EQ(selected({"lines", "lines/ramp:dy=1"}).size(), 6U);
}

TEST_F(NamedCases, TellsWhatNamesNothing) {
  EXPECT_THAT(selected({"points/centre", "points/center"}),
              ElementsAre("points/centre",
                          "points/center: there is no such file, folder or case; did you mean "
                          "points/centre?"));
  EXPECT_THAT(selected({"centre"}), ElementsAre(HasSubstr("did you mean points/centre?")));
  EXPECT_THAT(selected({"short"}), ElementsAre(HasSubstr("did you mean lines/short?")));
  EXPECT_THAT(selected({"lines/shrot"}), ElementsAre(HasSubstr("did you mean lines/short?")));
  EXPECT_THAT(selected({"lin"}), ElementsAre(HasSubstr("did you mean lines?")));
  EXPECT_THAT(selected({"something/else"}),
              ElementsAre(HasSubstr("`edgecase run --list` prints the ids")));
  const std::string wrong = (suite() / "points/center.json").string();
  EXPECT_THAT(selected({wrong}),
              ElementsAre(wrong + ": there is no such file or folder; did you mean " +
                          (suite() / "points/centre.json").string() + "?"));
  EXPECT_THAT(selected({"./nothing.json"}), ElementsAre(HasSubstr("check the path's spelling")));
  EXPECT_THAT(selected({"lines/ramp:dx=9"}),
              ElementsAre(HasSubstr("lines/ramp:dx=9: there is no such case; `edgecase run ")));
  EXPECT_THAT(selected({""}), ElementsAre(HasSubstr("there is no such")));
}

TEST_F(NamedCases, ASuiteThatIsNotThere) {
  const std::vector<std::string> words = {"points/centre"};
  const FoundWords found = find_words(words, root_ / "nowhere");
  EXPECT_TRUE(found.paths.empty());
  ASSERT_EQ(found.diagnostics.size(), 1U);
  EXPECT_THAT(found.diagnostics[0].message, HasSubstr("no such file, folder or case"));
}

TEST(MatchesParts, EachPartOfThePatternMustMatch) {
  Case one;
  one.parts = {"dx=0.5", "dy=1", "reverse"};
  for (const char* pattern : {"dx=0.5", "dy=1:dx=0.5", "dx=*:reverse", "*", "r*"})
    EXPECT_TRUE(matches_parts(pattern, one.parts)) << pattern;
  for (const char* pattern : {"", "dx=0", "dx=0.5:dx=1", "dx=0.5:", "x=0.5"})
    EXPECT_FALSE(matches_parts(pattern, one.parts)) << pattern;
}

}  // namespace
}  // namespace edgecase
