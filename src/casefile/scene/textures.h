// SPDX-License-Identifier: MIT
//
// Reads `textures`: images that the draws of a case look up.
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

constexpr std::size_t kMaxTextures = 16;  // of a case
constexpr int kMaxNoiseSeed = 65535;
// What makes the levels below the first, the one that is meant where none is named first.
inline const std::vector<std::string> kMipmaps{"none", "box", "generated"};

// Numbers of an rgba32f texture: any finite float32.
constexpr float kMaxTexel = 3.40282346638528859811704183484516925e+38F;

// The textures that the cases of one file use, each made once: cases whose files say the same of a
// texture share it.
class TextureShelf {
 public:
  // `case_file` is what the paths of images are relative to (casefile/json/text_file.h).
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

// How a draw looks up its texture: "texture", "sampler" and "lookup" of a state, and "uv" of its
// vertices.
constexpr float kMaxGradient = 1048576;  // largest magnitude of a given gradient, per pixel

// What a state says; `use` is none without a texture, and where its number is wrong.
struct TextureState {
  bool textured = false;  // there is a "texture"
  std::optional<TextureUse> use;
  int dimensions = 0;  // of the texture; 0: it is faulty, and nothing is known of it
};

// `textures` are the case's; none: their list is faulty, so that no number can be judged.
TextureState read_texture_state(const ObjectReader& state,
                                const std::optional<TextureList>& textures, Findings& findings);

// The inverse: "texture", and "sampler" and "lookup" where they are not the defaults. `dimensions`
// are the texture's.
std::vector<JsonPiece> texture_use_pieces(const TextureUse& use, int dimensions);

// "uv".
JsonPiece uv_piece(const std::array<float, 2>& coordinates, int dimensions);

// Textures as a case file says them: the inverse of reading them.

// An item of "textures". Images of more than a few texels are written as the pattern that makes
// them, where there is one. A chain that is neither generated, nor made by boxes, nor flat level by
// level cannot be said: its first level is written alone.
JsonPiece texture_piece(const Texture& texture);

// The definitions of textures, samplers and lookups in the schema.
Pieces texture_schemas();
Pieces texture_use_schemas();

}  // namespace edgecase
