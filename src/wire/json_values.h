// SPDX-License-Identifier: MIT
//
// Numbers, sample positions and texture levels as JSON, for use in src/wire only. Writers append to
// a buffer; readers throw a Refusal.
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

// Writes a finite number as the shortest decimal that reads back as the same double: 1.0, not 1, so
// that coordinates and colours are recognizable.
void write_number(Output out, double value);
// Writes the string for a number that is not finite. Returns false and writes nothing for a finite
// one.
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

// A float32 value within limits. `wanted` describes the permitted values; by default it is derived
// from the limits.
float read_float32(const nlohmann::json& value, const Path& path, Limits limits = {},
                   const char* wanted = nullptr);

template <std::size_t N>
std::array<float, N> read_float32s(const nlohmann::json& value, const Path& path,
                                   Limits limits = {});
extern template std::array<float, 2> read_float32s(const nlohmann::json&, const Path&, Limits);
extern template std::array<float, 4> read_float32s(const nlohmann::json&, const Path&, Limits);

// A multiple of 2^-16 from -8192 to 8192.
Fixed read_fixed(const nlohmann::json& value, const Path& path);

// [[x, y], ...] by sample index, in pixels from a pixel's lower left corner.
void write_positions(Output out, const SamplePositions& positions);
// The inverse: `samples` points, multiples of 2^-16 from 0 to below 1. Refused if the target has
// one sample.
SamplePositions read_positions(const nlohmann::json& value, const Path& path, int samples);
// The same as reported by a renderer: any numbers from 0 to below 1, rounded to the nearest
// multiple of 2^-16 below 1.
SamplePositions read_reported_positions(const nlohmann::json& value, const Path& path, int samples);

// Levels of textures as JSON: those that a scene gives, and those that a renderer generated.
//
// Texels are the bulk of a line that has some: whole numbers from 0 to 255 are written without a
// point, all others by write_number. Either way they read back as the same float32.

// One image of a scene's texture, or of a chain that a renderer generated.
void write_level(Output out, const TextureLevel& level);
// At least one level, with finite texels that the format can store.
std::vector<TextureLevel> read_levels(const nlohmann::json& value, const Path& path,
                                      TextureFormat format);

// The levels that a renderer generated, keyed by the number of the texture. Only textures whose
// levels the renderer generates are permitted, with texels that the format can store, including
// infinities and NaN. The number and sizes of the levels are judged later.
std::map<std::size_t, std::vector<TextureLevel>> read_mip_chains(const nlohmann::json& value,
                                                                 const Path& path,
                                                                 const Scene& scene);

}  // namespace edgecase::wire
