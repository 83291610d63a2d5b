// SPDX-License-Identifier: MIT
//
// Outlines of files: the names that all their cases have, without reading more than one of them.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "casefile/loader.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = EDGECASE_ROOT;

std::vector<CaseFile> files_in(const fs::path& folder) {
  return find_cases(std::array{kRoot / folder}).cases;
}

void expect_outline_of(const CaseFile& file, const LoadedCases& loaded) {
  SCOPED_TRACE(file.file);
  const std::optional<FileOutline> outline = outline_cases(file.file, file.id);
  ASSERT_TRUE(outline.has_value());
  ASSERT_EQ(outline->names.size(), loaded.cases.size());
  for (std::size_t i = 0; i < loaded.cases.size(); ++i) {
    EXPECT_EQ(outline->names[i].id, loaded.cases[i].id);
    EXPECT_EQ(outline->names[i].parts, loaded.cases[i].parts);
  }
  const Case& first = loaded.cases.front();
  EXPECT_EQ(outline->first.id, first.id);
  EXPECT_EQ(outline->first.tags, first.tags);
  EXPECT_EQ(*outline->first.source, *first.source);
  EXPECT_TRUE(same_scene(outline->first.scene, first.scene));
}

TEST(Outline, NamesTheCasesOfTheSuite) {
  const std::vector<CaseFile> files = files_in("cases");
  EXPECT_GT(files.size(), 800U);
  for (const CaseFile& file : files) expect_outline_of(file, load_cases(file.file, file.id));
}

TEST(Outline, NamesCasesWithEachKey) {
  for (const CaseFile& file : files_in("tests/casefile/good"))
    if (const LoadedCases loaded = load_cases(file.file, file.id); loaded.diagnostics.empty())
      expect_outline_of(file, loaded);
}

// Most faults show in the first case. Those of the rest of a sweep, and conditions that hold for
// none of its cases, need all of it.
TEST(Outline, OfAFaultyFileIsMostlyNone) {
  std::size_t outlined = 0;
  const std::vector<CaseFile> files = files_in("tests/casefile/bad");
  for (const CaseFile& file : files) outlined += outline_cases(file.file, file.id).has_value();
  EXPECT_GT(files.size(), 90U);
  EXPECT_LT(outlined, files.size() / 5);
}

TEST(Outline, OfNoFileIsNone) {
  EXPECT_FALSE(outline_cases(kRoot / "cases/no-such-file.json", "no-such-file"));
}

}  // namespace
}  // namespace edgecase
