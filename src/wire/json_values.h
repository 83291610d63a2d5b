// SPDX-License-Identifier: MIT
//
// Numbers and positions of samples as JSON, for src/wire alone. Writers append to a buffer; readers
// throw a Refusal.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "model/scene.h"
#include "model/scene_fields.h"
#include "model/texture.h"
#include "wire/reading.h"

namespace edgecase::wire {

using Output = std::back_insert_iterator<fmt::memory_buffer>;

// A finite number as the shortest decimal that reads back as the same double: 1.0, not 1, so that
// coordinates and colours look like what they are.
void write_number(Output out, double value);
// The string that stands for a number that is not finite. False for a finite one: nothing is
// written.
bool write_not_finite(Output out, double value);

// [1.0,0.5]
template <std::size_t N>
void write_numbers(Output out, const std::array<float, N>& numbers) {
  for (std::size_t i = 0; i < N; ++i) {
    *out++ = i == 0 ? '[' : ',';
    write_number(out, static_cast<double>(numbers[i]));
  }
  *out++ = ']';
}

// A float32 value within limits. `wanted` says in words what may stand there; left out, it is made
// of the limits.
float read_float32(const nlohmann::json& value, const Path& path, Limits limits = {},
                   const char* wanted = nullptr);

template <std::size_t N>
std::array<float, N> read_float32s(const nlohmann::json& value, const Path& path,
                                   Limits limits = {});
extern template std::array<float, 2> read_float32s(const nlohmann::json&, const Path&, Limits);
extern template std::array<float, 4> read_float32s(const nlohmann::json&, const Path&, Limits);

// A multiple of 2^-16 of -8192 to 8192.
Fixed read_fixed(const nlohmann::json& value, const Path& path);

// [[x, y], ...] by sample index, in pixels from a pixel's lower left corner.
void write_positions(Output out, const SamplePositions& positions);
// The inverse: `samples` points, multiples of 2^-16 of 0 to below 1. There are none where the
// target has one sample.
SamplePositions read_positions(const nlohmann::json& value, const Path& path, int samples);
// The same as a renderer tells them: any numbers of 0 to below 1, of which the nearest multiples of
// 2^-16 below 1 are taken.
SamplePositions read_told_positions(const nlohmann::json& value, const Path& path, int samples);

// Levels of textures as JSON, for src/wire alone: those that a scene gives, and those that a
// renderer generated. Readers throw a Refusal.
//
// Texels are the bulk of a line that has some: whole numbers of 0 to 255 are written without a
// point, all others as json_values.h writes numbers. Either way they read back as the same float32.

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
