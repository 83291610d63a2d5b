// SPDX-License-Identifier: MIT
//
// Textures, how a draw looks them up, and mip chains as JSON, for src/wire alone. Readers throw a
// Refusal for what model/texture.h does not allow.
//
// Texels are the bulk of a line that has some: whole numbers of 0 to 255 are written without a
// point, all others as scene_values.h writes numbers. Either way they read back as the same
// float32.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "model/scene.h"
#include "model/texture.h"
#include "wire/reading.h"
#include "wire/scene_values.h"

namespace edgecase::wire {

// One image: of a scene's texture, or of a chain that a renderer made.
void write_level(Output out, const TextureLevel& level);
void write_texture(Output out, const Texture& texture);
void write_texture_use(Output out, const TextureUse& use);

// A texture of one level or a whole chain, with finite texels.
Texture read_texture(const nlohmann::json& value, const Path& path);

// What a draw of this scene, whose textures have been read, looks up.
TextureUse read_texture_use(const nlohmann::json& value, const Path& path, const Scene& scene);

// The levels that a renderer generated, by the texture's number. Only textures that leave their
// levels to the renderer may be told, with texels that their format holds (not finite ones, too);
// whether number and sizes of the levels are right is left to those who judge.
std::map<std::size_t, std::vector<TextureLevel>> read_mip_chains(const nlohmann::json& value,
                                                                 const Path& path,
                                                                 const Scene& scene);

}  // namespace edgecase::wire
