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

constexpr const char* kHead = R"({"title": "t", "rules": ["point.coverage"],
 "target": {"width": 4, "height": 2},
)";

std::string with(const std::string& rest) {
  return kHead + rest + "}";
}

LoadedCases load(const std::string& text) {
  return load_cases_text(text, "folder/a.json", "a");
}

std::string all_messages(const LoadedCases& loaded) {
  std::string text;
  for (const Diagnostic& diagnostic : loaded.diagnostics) text += to_string(diagnostic) + "\n";
  return text;
}

TEST(Loader, FillsDefaults) {
  const std::string text =
      with(R"("draws": [{"primitive": "lines", "vertices": [[0.5, 1], [3, 1]]}])");
  const LoadedCases loaded = load(text);
  ASSERT_EQ(loaded.cases.size(), 1U) << all_messages(loaded);
  const Case& value = loaded.cases[0];
  EXPECT_EQ(value.id, "a");
  EXPECT_EQ(value.file, fs::path("folder/a.json"));
  EXPECT_EQ(value.source, text);
  EXPECT_EQ(value.scene.target.samples, 1);
  EXPECT_EQ(value.scene.draws[0].interpolation, Interpolation::flat);
  EXPECT_EQ(value.scene.draws[0].provoking_vertex, ProvokingVertex::last);
  EXPECT_EQ(value.scene.draws[0].vertices[0].position.x.raw(), 32768);
  EXPECT_EQ(value.scene.draws[0].vertices[0].z, Fixed());
  EXPECT_EQ(value.scene.viewport.width, 4);
  EXPECT_EQ(value.scene.viewport.height, 2);
  EXPECT_EQ(value.scene.target.clear[3], 1);
}

TEST(Loader, ReadsAllFieldsOfTheFullExample) {
  const fs::path file = fs::path(EDGECASE_ROOT) / "tests/casefile/good/everything.json";
  const LoadedCases loaded = load_cases(file, "everything");
  ASSERT_EQ(loaded.cases.size(), 1U) << all_messages(loaded);
  const Case& value = loaded.cases[0];
  EXPECT_EQ(value.why, "Line one.\nLine two.");
  EXPECT_EQ(value.rules.size(), 2U);
  EXPECT_EQ(value.tags, (std::vector<std::string>{"control", "two-draws"}));
  const Scene& scene = value.scene;
  EXPECT_EQ(scene.target.clear, (Color{0.25F, 0.1F, 0, 0.5F}));
  EXPECT_EQ(scene.viewport.x, -2);
  EXPECT_EQ(scene.viewport.height, 16);
  const Draw& draw = scene.draws[0];
  EXPECT_EQ(draw.interpolation, Interpolation::smooth);
  EXPECT_EQ(draw.provoking_vertex, ProvokingVertex::first);
  EXPECT_EQ(draw.vertices[0].color, (Color{1, 0, 0, 1}));
  EXPECT_EQ(draw.vertices[1].color, (Color{0, 1, 0, 0.5F}));
  EXPECT_EQ(draw.vertices[2].position.y.raw(), 5 * Fixed::kOne / 2);
  EXPECT_EQ(draw.vertices[2].z, Fixed::from_integer(-1));
  ASSERT_EQ(loaded.notes.size(), 1U);
  EXPECT_NE(loaded.notes[0].message.find("0.100006103515625"), std::string::npos);
  // Drawn top row first, stored bottom row first; the file says the same.
  const std::vector<int> hits{1, 1, 1, 0, 2, 1, 0, 0, 0, 0, 0, 0};
  ASSERT_EQ(value.expect.size(), 2U);
  EXPECT_EQ(value.expect[0].coverage, hits);
  EXPECT_EQ(value.expect[0].policy, "opengl");
  EXPECT_EQ(value.expect[1].coverage, hits);
  EXPECT_EQ(value.expect[1].policy, "scotty3d");
  EXPECT_NE(value.expect[0].where.find("everything.json:26: /expect/0/coverage"), std::string::npos)
      << value.expect[0].where;
}

