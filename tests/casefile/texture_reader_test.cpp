// SPDX-License-Identifier: MIT
//
// Textures and lookups as case files give them; each refusal has a file in bad/ or
// bad_loader_only/.
#include "casefile/scene/textures.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "casefile/loader.h"
#include "casefile/scene/patterns.h"
#include "image/image_file.h"
#include "model/scene_faults.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

const fs::path kGood = fs::path(EDGECASE_ROOT) / "tests" / "casefile" / "good";

// One textured point, and what else stands beside the draws.
std::vector<Case> cases_of(const std::string& textures, const std::string& state,
                           const std::string& uv = "[0.25, -3]", const std::string& more = "") {
  const LoadedCases loaded = load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 4, "height": 4}, "textures": )" +
          textures + R"(, "draws": [{"primitive": "points", "vertices": [{"at": [1, 1], "uv": )" +
          uv + R"(}], "state": {)" + state + "}}]" + more + "}",
      kGood / "a.json", "a");
  for (const Diagnostic& diagnostic : loaded.diagnostics) ADD_FAILURE() << to_string(diagnostic);
  return loaded.cases;
}

Texture texture_of(const std::string& text) {
  const auto cases = cases_of("[" + text + "]", R"("texture": 0)");
  return cases.empty() ? Texture{} : *cases[0].scene.textures.at(0);
}

TEST(TextureReader, DefaultsAreThoseOfTheModel) {
  const auto cases = cases_of(R"([{"size": [4, 2], "checker": {}}])", R"("texture": 0)");
  ASSERT_EQ(cases.size(), 1U);
  const Scene& scene = cases[0].scene;
  EXPECT_EQ(scene.draws[0].texture, TextureUse{});
  EXPECT_EQ(scene.details, (Details{false, false, true}));
  const Vertex& vertex = scene.draws[0].vertices[0];
  EXPECT_EQ(vertex.texture_coordinates, (std::array<float, 2>{0.25F, -3}));
  EXPECT_EQ(vertex.color, (Color{1, 1, 1, 1}));
  const Texture& texture = *scene.textures.at(0);
  EXPECT_EQ(texture.dimensions, 2);
  EXPECT_EQ(texture.format, TextureFormat::rgba8);
  EXPECT_FALSE(texture.generated);
  const StoredTexel black{0, 0, 0, 255};
  const StoredTexel white{255, 255, 255, 255};
  EXPECT_EQ(texture.levels, std::vector{checker_image({4, 2}, 1, {black, white})});
}

TEST(TextureReader, LookupsAreSmoothWhereNothingIsSaid) {
  const char* const checker = R"([{"size": [4, 2], "checker": {}}])";
  const auto silent = cases_of(checker, R"("texture": 0)");
  ASSERT_EQ(silent.size(), 1U);
  EXPECT_EQ(silent[0].scene.draws[0].interpolation, Interpolation::smooth);
  const auto said = cases_of(checker, R"("texture": 0, "interpolation": "flat")");
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].scene.draws[0].interpolation, Interpolation::flat);
}

TEST(TextureReader, AskForNothingWithoutTextures) {
  const LoadedCases loaded = load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 4, "height": 4},
          "textures": [{"size": [1], "checker": {}}],
          "draws": [{"primitive": "points", "vertices": [[1, 1]]}]})",
      "a.json", "a");
  ASSERT_EQ(loaded.cases.size(), 1U);
  EXPECT_FALSE(loaded.cases[0].scene.details.any());
  EXPECT_EQ(loaded.cases[0].scene.textures.size(), 1U);
}

