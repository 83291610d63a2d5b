// SPDX-License-Identifier: MIT
//
// Files that nobody wrote: sound ones with bytes changed, left out and doubled. Each is loaded or
// refused with a place and a remedy, and what is loaded keeps the model's promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "casefile/case_writer.h"
#include "casefile/loader.h"
#include "casefile/scene/viewport.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

const fs::path kGood = fs::path(EDGECASE_ROOT) / "tests" / "casefile" / "good";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// Exchanges one number of a text for another.
void change_number(std::string& text, std::mt19937& random) {
  static const std::string kNumbers[] = {"0",    "-1",     "1e308", "-0.0",   "1e-46", "65536",
                                         "8192", "1e9999", "0.3",   "3.4e38", "1e-7",  "\"~0.7\""};
  std::size_t at = text.find_first_of("0123456789", random() % text.size());
  if (at == std::string::npos) return;
  const std::size_t end = text.find_first_not_of("0123456789.e+-", at);
  text.replace(at, end - at, kNumbers[random() % std::size(kNumbers)]);
}

void spoil(std::string& text, std::mt19937& random) {
  const std::size_t at = random() % text.size();
  switch (random() % 6) {
    case 0:
      text.erase(at, 1 + random() % 20);
      break;
    case 1:
      text[at] = static_cast<char>(random());
      break;
    case 2:
      text.insert(at, text.substr(random() % text.size(), random() % 30));
      break;
    default:
      change_number(text, random);
  }
}

void check_vertex(const Vertex& vertex) {
  if (!vertex.clip) {
    EXPECT_GE(vertex.w, kMinW);
  }
  EXPECT_LE(std::fabs(vertex.w), kMaxW);
  EXPECT_TRUE(vertex.position.x.in_coordinate_range());
  EXPECT_TRUE(vertex.position.y.in_coordinate_range());
  EXPECT_LE(std::abs(vertex.z.raw()), Fixed::kOne);
  for (const float component : vertex.color) EXPECT_TRUE(std::isfinite(component));
  for (const float component : vertex.texture_coordinates) EXPECT_TRUE(std::isfinite(component));
  if (!vertex.clip) return;
  EXPECT_FALSE(find_clip_fault(*vertex.clip, "it").has_value());
  EXPECT_EQ(round_to_grid(*vertex.clip), *vertex.clip);
  EXPECT_EQ(vertex.clip->w, vertex.w);
}

void check_texture(const Texture* texture) {
  ASSERT_NE(texture, nullptr);
  ASSERT_FALSE(texture->levels.empty());
  const TextureLevel& base = texture->levels[0];
  for (std::size_t k = 0; k < texture->levels.size(); ++k) {
    const TextureLevel& level = texture->levels[k];
    EXPECT_EQ(level.width, level_size(base.width, static_cast<int>(k)));
    EXPECT_EQ(level.height, level_size(base.height, static_cast<int>(k)));
    EXPECT_EQ(level.texels.size(), level.index(0, level.height));
    for (const float number : level.texels) EXPECT_TRUE(std::isfinite(number));
  }
}

void check_samples(const Scene& scene) {
  const Target& target = scene.target;
  EXPECT_GE(target.samples, 1);
  EXPECT_LE(target.samples, kMaxSamples);
  const auto count = static_cast<std::size_t>(target.samples);
  EXPECT_TRUE(target.sample_positions.empty() || target.sample_positions.size() == count);
  for (const Point within : target.sample_positions) {
    EXPECT_GE(std::min(within.x, within.y), Fixed());
    EXPECT_LT(std::max(within.x, within.y), Fixed::from_integer(1));
  }
  for (const Draw& draw : scene.draws) {
    if (target.samples == 1) {
      EXPECT_EQ(draw.multisampling, Multisampling{});
    }
    const float share = draw.multisampling.min_sample_shading.value_or(0);
    EXPECT_TRUE(share >= 0 && share <= 1);
  }
}

void check(const LoadedCases& loaded) {
  EXPECT_EQ(loaded.cases.empty(), !loaded.diagnostics.empty());
  for (const Diagnostic& fault : loaded.diagnostics) {
    EXPECT_FALSE(fault.message.empty());
    EXPECT_FALSE(fault.remedy.empty()) << fault.message;
    EXPECT_GT(fault.line, 0) << fault.message;
  }
  for (const Case& one : loaded.cases) {
    for (const auto& texture : one.scene.textures) check_texture(texture.get());
    check_samples(one.scene);
    for (const Draw& draw : one.scene.draws) {
      for (const Vertex& vertex : draw.vertices) check_vertex(vertex);
      if (!draw.texture) continue;
      EXPECT_LT(draw.texture->texture, one.scene.textures.size());
      EXPECT_TRUE(one.scene.details.texture);
    }
  }
}

TEST(Hostile, SpoiltFilesAreLoadedOrRefused) {
  std::mt19937 random(9);
  int loaded_files = 0;
  for (const char* name : {"values-everything.json", "everything.json", "sweep-everything.json",
                           "textures-everything.json", "samples-everything.json"}) {
    const std::string sound = text_of(kGood / name);
    ASSERT_FALSE(sound.empty());
    for (int round = 0; round < 500; ++round) {
      std::string text = sound;
      for (unsigned i = 0; i < 1 + random() % 3; ++i)
        if (!text.empty()) spoil(text, random);
      const LoadedCases loaded = load_cases_text(text, kGood / name, "hostile");
      check(loaded);
      loaded_files += loaded.cases.empty() ? 0 : 1;
      if (HasFailure()) {
        ADD_FAILURE() << text;
        return;
      }
    }
  }
  EXPECT_GT(loaded_files, 100);
  EXPECT_LT(loaded_files, 2400);
}

}  // namespace
}  // namespace edgecase
