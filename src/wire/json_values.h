// SPDX-License-Identifier: MIT
//
// Numbers, sample positions and texture levels as JSON, for use in src/wire only. Writers append to
// a buffer; readers throw a Refusal.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene.h"
#include "model/scene_fields.h"
#include "model/texture.h"

namespace edgecase::wire {

// Strict reading of JSON values from another program, for use in src/wire only: its readers throw a
// Refusal, which the public functions of this folder turn into a WireError.
//
// A Path names the current value as an RFC 6901 pointer. It is a chain of links on the stack, so an
// array of a million numbers needs no text until one of them is wrong.

class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Path {
 public:
  Path() = default;
  Path(const Path& parent, const char* key) : parent_(&parent), key_(key) {}
  Path(const Path& parent, std::size_t index) : parent_(&parent), index_(index) {}

  // "/fragments/3/x"; "the line" for the document itself.
  std::string text() const;

 private:
  std::string pointer() const;

  const Path* parent_ = nullptr;
  const char* key_ = nullptr;
  std::size_t index_ = 0;
};

// Parses a whole line; refuses anything after the first value. `parse` is the library's parser,
// with what is to be called as it goes.
nlohmann::json parse_text(std::string_view line);
nlohmann::json parse_text(std::string_view line,
                          const std::function<nlohmann::json(std::string_view)>& parse);

// Refuses values that are not objects, and keys other than `known`.
void require_object(const nlohmann::json& value, const Path& path,
                    std::span<const char* const> known);
void require_object(const nlohmann::json& value, const Path& path,
                    std::initializer_list<const char*> known);

// Refuses values that are not arrays of length `size`.
void require_array(const nlohmann::json& value, const Path& path, std::size_t size);

// The member `key`, which is required; and the optional form (nullptr if absent).
const nlohmann::json& member(const nlohmann::json& object, const Path& path, const char* key);
const nlohmann::json* optional_member(const nlohmann::json& object, const char* key);

// An integer, written as one (3, not 3.0), from low to high, both inclusive.
std::int64_t read_integer(const nlohmann::json& value, const Path& path, std::int64_t low,
                          std::int64_t high);

// The same, with limits of type int.
int read_int(const nlohmann::json& value, const Path& path, int low, int high);

bool read_bool(const nlohmann::json& value, const Path& path);

// A finite number.
double read_finite(const nlohmann::json& value, const Path& path);

// A number, or one of the strings "nan", "inf" and "-inf".
double read_number(const nlohmann::json& value, const Path& path);

const std::string& read_string(const nlohmann::json& value, const Path& path);

[[noreturn]] void refuse_name(const std::string& name, const Path& path);

// A value of an enumeration that has a parse_name.
template <class Enum>
Enum read_name(const nlohmann::json& value, const Path& path) {
  const std::string& name = read_string(value, path);
  Enum result{};
  if (!parse_name(name, result)) refuse_name(name, path);
  return result;
}

// The start of `text`, made printable, at most `limit` characters, with "..." if it was cut.
std::string excerpt(std::string_view text, std::size_t limit);

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

// The largest number of levels: of a texture of kMaxTextureSize.
constexpr std::size_t kMostLevels = 11;
static_assert(kMaxTextureSize == 1 << (kMostLevels - 1));

// One image of a scene's texture, or of a chain that a renderer generated.
void write_level(Output out, const TextureLevel& level);
// At least one level, with finite texels that the format can store.
std::vector<TextureLevel> read_levels(const nlohmann::json& value, const Path& path,
                                      TextureFormat format);

// The levels that a renderer generated, keyed by the number of the texture. Only textures whose
// levels the renderer generates are permitted, with texels that the format can store, including
// infinities and NaN. The number and sizes of the levels are judged later, but none may be larger
// than the texture's image.
std::map<std::size_t, std::vector<TextureLevel>> read_mip_chains(const nlohmann::json& value,
                                                                 const Path& path,
                                                                 const Scene& scene);

}  // namespace edgecase::wire
