// SPDX-License-Identifier: MIT
#include "suite/example_case.h"

#include <gtest/gtest.h>

#include <fstream>

namespace edgecase {
namespace {

namespace fs = std::filesystem;

class ExampleCases : public testing::Test {
 protected:
  void SetUp() override {
    suite_ = fs::path(testing::TempDir()) / "example-cases" / "cases";
    fs::remove_all(suite_.parent_path());
    fs::create_directories(suite_);
  }
  void TearDown() override { fs::remove_all(suite_.parent_path()); }

  // A line, or two, on a square target.
  void add(const std::string& name, const std::string& rule, int size, bool twice = false) {
    const std::string line = "{\"primitive\": \"lines\", \"vertices\": [[1, 1], [2, 2]]}";
    std::ofstream(suite_ / (name + ".json"))
        << "{\"title\": \"" << name << "\", \"rules\": [\"" << rule
        << "\"], \"target\": {\"width\": " << size << ", \"height\": " << size << "}, \"draws\": ["
        << line << (twice ? ", " + line : "") << "]}";
  }

  fs::path suite_;
};

TEST_F(ExampleCases, FewestVerticesThenSmallestTargetThenFirstId) {
  add("a", "line.snap", 4, true);
  add("d", "line.snap", 8);
  add("c", "line.snap", 8);
  add("b", "line.snap", 16);
  add("e", "line.width", 2);
  const auto found = simplest_case(suite_, "line.snap");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->example.id, "c");
  EXPECT_EQ(found->rule, "line.snap");
}

TEST_F(ExampleCases, OfARuleNearByWhereThereIsNone) {
  add("a", "framebuffer.order", 4);
  add("b", "triangle.snap", 8);
  const auto found = simplest_case(suite_, "subpixel.snap");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->example.id, "b");
  EXPECT_EQ(found->rule, "triangle.snap");
  EXPECT_EQ(simplest_case(suite_, "triangle.fill-rule")->example.id, "b");
  EXPECT_FALSE(simplest_case(suite_, "texture.wrap"));
}

TEST_F(ExampleCases, FaultyFilesArePassedOver) {
  std::ofstream(suite_ / "a.json") << "{\"rules\": [\"line.snap\"], ";
  add("b", "line.snap", 8);
  EXPECT_EQ(simplest_case(suite_, "line.snap")->example.id, "b");
}

}  // namespace
}  // namespace edgecase
