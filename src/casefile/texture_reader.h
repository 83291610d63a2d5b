// SPDX-License-Identifier: MIT
//
// Reads `textures`: images that the draws of a case look up.
//
// Each has exactly one source: "checker", "gradient", "zone-plate", "levels", "noise"
// (casefile/texture_patterns.h), "texels", a picture with its top row first, or "file".
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "casefile/fields.h"
#include "model/texture.h"

namespace edgecase {

constexpr std::size_t kMaxTextures = 16;  // of a case
constexpr int kMaxNoiseSeed = 65535;

// Numbers of an rgba32f texture: any finite float32.
constexpr float kMaxTexel = 3.40282346638528859811704183484516925e+38F;

// The textures that the cases of one file use, each made once: cases whose files say the same of a
// texture share it.
class TextureShelf {
 public:
  // `case_file` is what the paths of images are relative to (casefile/suite_path.h).
  explicit TextureShelf(std::filesystem::path case_file) : case_file_(std::move(case_file)) {}

  // The texture that an object describes; null, and a finding, where there is none, or where the
  // textures of the file's cases have more than kMost texels.
  std::shared_ptr<const Texture> find(const Place& place, Findings& findings);

 private:
  static constexpr std::size_t kMost = std::size_t{1} << 23;

  std::filesystem::path case_file_;
  std::map<std::string, std::shared_ptr<const Texture>> textures_;  // by what the file says
  std::size_t texels_ = 0;                                          // of all of them
};

// A list of textures, null where one is faulty; none where there is no list.
using TextureList = std::vector<std::shared_ptr<const Texture>>;
std::optional<TextureList> read_textures(const Place& place, TextureShelf& shelf,
                                         Findings& findings);

// Is every level there that a mip filter may ask for?
bool has_whole_chain(const Texture& texture);

}  // namespace edgecase