TEST(TextureReader, ReadsEveryPattern) {
  const auto level = [](const std::string& text) { return texture_of(text).levels; };
  const StoredTexel red{255, 0, 0, 255};
  const StoredTexel blue{0, 0, 255, 128};
  EXPECT_EQ(
      level(R"({"size": [6, 4], "checker": {"cell": 2, "colors": [[1, 0, 0], [0, 0, 1, 0.5]]}})"),
      std::vector{checker_image({6, 4}, 2, {red, blue})});
  EXPECT_EQ(level(R"({"size": [6, 4], "gradient": {"colors": [[1, 0, 0], [0, 0, 1, 0.5]]}})"),
            std::vector{gradient_image({6, 4}, {red, blue, red, blue}, TextureFormat::rgba8)});
  EXPECT_EQ(
      level(
          R"({"size": [6, 4], "gradient": {"colors": [[1, 0, 0], [0, 0, 1, 0.5], [0, 0, 0], [1, 1, 1]]}})"),
      std::vector{gradient_image({6, 4}, {red, blue, {0, 0, 0, 255}, {255, 255, 255, 255}},
                                 TextureFormat::rgba8)});
  EXPECT_EQ(level(R"({"size": [6, 4], "format": "rgba32f", "zone-plate": {}})"),
            std::vector{zone_plate_image({6, 4}, TextureFormat::rgba32f)});
  EXPECT_EQ(level(R"({"size": [6, 4], "format": "srgb8", "noise": {"seed": 7}})"),
            std::vector{noise_image({6, 4}, TextureFormat::srgb8, 7)});
  EXPECT_EQ(level(R"({"size": [6, 4], "levels": {}})"),
            flat_levels({6, 4}, level_colors(3, TextureFormat::rgba8)));
  EXPECT_EQ(level(R"({"size": [2, 1], "levels": {"colors": [[1, 0, 0], [0, 0, 1, 0.5]]}})"),
            flat_levels({2, 1}, std::vector{red, blue}));
  EXPECT_EQ(level(R"({"size": [6, 4], "mipmaps": "box", "noise": {"seed": 7}})"),
            box_chain(noise_image({6, 4}, TextureFormat::rgba8, 7), TextureFormat::rgba8));
}

TEST(TextureReader, PicturesHaveTheirTopRowFirst) {
  const Texture texture = texture_of(
      R"({"texels": [[[1, 0, 0], [0, 1, 0]], [[0, 0, 1], [1, 1, 1, 0]], [[0, 0, 0], [1, 1, 0]]]})");
  ASSERT_EQ(texture.levels.size(), 1U);
  EXPECT_EQ(texture.levels[0].width, 2);
  EXPECT_EQ(texture.levels[0].height, 3);
  EXPECT_EQ(texture.levels[0].texels,
            (std::vector<float>{0,   0,   0,   255, 255, 255, 0, 255, 0, 0,   255, 255,
                                255, 255, 255, 0,   255, 0,   0, 255, 0, 255, 0,   255}));
}

TEST(TextureReader, GeneratedChainsHaveOneLevel) {
  const Texture texture = texture_of(R"({"size": [4, 4], "mipmaps": "generated", "checker": {}})");
  EXPECT_TRUE(texture.generated);
  EXPECT_EQ(texture.levels.size(), 1U);
  EXPECT_TRUE(has_whole_chain(texture));
}

TEST(TextureReader, OneDimensionalTexturesHaveOneCoordinate) {
  const auto cases = cases_of(
      R"([{"size": [4], "checker": {}}])",
      R"("texture": 0, "sampler": {"wrap": "clamp-to-edge"}, "lookup": {"gradients": [[2], [3]]})",
      "[0.5]");
  ASSERT_EQ(cases.size(), 1U);
  const Scene& scene = cases[0].scene;
  EXPECT_EQ(scene.textures[0]->dimensions, 1);
  EXPECT_EQ(scene.textures[0]->levels[0].height, 1);
  EXPECT_EQ(scene.draws[0].vertices[0].texture_coordinates, (std::array<float, 2>{0.5F, 0}));
  const TextureUse& use = *scene.draws[0].texture;
  EXPECT_EQ(use.sampler.wrap, (std::array<Wrap, 2>{Wrap::clamp_to_edge, Wrap::clamp_to_edge}));
  EXPECT_EQ(use.lookup.dx, (std::array<float, 2>{2, 0}));
  EXPECT_EQ(use.lookup.dy, (std::array<float, 2>{3, 0}));
}

