// SPDX-License-Identifier: MIT
#include "casefile/loader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace edgecase {
namespace {

namespace fs = std::filesystem;

class Suite : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(root_);
    for (const char* file :
         {"cases/lines/b.json", "cases/lines/a.json", "cases/c.json", "cases/case.schema.json",
          "cases/policies/p.json", "cases/known/e.json", "cases/lines/rows.txt",
          "cases/.hidden/h.json", "other/x.y.json", "other/deep/z.json"}) {
      fs::create_directories((root_ / file).parent_path());
      std::ofstream(root_ / file) << "{}";
    }
  }
  void TearDown() override { fs::remove_all(root_); }

  FoundCases find(const std::vector<std::string>& paths) const {
    std::vector<fs::path> full;
    for (const std::string& path : paths) full.push_back(root_ / path);
    return find_cases(full);
  }
  static std::vector<std::string> ids(const FoundCases& found) {
    std::vector<std::string> result;
    for (const CaseFile& file : found.cases) result.push_back(file.id);
    return result;
  }

  fs::path root_ = fs::temp_directory_path() / "edgecase-suite-test";
};

using Ids = std::vector<std::string>;

TEST_F(Suite, SearchesFoldersAndSkipsWhatIsNoCase) {
  const FoundCases found = find({"cases"});
  EXPECT_TRUE(found.diagnostics.empty());
  EXPECT_EQ(ids(found), (Ids{"c", "lines/a", "lines/b"}));
  EXPECT_EQ(found.cases[1].file, root_ / "cases/lines/a.json");
}

TEST_F(Suite, IdsDoNotDependOnTheWayToACase) {
  EXPECT_EQ(ids(find({"cases/"})), (Ids{"c", "lines/a", "lines/b"}));
  EXPECT_EQ(ids(find({"cases/lines/../."})), (Ids{"c", "lines/a", "lines/b"}));
  EXPECT_EQ(ids(find({"cases/lines"})), (Ids{"lines/a", "lines/b"}));
  EXPECT_EQ(ids(find({"cases/lines/a.json"})), (Ids{"lines/a"}));
  EXPECT_EQ(ids(find({"cases/lines/a.json", "cases", "cases/c.json"})),
            (Ids{"c", "lines/a", "lines/b"}));
}

TEST_F(Suite, OutsideASuiteIdsAreCountedFromTheFolder) {
  EXPECT_EQ(ids(find({"other"})), (Ids{"deep/z", "x.y"}));
  EXPECT_EQ(ids(find({"other/x.y.json"})), (Ids{"x.y"}));
  EXPECT_EQ(ids(find({"other/deep/z.json"})), (Ids{"z"}));
}

TEST_F(Suite, MissingPathsAreReportedAndTheOthersFound) {
  const FoundCases found = find({"cases/none.json", "cases/c.json", "nowhere"});
  EXPECT_EQ(ids(found), (Ids{"c"}));
  ASSERT_EQ(found.diagnostics.size(), 2U);
  EXPECT_EQ(found.diagnostics[0].file, (root_ / "cases/none.json").generic_string());
  EXPECT_FALSE(found.diagnostics[0].remedy.empty());
}

TEST_F(Suite, EqualIdsOfDifferentFilesAreReported) {
  std::ofstream(root_ / "other/c.json") << "{}";
  const FoundCases found = find({"cases", "other"});
  EXPECT_EQ(ids(found), (Ids{"c", "deep/z", "lines/a", "lines/b", "x.y"}));
  ASSERT_EQ(found.diagnostics.size(), 1U);
  EXPECT_NE(found.diagnostics[0].message.find("\"c\""), std::string::npos);
}

TEST_F(Suite, NamesThatAreNotUtf8AreReported) {
  std::ofstream(root_ / "other/\xFF.json") << "{}";
  const FoundCases found = find({"other"});
  EXPECT_EQ(ids(found), (Ids{"deep/z", "x.y"}));
  ASSERT_EQ(found.diagnostics.size(), 1U);
  EXPECT_EQ(found.diagnostics[0].file.find('\xFF'), std::string::npos);
}

}  // namespace
}  // namespace edgecase
