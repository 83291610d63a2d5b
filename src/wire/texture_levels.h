// SPDX-License-Identifier: MIT
//
// Levels of textures as JSON, for src/wire alone: those that a scene gives, and those that a
// renderer generated. Readers throw a Refusal.
//
// Texels are the bulk of a line that has some: whole numbers of 0 to 255 are written without a
// point, all others as json_values.h writes numbers. Either way they read back as the same float32.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "model/scene.h"
#include "model/texture.h"
#include "wire/json_values.h"
#include "wire/reading.h"

namespace edgecase::wire {

// One image: of a scene's texture, or of a chain that a renderer made.
void write_level(Output out, const TextureLevel& level);
// One level at least, with finite texels that the format holds.
std::vector<TextureLevel> read_levels(const nlohmann::json& value, const Path& path,
                                      TextureFormat format);

// The levels that a renderer generated, by the texture's number. Only textures that leave their
// levels to the renderer may be told, with texels that their format holds (not finite ones, too);
// whether number and sizes of the levels are right is left to those who judge.
std::map<std::size_t, std::vector<TextureLevel>> read_mip_chains(const nlohmann::json& value,
                                                                 const Path& path,
                                                                 const Scene& scene);

}  // namespace edgecase::wire