TEST(TextureReader, ReadsEverySamplerKey) {
  const auto cases = cases_of(
      R"([{"size": [1], "checker": {}}, {"size": [8, 8], "mipmaps": "box", "zone-plate": {}}])",
      R"("texture": 1, "lookup": {"bias": -1.5}, "sampler": {
           "wrap": ["mirrored-repeat", "clamp-to-border"], "magnify": "nearest",
           "minify": "linear", "mipmap": "nearest", "lod_bias": 0.5, "min_lod": -2, "max_lod": "5/2",
           "base_level": 1, "max_level": 3, "border": [0.1, 0.2, 0.3, 0.4], "max_anisotropy": 2.5})");
  ASSERT_EQ(cases.size(), 1U);
  TextureUse expected;
  expected.texture = 1;
  expected.sampler = {{Wrap::mirrored_repeat, Wrap::clamp_to_border},
                      Filter::nearest,
                      Filter::linear,
                      MipFilter::nearest,
                      0.5F,
                      -2,
                      2.5F,
                      1,
                      3,
                      {0.1F, 0.2F, 0.3F, 0.4F},
                      2.5F};
  expected.lookup = {LookupKind::bias, -1.5F, {}, {}};
  EXPECT_EQ(cases[0].scene.draws[0].texture, expected);
}

TEST(TextureReader, CasesShareTexturesThatNoAxisTouches) {
  const auto cases =
      cases_of(R"([{"size": [4, 4], "checker": {}}, {"size": [4, 4], "noise": {"seed": 1}}])",
               R"("texture": 0)", "[0, 0]", R"(, "sweep": {
      "s": {"set": ["/draws/0/vertices/0/s"], "values": [0, 1, 2]},
      "t": {"add_to": ["/draws/0/vertices/0/t"], "values": [0, 0.5]},
      "bias": {"set": ["/draws/0/state/sampler/lod_bias"], "values": [0, 1]},
      "seed": {"set": ["/textures/1/noise/seed"], "values": [1, 2]}}, "variants": ["translate"])");
  ASSERT_EQ(cases.size(), 3U * 2 * 2 * 2 * 2);
  std::set<const Texture*> first;
  std::set<const Texture*> second;
  std::set<std::array<float, 3>> numbers;
  for (const Case& one : cases) {
    first.insert(one.scene.textures.at(0).get());
    second.insert(one.scene.textures.at(1).get());
    const Draw& draw = one.scene.draws[0];
    const auto& [s, t] = draw.vertices[0].texture_coordinates;
    numbers.insert({s, t, draw.texture->sampler.lod_bias});
    EXPECT_TRUE(one.scene.details.texture);
  }
  EXPECT_EQ(first.size(), 1U);
  EXPECT_EQ(second.size(), 2U);
  EXPECT_EQ(numbers.size(), 12U);
}

// Images have the texture coordinates of the vertices that they moved, and gradients that fit.
TEST(TextureReader, VariantsKeepTextureCoordinatesWithTheirVertices) {
  const LoadedCases loaded = load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 8, "height": 4},
          "textures": [{"size": [2, 2], "checker": {}}],
          "draws": [{"primitive": "triangles", "vertices": [
              {"at": [0, 0], "uv": [0, 1]}, {"at": [2, 1], "uv": [2, 3]}, {"at": [1, 3], "uv": [4, 5]}],
            "state": {"texture": 0, "lookup": {"gradients": [[1, 2], [3, 4]]}}}],
          "variants": ["reverse", "winding", "octants", "translate"]})",
      "a.json", "a");
  for (const Diagnostic& diagnostic : loaded.diagnostics) ADD_FAILURE() << to_string(diagnostic);
  ASSERT_EQ(loaded.cases.size(), 11U);
  const auto use = [&](std::size_t i) { return loaded.cases[i].scene.draws[0].texture->lookup; };
  const auto uv = [&](std::size_t i, std::size_t v) {
    return loaded.cases[i].scene.draws[0].vertices[v].texture_coordinates;
  };
  using Pair = std::array<float, 2>;
  EXPECT_EQ(uv(1, 0), (Pair{4, 5}));  // reverse
  EXPECT_EQ(uv(2, 1), (Pair{4, 5}));  // winding
  for (std::size_t i = 3; i < 11; ++i)
    for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(uv(i, v), uv(0, v)) << loaded.cases[i].id;
  EXPECT_EQ(use(1), use(0));
  EXPECT_EQ(use(10), use(0));            // translate
  EXPECT_EQ(use(3).dx, (Pair{-1, -2}));  // octant=1
  EXPECT_EQ(use(3).dy, (Pair{3, 4}));
  EXPECT_EQ(use(4).dx, (Pair{1, 2}));  // octant=2
  EXPECT_EQ(use(4).dy, (Pair{-3, -4}));
  EXPECT_EQ(use(9).dx, (Pair{-3, -4}));  // octant=7
  EXPECT_EQ(use(9).dy, (Pair{-1, -2}));
}