TEST(Loader, TakesColoursToTheNearestFloat) {
  const LoadedCases loaded = load(with(
      R"("draws": [{"primitive": "points", "color": [0.1, 1e-60, 0.99999999999],
                  "vertices": [[1, 1]]}])"));
  ASSERT_EQ(loaded.cases.size(), 1U) << all_messages(loaded);
  EXPECT_EQ(loaded.cases[0].scene.draws[0].vertices[0].color, (Color{0.1F, 0, 1, 1}));
}

TEST(Loader, NamesTheNearestKnownRule) {
  const std::string text = with(R"("draws": [{"primitive": "points", "vertices": [[1, 1]]}])");
  const std::vector<std::string> known{"line.diamond-exit", "point.cover"};
  const LoadedCases loaded = load_cases_text(text, "a.json", "a", known);
  ASSERT_EQ(loaded.diagnostics.size(), 1U);
  EXPECT_EQ(loaded.diagnostics[0].pointer, "/rules/0");
  EXPECT_NE(loaded.diagnostics[0].remedy.find("did you mean \"point.cover\"?"), std::string::npos);
  const std::vector<std::string> right{"point.coverage"};
  EXPECT_EQ(load_cases_text(text, "a.json", "a", right).cases.size(), 1U);
}

TEST(Loader, CountsVerticesOverAllDraws) {
  const auto draw = [](int count) {
    std::string text = R"({"primitive": "points", "vertices": [[1,1])";
    for (int i = 1; i < count; ++i) text += ",[1,1]";
    return text + "]}";
  };
  const auto draws = [&](int a, int b) {
    return with("\"draws\": [" + draw(a) + "," + draw(b) + "]");
  };
  EXPECT_EQ(load(draws(131072, 131072)).cases.size(), 1U);
  const LoadedCases loaded = load(draws(131072, 131073));
  ASSERT_EQ(loaded.diagnostics.size(), 1U);
  EXPECT_EQ(loaded.diagnostics[0].pointer, "/draws");
}

TEST(Loader, ReportsFilesThatCannotBeRead) {
  const LoadedCases missing = load_cases("no/such/case.json", "case");
  ASSERT_EQ(missing.diagnostics.size(), 1U);
  EXPECT_EQ(missing.diagnostics[0].file, "no/such/case.json");
  EXPECT_FALSE(missing.diagnostics[0].remedy.empty());
  const LoadedCases folder = load_cases(fs::temp_directory_path(), "case");
  ASSERT_EQ(folder.diagnostics.size(), 1U);
  const LoadedCases device = load_cases("/dev/zero", "case");
  ASSERT_EQ(device.diagnostics.size(), 1U);
}

TEST(Loader, CoverageFilesStayInsideTheFolderWhateverLinksSay) {
  const fs::path root = fs::temp_directory_path() / "edgecase-loader-test";
  fs::remove_all(root);
  fs::create_directories(root / "inside" / "deep");
  std::ofstream(root / "rows.txt") << "....\n....\n";
  std::ofstream(root / "inside" / "rows.txt") << "....\r\n#...\r\n";
  fs::create_symlink("../rows.txt", root / "inside" / "link.txt");
  fs::create_directory_symlink("..", root / "inside" / "up");
  const auto load_with = [&](const std::string& path) {
    return load_cases_text(with(R"("draws": [{"primitive": "points", "vertices": [[1, 1]]}],
        "expect": [{"coverage_file": ")" +
                                path + "\"}]"),
                           root / "inside" / "a.json", "a");
  };
  EXPECT_EQ(load_with("rows.txt").cases.size(), 1U);
  EXPECT_EQ(load_with("deep/../rows.txt").cases.size(), 1U);
  EXPECT_EQ(load_with("rows.txt").cases[0].expect[0].coverage[0], 1);
  for (const char* path : {"link.txt", "up/rows.txt", "../rows.txt", "deep/../../rows.txt", "."})
    EXPECT_EQ(load_with(path).diagnostics.size(), 1U) << path;
  fs::remove_all(root);
}

}  // namespace
}  // namespace edgecase
