// SPDX-License-Identifier: MIT
//
// Files of moderate size that ask for immoderate work: each limit holds on both of its sides, and
// what is refused has a place and a remedy. Limits that a single number or list has are in the
// corpora (corpus_test.cpp).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "casefile/json/json_document.h"
#include "casefile/loader.h"
#include "casefile/scene/scene_reader.h"
#include "raster/rasterizer.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

std::string repeated(const std::string& piece, std::size_t count) {
  std::string text;
  text.reserve(piece.size() * count);
  for (std::size_t i = 0; i < count; ++i) text += piece;
  return text;
}

// A target, and a draw of `count` times the same vertices.
std::string case_of(const std::string& target, const std::string& primitive,
                    const std::string& vertices, std::size_t count) {
  return fmt::format(R"({{"title": "t", "rules": ["a.b"], "target": {{{}}}, )"
                     R"("draws": [{{"primitive": "{}", "vertices": [{}{}]}}]}})",
                     target, primitive, repeated(vertices + ",", count - 1), vertices);
}

constexpr std::size_t kMaxValues = std::size_t{1} << 20;
constexpr std::size_t kMostFaults = 1000;

LoadedCases load(const std::string& text) {
  return load_cases_text(text, "a.json", "a");
}

void expect_refused(const std::string& text, const std::string& pointer,
                    const std::string& message) {
  const LoadedCases loaded = load(text);
  ASSERT_EQ(loaded.diagnostics.size(), 1U) << message;
  EXPECT_EQ(loaded.diagnostics[0].pointer, pointer);
  EXPECT_EQ(loaded.diagnostics[0].message, message);
  EXPECT_FALSE(loaded.diagnostics[0].remedy.empty());
  EXPECT_GT(loaded.diagnostics[0].line, 0);
}

void expect_loaded(const std::string& text) {
  const LoadedCases loaded = load(text);
  for (const Diagnostic& fault : loaded.diagnostics) ADD_FAILURE() << to_string(fault);
  EXPECT_EQ(loaded.cases.size(), 1U);
}

TEST(Limits, OfValuesInAFile) {
  // The array itself is one.
  const auto list = [](const std::string& item, std::size_t count) {
    return "[" + repeated(item + ",", count - 1) + item + "]";
  };
  EXPECT_TRUE(parse_json(list("0", kMaxValues - 1), "f.json").root.has_value());
  for (const char* item : {"0", "\"\"", "[]", "{}", "null", "true"}) {
    const JsonDocument refused = parse_json(list(item, kMaxValues), "f.json");
    EXPECT_FALSE(refused.root.has_value()) << item;
    ASSERT_EQ(refused.diagnostics.size(), 1U) << item;
    EXPECT_EQ(refused.diagnostics[0].message, "more than 1048576 values");
    EXPECT_FALSE(refused.diagnostics[0].remedy.empty());
  }
}

TEST(Limits, OfFaultsThatAreListed) {
  const auto with_keys = [](std::size_t count) {
    std::string text = R"({"title": "t", "rules": ["a.b"], "target": {"width": 1, "height": 1}, )"
                       R"("draws": [{"primitive": "points", "vertices": [[0.5, 0.5]]}])";
    for (std::size_t i = 0; i < count; ++i) text += fmt::format(",\n\"k{}\": 0", i);
    return text + "}";
  };
  EXPECT_EQ(load(with_keys(kMostFaults)).diagnostics.size(), kMostFaults);
  const LoadedCases loaded = load(with_keys(kMostFaults + 7));
  ASSERT_EQ(loaded.diagnostics.size(), kMostFaults + 1);
  EXPECT_EQ(loaded.diagnostics.front().pointer, "/k0");
  EXPECT_EQ(loaded.diagnostics.back().message, "7 more faults are not listed");
  EXPECT_GT(loaded.diagnostics.back().line, 0);
}

TEST(Limits, OfVertices) {
  const char* target = R"("width": 8, "height": 8)";
  expect_loaded(case_of(target, "points", "[1, 1]", kMaxVertices));
  expect_refused(case_of(target, "points", "[1, 1]", kMaxVertices + 1), "/draws",
                 fmt::format("a case has {} vertices", kMaxVertices + 1).c_str());
}

TEST(Limits, OfATargetsSamples) {
  const auto target = [](int samples) {
    return fmt::format(R"("width": 4096, "height": 2048, "samples": {})", samples);
  };
  expect_loaded(case_of(target(2), "points", "[1, 1]", 1));
  expect_refused(case_of(target(3), "points", "[1, 1]", 1), "/target/samples",
                 "4096 x 2048 pixels of 3 samples are 25165824 samples");
}

TEST(Limits, OfSamplesThatPrimitivesCover) {
  // 2^23 samples are 2^11 times a target of 64 x 64, and a triangle of twice its size covers it.
  const char* target = R"("width": 64, "height": 64)";
  const char* triangle = "[0, 0], [128, 0], [0, 128]";
  expect_loaded(case_of(target, "triangles", triangle, 2048));
  expect_refused(case_of(target, "triangles", triangle, 2049), "/draws",
                 "the primitives may cover 8392704 samples");
  const char* multisampled = R"("width": 64, "height": 64, "samples": 16)";
  expect_loaded(case_of(multisampled, "triangles", triangle, 128));
  expect_refused(case_of(multisampled, "triangles", triangle, 129), "/draws",
                 "the primitives may cover 8454144 samples");
  // Of a line along a row of pixels three rows are held to be in reach.
  const char* wide = R"("width": 4096, "height": 8)";
  EXPECT_EQ(most_drawn_samples(
                load(case_of(wide, "lines", "[0.5, 4.5], [4095.5, 4.5]", 1)).cases[0].scene),
            4096U * 3);
  expect_refused(case_of(wide, "lines", "[0.5, 4.5], [4095.5, 4.5]", 1000), "/draws",
                 "the primitives may cover 12288000 samples");
}

// Scissored, of every primitive, sampled once and several times.
TEST(Limits, NoSceneCoversMoreThanItIsHeldToCover) {
  RandomScenes scenes(12);
  std::uint64_t covered = 0;
  std::uint64_t held = 0;
  for (int i = 0; i < 600; ++i) {
    SceneKind kind;
    kind.size = 1 << (1 + scenes.below(5));
    Scene scene = scenes.next(kind);
    scene.target.samples = i % 3 == 0 ? 4 : 1;
    for (Draw& draw : scene.draws) {
      draw.line_width = Fixed::from_raw(1 + scenes.below(4 * 65536));
      draw.point_size = Fixed::from_raw(1 + scenes.below(4 * 65536));
      if (i % 4 == 0) draw.scissor = Viewport{1, 1, kind.size / 2, kind.size};
    }
    // A fragment may cover all samples of its pixel.
    const std::uint64_t count =
        rasterize(scene, {}).fragments.size() * static_cast<std::uint64_t>(scene.target.samples);
    EXPECT_LE(count, most_drawn_samples(scene));
    covered += count;
    held += most_drawn_samples(scene);
  }
  // The bound is of use: it is not many times what is drawn.
  EXPECT_LT(held, 8 * covered);
}

}  // namespace
}  // namespace edgecase
