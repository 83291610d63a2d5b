// SPDX-License-Identifier: MIT
//
// Textured scenes that are written come back the same, patterns as patterns.
#include "casefile/scene/textures.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "casefile/case_writer.h"
#include "casefile/loader.h"
#include "casefile/scene/patterns.h"
#include "casefile/scene/viewport.h"
#include "model/scene.h"

namespace edgecase {
namespace {

CaseText written(const Scene& scene) {
  CaseWords words;
  words.title = "A textured scene";
  words.rules = {"triangle.fill-rule"};
  return case_text(scene, words);
}

// A text without what only lays it out.
std::string packed(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

std::string text_of(const Scene& scene) {
  const CaseText result = written(scene);
  for (const Diagnostic& diagnostic : result.diagnostics) ADD_FAILURE() << to_string(diagnostic);
  const LoadedCases read = load_cases_text(result.text, "a.json", "another");
  EXPECT_EQ(read.cases.size(), 1U);
  if (read.cases.size() == 1) {
    EXPECT_TRUE(same_scene(read.cases[0].scene, scene));
    EXPECT_EQ(written(read.cases[0].scene).text, result.text);
  }
  return packed(result.text);
}

Scene scene_with(Texture texture) {
  Scene scene;
  scene.target.width = scene.target.height = 4;
  scene.details.texture = true;
  Draw draw;
  draw.primitive = Primitive::points;
  Vertex vertex;
  vertex.position = {Fixed::from_integer(1), Fixed::from_integer(1)};
  vertex.texture_coordinates = {0.1F, texture.dimensions == 1 ? 0.0F : -1e10F};
  draw.vertices = {vertex};
  draw.texture = TextureUse{};
  scene.draws = {draw};
  scene.textures = {std::make_shared<const Texture>(std::move(texture))};
  scene.viewport = choose_viewport(scene.target, scene.draws).value();
  return scene;
}

Texture one_level(TextureLevel level, TextureFormat format, int dimensions = 2) {
  return {dimensions, format, {std::move(level)}, false};
}

TEST(TextureWriter, EveryTexturedCaseComesBack) {
  const auto file =
      std::filesystem::path(EDGECASE_ROOT) / "tests/casefile/good/textures-everything.json";
  const LoadedCases loaded = load_cases(file, "textures");
  ASSERT_EQ(loaded.cases.size(), 2U * 2 * 2 * 2 * 10);
  for (const Case& one : loaded.cases) {
    SCOPED_TRACE(one.id);
    text_of(one.scene);
    if (HasFailure()) return;
  }
}

TEST(TextureWriter, PatternsAreWrittenAsPatterns) {
  for (const TextureFormat format :
       {TextureFormat::rgba8, TextureFormat::srgb8, TextureFormat::rgba32f}) {
    const StoredTexel a = stored_texel({0.25F, 0.5F, 0.75F, 0.1F}, format);
    const StoredTexel b = stored_texel({1, 0.3F, 0, 1}, format);
    const StoredTexel black = black_texel(format);
    const StoredTexel white = white_texel(format);
    const std::pair<TextureLevel, const char*> patterns[] = {
        {checker_image({9, 7}, 1, {black, white}), R"("checker":{})"},
        {checker_image({9, 7}, 3, {a, b}), R"("checker":{"cell":3,"colors")"},
        {checker_image({3, 70}, 5, {a, b}), R"("checker":{"cell":5,"colors")"},
        {flat_image({9, 7}, a), R"("checker":{"colors")"},
        {gradient_image({9, 7}, {a, b, a, b}, format), R"("gradient":{"colors")"},
        {gradient_image({9, 7}, {a, b, black, a}, format), R"("gradient":{)"},
        {zone_plate_image({300, 200}, format), R"("zone-plate":{})"},
        {noise_image({200, 300}, format, 65535), R"("noise":{"seed":65535})"}};
    for (const auto& [level, words] : patterns) {
      const std::string text = text_of(scene_with(one_level(level, format)));
      EXPECT_NE(text.find(words), std::string::npos) << text.substr(0, 2000);
      EXPECT_EQ(text.find("texels"), std::string::npos) << text.substr(0, 2000);
    }
  }
}

TEST(TextureWriter, OtherImagesAreWrittenTexelByTexel) {
  for (const TextureFormat format :
       {TextureFormat::rgba8, TextureFormat::srgb8, TextureFormat::rgba32f}) {
    TextureLevel level = noise_image({13, 5}, format, 1);
    level.texels[7] = 1;
    EXPECT_NE(text_of(scene_with(one_level(level, format))).find("texels"), std::string::npos);
    level = noise_image({29, 1}, format, 2);
    level.texels[9] = 0;
    EXPECT_NE(text_of(scene_with(one_level(level, format, 1))).find("texels"), std::string::npos);
  }
}

TEST(TextureWriter, ChainsAreWrittenByWhatMadeThem) {
  const TextureFormat format = TextureFormat::rgba8;
  const TextureLevel noise = noise_image({13, 5}, format, 1);
  const auto with = [&](std::vector<TextureLevel> levels, bool generated) {
    return scene_with({2, format, std::move(levels), generated});
  };
  EXPECT_NE(text_of(with(box_chain(noise, format), false)).find(R"("mipmaps":"box")"),
            std::string::npos);
  EXPECT_NE(text_of(with({noise}, true)).find(R"("mipmaps":"generated")"), std::string::npos);
  auto colors = level_colors(4, format);
  EXPECT_NE(text_of(with(flat_levels({13, 5}, colors), false)).find(R"("levels":{})"),
            std::string::npos);
  colors[2] = {1, 2, 3, 4};
  EXPECT_NE(text_of(with(flat_levels({13, 5}, colors), false)).find(R"("levels":{"colors")"),
            std::string::npos);
  auto chain = box_chain(noise, format);
  chain[1].texels[0] = 255 - chain[1].texels[0];
  EXPECT_FALSE(written(with(chain, false)).diagnostics.empty());
}

TEST(TextureWriter, ColouredVerticesOfTexturedDrawsCannotBeSaid) {
  Scene scene = scene_with(one_level(flat_image({2, 2}, {0, 0, 0, 255}), TextureFormat::rgba8));
  text_of(scene);
  scene.draws[0].vertices[0].color = {1, 0, 0, 1};
  EXPECT_FALSE(written(scene).diagnostics.empty());
}

}  // namespace
}  // namespace edgecase