TEST(TextureReader, MeshesHaveTextureCoordinatesAndGradientsTurnWithY) {
  const LoadedCases loaded = load_cases(kGood / "textures-everything.json", "a");
  ASSERT_FALSE(loaded.cases.empty());
  const Lookup& lookup = loaded.cases[0].scene.draws[0].texture->lookup;
  EXPECT_EQ(lookup.dx, (std::array<float, 2>{0.3F, 0}));
  EXPECT_EQ(lookup.dy, (std::array<float, 2>{-1, 0.0625F}));  // y is down in the file
  const std::vector<Vertex>& vertices = loaded.cases[0].scene.draws[3].vertices;
  ASSERT_EQ(vertices.size(), 6U);
  const float expected[][2] = {{0, 0}, {2, 0}, {2, 0.1F}, {0, 0}};
  for (const Vertex& vertex : vertices) {
    // The corners of the square from -1/2 to 1/2, in the order of the file; y is down.
    const bool right = vertex.clip->x > 0;
    const bool upper = vertex.clip->y < 0;
    const auto corner = static_cast<std::size_t>(upper ? (right ? 2 : 3) : (right ? 1 : 0));
    EXPECT_EQ(vertex.texture_coordinates[0], expected[corner][0]);
    EXPECT_EQ(vertex.texture_coordinates[1], expected[corner][1]);
    EXPECT_EQ(vertex.color, (Color{1, 1, 1, 1}));
  }
}

TEST(ImageFile, CodesAreThoseOfTheFileFromTheBottom) {
  const ImageFile image = read_image(kGood / "images" / "codes.png", 1024);
  ASSERT_EQ(image.error, "");
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.bits, 8);
  EXPECT_EQ(image.rgba, (std::vector<float>{1,   2, 3, 4,   250, 251, 252, 253, 127, 128, 129, 130,
                                            255, 0, 0, 255, 0,   255, 0,   128, 0,   0,   255, 0}));
  const Texture texture = texture_of(R"({"file": "images/codes.png", "size": [3, 2]})");
  ASSERT_EQ(texture.levels.size(), 1U);
  EXPECT_EQ(texture.levels[0].texels, image.rgba);
}

TEST(ImageFile, GreyIsSpread) {
  EXPECT_EQ(read_image(kGood / "images" / "grey.png", 1024).rgba,
            (std::vector<float>{0, 0, 0, 255, 200, 200, 200, 255}));
  EXPECT_EQ(read_image(kGood / "images" / "grey-alpha.png", 1024).rgba,
            (std::vector<float>{10, 10, 10, 0, 200, 200, 200, 99}));
}

