// SPDX-License-Identifier: MIT
//
// Reads `textures`: the images that the draws of a case look up.
//
// Each has exactly one source: "checker", "gradient", "zone-plate", "levels", "noise"
// (casefile/scene/patterns.h), "texels", a picture with its top row first, or "file".
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/json/json_layout.h"
#include "model/texture.h"

namespace edgecase {

constexpr std::size_t kMaxTextures = 16;  // in a case
constexpr int kMaxNoiseSeed = 65535;
// How levels below the first are made; the first name is the default.
inline const std::vector<std::string> kMipmaps{"none", "box", "generated"};

// Numbers of an rgba32f texture: any finite float32.
constexpr float kMaxTexel = 3.40282346638528859811704183484516925e+38F;

// The textures of one file's cases, each made once: cases with equal descriptions share a texture.
class TextureShelf {
 public:
  // Paths of images are relative to `case_file` (casefile/json/fields.h).
  explicit TextureShelf(std::filesystem::path case_file) : case_file_(std::move(case_file)) {}

  // The texture that an object describes. Null, and a finding, if it is faulty, or if the textures
  // of the file's cases have more than kMost texels.
  std::shared_ptr<const Texture> find(const Place& place, Findings& findings);

 private:
  static constexpr std::size_t kMost = std::size_t{1} << 23;

  std::filesystem::path case_file_;
  std::map<std::string, std::shared_ptr<const Texture>> textures_;  // by description in the file
  std::size_t texels_ = 0;                                          // of all textures
};

// A list of textures, null for faulty ones; nothing if there is no list.
using TextureList = std::vector<std::shared_ptr<const Texture>>;
std::optional<TextureList> read_textures(const Place& place, TextureShelf& shelf,
                                         Findings& findings);

// A draw's use of its texture: "texture", "sampler" and "lookup" of a state, and "uv" of its
// vertices.
constexpr float kMaxGradient = 1048576;  // largest magnitude of a given gradient, per pixel

// The content of a state; `use` is absent without a texture or if its number is wrong.
struct TextureState {
  bool textured = false;  // whether there is a "texture"
  std::optional<TextureUse> use;
  int dimensions = 0;  // of the texture; 0: unknown, since it is faulty
};

// `textures` of the case; nothing if their list is faulty, so that no number can be judged.
TextureState read_texture_state(const ObjectReader& state,
                                const std::optional<TextureList>& textures, Findings& findings);

// The inverse: "texture", and "sampler" and "lookup" unless they are the defaults. `dimensions` of
// the texture.
std::vector<JsonPiece> texture_use_pieces(const TextureUse& use, int dimensions);

// "uv".
JsonPiece uv_piece(const std::array<float, 2>& coordinates, int dimensions);

// Writes textures in the form of case files, the inverse of reading them.

// An item of "textures". Images of more than a few texels are written as the pattern that makes
// them, if there is one. A chain that is neither generated, nor made by boxes, nor flat in every
// level cannot be expressed: only its first level is written.
JsonPiece texture_piece(const Texture& texture);

// The definitions of textures, samplers and lookups in the schema.
Pieces texture_schemas();
Pieces texture_use_schemas();

}  // namespace edgecase
