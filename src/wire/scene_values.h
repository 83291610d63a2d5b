// SPDX-License-Identifier: MIT
//
// The numbers, colours and vertices of a scene as JSON, for src/wire alone: request_line.h makes
// lines of them. Writers append to a buffer; readers throw a Refusal for what model/scene.h does
// not allow.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json_fwd.hpp>

#include "model/scene.h"
#include "wire/reading.h"

namespace edgecase::wire {

using Output = std::back_insert_iterator<fmt::memory_buffer>;

// A finite number as the shortest decimal that reads back as the same double: 1.0, not 1, so that
// coordinates and colours look like what they are.
void write_number(Output out, double value);
void write_color(Output out, const Color& color);
// The string that stands for a number that is not finite. False for a finite one: nothing is
// written.
bool write_not_finite(Output out, double value);
// Only a textured draw's vertices have texture coordinates.
void write_vertex(Output out, const Vertex& vertex, bool is_textured);

// Which numbers may stand somewhere, both limits inclusive; `wanted` says so in words.
struct FloatRange {
  double low;
  double high;
  const char* wanted;
};

// A float32 value within a range, and any finite one.
float read_float32(const nlohmann::json& value, const Path& path, const FloatRange& range);
float read_any_float32(const nlohmann::json& value, const Path& path);

// A multiple of 2^-16 of -8192 to 8192.
Fixed read_fixed(const nlohmann::json& value, const Path& path);

// Four float32 values of 0 to 1.
Color read_clear_color(const nlohmann::json& value, const Path& path);

// A vertex, with clip coordinates that are exact in float32 where its w is not 1, and a position
// that belongs to the clip coordinates where it has some. Texture coordinates are required of a
// textured draw, and refused elsewhere.
Vertex read_vertex(const nlohmann::json& value, const Path& path, const Viewport& viewport,
                   bool is_textured);

}  // namespace edgecase::wire