TEST(ImageFile, DeepImagesAreTheNearestFloats) {
  EXPECT_EQ(read_image(kGood / "images" / "deep.png", 1024).rgba,
            (std::vector<float>{0, 1, 65535, 65535, 32768, 257, 12345, 7}));
  const Texture texture = texture_of(R"({"format": "rgba32f", "file": "images/deep.png"})");
  const std::vector<float> expected{0,
                                    static_cast<float>(1 / 65535.0),
                                    1,
                                    1,
                                    static_cast<float>(32768 / 65535.0),
                                    static_cast<float>(1 / 255.0),
                                    static_cast<float>(12345 / 65535.0),
                                    static_cast<float>(7 / 65535.0)};
  EXPECT_EQ(texture.levels.at(0).texels, expected);
  const Texture coded = texture_of(R"({"format": "rgba32f", "file": "images/codes.png"})");
  EXPECT_EQ(coded.levels.at(0).texels.at(4), static_cast<float>(250 / 255.0));
}

TEST(ImageFile, FloatingPointIsTakenAsItStands) {
  const Texture texture = texture_of(R"({"format": "rgba32f", "file": "images/float.exr"})");
  EXPECT_EQ(texture.levels.at(0).texels, (std::vector<float>{2, 1e-40F, 7, 0, -4, 6, 8, 1, 0.25F,
                                                             1e30F, -2.5F, 1, 3, 0.1F, 0, 0.5F}));
}

TEST(ImageFile, WhatIsWrittenIsReadBack) {
  const fs::path file = fs::path(testing::TempDir()) / "edgecase-round-trip.png";
  const TextureLevel noise = noise_image({37, 19}, TextureFormat::rgba8, 3);
  const std::vector<std::uint8_t> bytes(noise.texels.begin(), noise.texels.end());
  ASSERT_EQ(write_png(file, {37, 19, bytes}, 1), "");
  const ImageFile image = read_image(file, 37);
  EXPECT_EQ(image.error, "");
  EXPECT_EQ(image.rgba, noise.texels);
  EXPECT_EQ(read_image(file, 36).error, "it has 37 x 19 pixels");
  fs::remove(file);
  EXPECT_NE(read_image(file, 37).error, "");
}

TEST(TextureReader, FilesStayInsideTheSuiteWhateverLinksSay) {
  const fs::path root = fs::temp_directory_path() / "edgecase-texture-test";
  fs::remove_all(root);
  fs::create_directories(root / "cases" / "deep");
  fs::create_directories(root / "other");
  for (const fs::path& folder : {root / "cases" / "deep", root / "other"})
    fs::copy_file(kGood / "images" / "codes.png", folder / "a.png");
  fs::create_symlink("../other/a.png", root / "cases" / "link.png");
  fs::create_symlink("deep/a.png", root / "cases" / "inside.png");
  fs::create_directory_symlink("../other", root / "cases" / "folder");
  const auto load = [&](const std::string& file) {
    return load_cases_text(
        R"({"title": "t", "rules": ["a.b"], "target": {"width": 4, "height": 4}, "textures": )"
        R"([{"file": ")" +
            file +
            R"("}], "draws": [{"primitive": "points", "vertices": )"
            R"([{"at": [1, 1], "uv": [0, 0]}], "state": {"texture": 0}}]})",
        root / "cases" / "deep" / "a.json", "deep/a");
  };
  for (const char* path : {"a.png", "../deep/a.png", "../inside.png"})
    EXPECT_EQ(load(path).cases.size(), 1U) << path;
  const std::string absolute = (root / "cases" / "deep" / "a.png").string();
  for (const std::string& path :
       {std::string("../link.png"), std::string("../folder/a.png"),
        std::string("../../other/a.png"), std::string("../../cases/../other/a.png"), absolute}) {
    const LoadedCases loaded = load(path);
    ASSERT_EQ(loaded.diagnostics.size(), 1U) << path;
    EXPECT_EQ(loaded.diagnostics[0].pointer, "/textures/0/file");
    EXPECT_EQ(loaded.diagnostics[0].message, "\"" + path + "\" leaves the folder of the cases");
    EXPECT_FALSE(loaded.diagnostics[0].remedy.empty());
  }
  fs::remove_all(root);
}

}  // namespace
}  // namespace edgecase
