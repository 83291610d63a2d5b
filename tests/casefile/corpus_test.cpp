// SPDX-License-Identifier: MIT
//
// Holds the loader against the corpora: every bad file must yield exactly the findings that its
// folder's expected.tsv lists, in order, each with a remedy; every good file must load.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "casefile/loader.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

const fs::path kHere = fs::path(EDGECASE_ROOT) / "tests" / "casefile";

struct Expected {
  int line = 0;
  std::string pointer;
  std::string fragment;
};

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
  return fields;
}

// File name -> its findings.
std::map<std::string, std::vector<Expected>> read_expected(const fs::path& folder,
                                                           std::size_t columns) {
  std::map<std::string, std::vector<Expected>> result;
  std::ifstream stream(folder / "expected.tsv");
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    const std::vector<std::string> fields = split(line);
    EXPECT_EQ(fields.size(), columns) << line;
    if (fields.size() != columns) continue;
    const std::string pointer = fields[2] == "(document)" ? "" : fields[2];
    result[fields[0]].push_back({std::stoi(fields[1]), pointer, fields[3]});
  }
  return result;
}

std::vector<fs::path> json_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  return files;
}

void check_folder(const fs::path& folder, std::size_t columns) {
  const auto expected = read_expected(folder, columns);
  const std::vector<fs::path> files = json_files(folder);
  EXPECT_EQ(files.size(), expected.size());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename());
    const LoadedCases loaded = load_cases(file, file.stem().string());
    EXPECT_TRUE(loaded.cases.empty());
    const auto found = expected.find(file.filename().string());
    ASSERT_NE(found, expected.end());
    EXPECT_EQ(loaded.diagnostics.size(), found->second.size());
    for (std::size_t i = 0; i < std::min(loaded.diagnostics.size(), found->second.size()); ++i) {
      const Diagnostic& diagnostic = loaded.diagnostics[i];
      EXPECT_EQ(diagnostic.file, file.generic_string());
      EXPECT_EQ(diagnostic.line, found->second[i].line);
      EXPECT_EQ(diagnostic.pointer, found->second[i].pointer);
      EXPECT_NE(diagnostic.message.find(found->second[i].fragment), std::string::npos)
          << diagnostic.message;
      EXPECT_FALSE(diagnostic.remedy.empty());
    }
  }
}

TEST(Corpus, BadFilesAreRefusedForTheirFaults) {
  EXPECT_GE(json_files(kHere / "bad").size(), 90U);
  check_folder(kHere / "bad", 4);
}

TEST(Corpus, BadFilesThatNoSchemaRefusesAreRefused) {
  check_folder(kHere / "bad_loader_only", 5);
}

TEST(Corpus, GoodFilesLoad) {
  const std::vector<fs::path> files = json_files(kHere / "good");
  EXPECT_GE(files.size(), 10U);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename());
    const LoadedCases loaded = load_cases(file, file.stem().string());
    for (const Diagnostic& diagnostic : loaded.diagnostics) ADD_FAILURE() << to_string(diagnostic);
    EXPECT_FALSE(loaded.cases.empty());
  }
}

}  // namespace
}  // namespace edgecase
