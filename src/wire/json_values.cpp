// SPDX-License-Identifier: MIT
#include "wire/json_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "wire/json_size.h"

namespace edgecase::wire {

using nlohmann::json;

namespace {

[[noreturn]] void refuse_type(const json& value, const Path& path, const char* wanted) {
  throw Refusal(fmt::format("{} must be {}, but it is {}", path.text(), wanted,
                            value.is_structured() ? value.type_name() : excerpt(value.dump(), 40)));
}

}  // namespace

std::string Path::pointer() const {
  if (parent_ == nullptr) return "";
  return parent_->pointer() + "/" + (key_ != nullptr ? std::string(key_) : std::to_string(index_));
}

std::string Path::text() const {
  return parent_ == nullptr ? "the line" : pointer();
}

json parse_text(std::string_view line) {
  return parse_text(line, [](std::string_view text) { return json::parse(text); });
}

json parse_text(std::string_view line, const std::function<json(std::string_view)>& parse) {
  if (size_of_json(line).levels > kMostLevels)
    throw Refusal(fmt::format("the line is nested deeper than {} levels", kMostLevels));
  try {
    return parse(line);
  } catch (const json::exception& error) {
    // The library's message follows its tag in brackets.
    const std::string_view text = error.what();
    const std::size_t tag = text.find("] ");
    throw Refusal("this is no line of JSON: " +
                  excerpt(tag == text.npos ? text : text.substr(tag + 2), 200));
  }
}

void require_object(const json& value, const Path& path, std::initializer_list<const char*> known) {
  require_object(value, path, std::span(known.begin(), known.size()));
}

void require_object(const json& value, const Path& path, std::span<const char* const> known) {
  if (!value.is_object()) refuse_type(value, path, "an object");
  for (const auto& [key, ignored] : value.items()) {
    const auto is_key = [&key = key](const char* name) { return key == name; };
    if (std::any_of(known.begin(), known.end(), is_key)) continue;
    throw Refusal(fmt::format("{} has the unknown key \"{}\"; known are {}", path.text(),
                              excerpt(key, 40), fmt::join(known, ", ")));
  }
}

void require_array(const json& value, const Path& path, std::size_t size) {
  if (!value.is_array()) refuse_type(value, path, "an array");
  if (value.size() == size) return;
  throw Refusal(
      fmt::format("{} must have {} elements, but it has {}", path.text(), size, value.size()));
}

const json& member(const json& object, const Path& path, const char* key) {
  const json* found = optional_member(object, key);
  if (found == nullptr) throw Refusal(fmt::format("{} has no \"{}\"", path.text(), key));
  return *found;
}

const json* optional_member(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::int64_t read_integer(const json& value, const Path& path, std::int64_t low,
                          std::int64_t high) {
  if (!value.is_number_integer()) refuse_type(value, path, "an integer");
  // The library stores nonnegative numbers as unsigned: one beyond int64 is beyond `high`.
  const bool huge = value.is_number_unsigned() &&
                    value.get<std::uint64_t>() >
                        static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  const std::int64_t number = huge ? 0 : value.get<std::int64_t>();
  if (huge || number < low || number > high)
    throw Refusal(
        fmt::format("{} is {}, but it must be {}", path.text(), value.dump(),
                    low == high ? fmt::to_string(low) : fmt::format("{} to {}", low, high)));
  return number;
}

int read_int(const json& value, const Path& path, int low, int high) {
  return static_cast<int>(read_integer(value, path, low, high));
}

bool read_bool(const json& value, const Path& path) {
  if (!value.is_boolean()) refuse_type(value, path, "true or false");
  return value.get<bool>();
}

double read_finite(const json& value, const Path& path) {
  if (!value.is_number()) refuse_type(value, path, "a number");
  return value.get<double>();
}

double read_number(const json& value, const Path& path) {
  if (value.is_number()) return value.get<double>();
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  refuse_type(value, path, "a number, \"nan\", \"inf\" or \"-inf\"");
}

const std::string& read_string(const json& value, const Path& path) {
  if (!value.is_string()) refuse_type(value, path, "a string");
  return value.get_ref<const std::string&>();
}

void refuse_name(const std::string& name, const Path& path) {
  throw Refusal(fmt::format("{} is the unknown name \"{}\"", path.text(), excerpt(name, 40)));
}

std::string excerpt(std::string_view text, std::size_t limit) {
  std::string result;
  for (char c : text.substr(0, limit)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte >= 0x7f ? '?' : c;
  }
  return text.size() > limit ? result + "..." : result;
}

using nlohmann::json;

namespace {

constexpr double kOne = static_cast<double>(Fixed::kOne);

template <class ReadNumber>
SamplePositions read_pairs(const json& value, const Path& path, int samples,
                           ReadNumber read_number) {
  if (samples == 1) throw Refusal(path.text() + " is there, but the target has one sample");
  require_array(value, path, static_cast<std::size_t>(samples));
  SamplePositions positions;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const Path at(path, i);
    require_array(value[i], at, 2);
    positions.push_back({read_number(value[i][0], Path(at, std::size_t{0})),
                         read_number(value[i][1], Path(at, std::size_t{1}))});
  }
  return positions;
}

Fixed read_reported_number(const json& value, const Path& path) {
  const double number = read_finite(value, path);
  if (!(number >= 0 && number < 1))
    throw Refusal(fmt::format("{} is {}, but it must be 0 to below 1", path.text(), value.dump()));
  const std::int64_t nearest = std::llround(number * kOne);
  return Fixed::from_raw(std::min(nearest, Fixed::kOne - 1));
}

Fixed read_exact_number(const json& value, const Path& path) {
  const Fixed number = read_reported_number(value, path);
  if (number.to_double() != value.get<double>())
    throw Refusal(
        fmt::format("{} is {}, but it must be a multiple of 2^-16", path.text(), value.dump()));
  return number;
}

std::string float32_of(Limits limits) {
  const bool any = std::isinf(limits.low) && std::isinf(limits.high);
  return any ? "a float32 value"
             : fmt::format("a float32 value of {} to {}", limits.low, limits.high);
}

}  // namespace

void write_number(Output out, double value) {
  std::array<char, 32> text;
  const char* end = fmt::format_to_n(text.data(), text.size(), "{}", value).out;
  const std::string_view digits(text.data(), static_cast<std::size_t>(end - text.data()));
  const bool whole = digits.find_first_of(".e") == digits.npos;
  fmt::format_to(out, "{}{}", digits, whole ? ".0" : "");
}

bool write_not_finite(Output out, double value) {
  if (std::isfinite(value)) return false;
  fmt::format_to(out, "\"{}\"", std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf");
  return true;
}

float read_float32(const json& value, const Path& path, Limits limits, const char* wanted) {
  constexpr double kLargest = static_cast<double>(std::numeric_limits<float>::max());
  const double number = read_finite(value, path);
  if (!(number >= limits.low && number <= limits.high) || std::fabs(number) > kLargest ||
      static_cast<double>(static_cast<float>(number)) != number)
    throw Refusal(fmt::format("{} is {}, but it must be {}", path.text(), value.dump(),
                              wanted != nullptr ? wanted : float32_of(limits)));
  return static_cast<float>(number);
}

template <std::size_t N>
std::array<float, N> read_float32s(const json& value, const Path& path, Limits limits) {
  require_array(value, path, N);
  std::array<float, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) numbers[i] = read_float32(value[i], {path, i}, limits);
  return numbers;
}
template std::array<float, 2> read_float32s(const json&, const Path&, Limits);
template std::array<float, 4> read_float32s(const json&, const Path&, Limits);

Fixed read_fixed(const json& value, const Path& path) {
  const double number = read_finite(value, path);
  const double raw = number * static_cast<double>(Fixed::kOne);
  if (!(number >= -Fixed::kMaxCoordinate && number <= Fixed::kMaxCoordinate) ||
      raw != static_cast<double>(static_cast<std::int64_t>(raw)))
    throw Refusal(fmt::format("{} is {}, but it must be a multiple of 2^-16 of -8192 to 8192",
                              path.text(), value.dump()));
  return Fixed::from_raw(static_cast<std::int64_t>(raw));
}

void write_positions(Output out, const SamplePositions& positions) {
  *out++ = '[';
  for (std::size_t i = 0; i < positions.size(); ++i) {
    fmt::format_to(out, "{}", i == 0 ? "[" : ",[");
    write_number(out, positions[i].x.to_double());
    *out++ = ',';
    write_number(out, positions[i].y.to_double());
    *out++ = ']';
  }
  *out++ = ']';
}

SamplePositions read_positions(const json& value, const Path& path, int samples) {
  return read_pairs(value, path, samples, read_exact_number);
}

SamplePositions read_reported_positions(const json& value, const Path& path, int samples) {
  return read_pairs(value, path, samples, read_reported_number);
}

namespace {

constexpr int kMaxCode = 255;

void write_texel(Output out, float value) {
  const bool is_code = value >= 0 && value <= static_cast<float>(kMaxCode) &&
                       value == std::trunc(value) && !std::signbit(value);
  if (is_code) {
    const fmt::format_int digits(static_cast<int>(value));
    std::copy(digits.data(), digits.data() + digits.size(), out);
  } else if (!write_not_finite(out, static_cast<double>(value))) {
    write_number(out, static_cast<double>(value));
  }
}

// Reads a number of a texel: one that the format can store and that may occur here.
using ReadTexel = float (*)(const json& value, const Path& path);

float read_code(const json& value, const Path& path) {
  return static_cast<float>(read_integer(value, path, 0, kMaxCode));
}

float read_generated_float32(const json& value, const Path& path) {
  return value.is_string() ? static_cast<float>(read_number(value, path))
                           : read_float32(value, path);
}

constexpr std::size_t kComponents = 4;

// A level of a single colour is given by one texel.
std::vector<float> repeated(const json& texel, const Path& path, const TextureLevel& level,
                            ReadTexel read_texel) {
  require_array(texel, path, kComponents);
  std::vector<float> texels(level.index(0, level.height));
  for (std::size_t c = 0; c < kComponents; ++c) {
    const float component = read_texel(texel[c], {path, c});
    for (std::size_t i = c; i < texels.size(); i += kComponents) texels[i] = component;
  }
  return texels;
}

// The largest levels that a list may have. One texel stands for a whole level, so that a short line
// could demand much memory.
struct LevelBounds {
  int width = kMaxTextureSize;
  int height = kMaxTextureSize;
};

TextureLevel read_level(const json& value, const Path& path, ReadTexel read_texel,
                        const LevelBounds& most) {
  require_object(value, path, {"width", "height", "texels", "texel"});
  TextureLevel level;
  level.width = read_int(member(value, path, "width"), {path, "width"}, 1, most.width);
  level.height = read_int(member(value, path, "height"), {path, "height"}, 1, most.height);
  if (const json* texel = optional_member(value, "texel")) {
    if (value.contains("texels")) throw Refusal(path.text() + " has both \"texel\" and \"texels\"");
    level.texels = repeated(*texel, {path, "texel"}, level, read_texel);
    return level;
  }
  const json& texels = member(value, path, "texels");
  const Path at(path, "texels");
  require_array(texels, at, level.index(0, level.height));
  level.texels.reserve(texels.size());
  for (std::size_t i = 0; i < texels.size(); ++i)
    level.texels.push_back(read_texel(texels[i], {at, i}));
  return level;
}

std::vector<TextureLevel> read_levels(const json& value, const Path& path, ReadTexel read_texel,
                                      const LevelBounds& most = {}) {
  require_array(value, path, value.size());
  if (value.empty()) throw Refusal(path.text() + " must have an element");
  if (value.size() > kMostLevels)
    throw Refusal(fmt::format("{} has {} levels, but there are {} at most", path.text(),
                              value.size(), kMostLevels));
  std::vector<TextureLevel> levels;
  for (std::size_t i = 0; i < value.size(); ++i)
    levels.push_back(read_level(value[i], {path, i}, read_texel, most));
  return levels;
}

float read_any_float32(const json& value, const Path& path) {
  return read_float32(value, path);
}

// Whether there are several texels, all equal to the bit.
bool is_uniform(const TextureLevel& level) {
  if (level.texels.size() <= kComponents) return false;
  for (std::size_t i = kComponents; i < level.texels.size(); ++i)
    if (std::bit_cast<std::uint32_t>(level.texels[i]) !=
        std::bit_cast<std::uint32_t>(level.texels[i - kComponents]))
      return false;
  return true;
}

}  // namespace

void write_level(Output out, const TextureLevel& level) {
  const bool uniform = is_uniform(level);
  fmt::format_to(out, R"({{"width":{},"height":{},"{}":[)", level.width, level.height,
                 uniform ? "texel" : "texels");
  for (std::size_t i = 0; i < (uniform ? kComponents : level.texels.size()); ++i) {
    if (i > 0) *out++ = ',';
    write_texel(out, level.texels[i]);
  }
  *out++ = ']';
  *out++ = '}';
}

std::vector<TextureLevel> read_levels(const json& value, const Path& path, TextureFormat format) {
  return read_levels(value, path, holds_floats(format) ? read_any_float32 : read_code);
}

std::map<std::size_t, std::vector<TextureLevel>> read_mip_chains(const json& value,
                                                                 const Path& path,
                                                                 const Scene& scene) {
  if (!value.is_object()) throw Refusal(path.text() + " must be an object of arrays");
  std::map<std::size_t, std::vector<TextureLevel>> chains;
  for (const auto& [key, levels] : value.items()) {
    std::size_t number = scene.textures.size();
    std::from_chars(key.data(), key.data() + key.size(), number);
    if (number >= scene.textures.size() || std::to_string(number) != key)
      throw Refusal(fmt::format("{} has the key \"{}\", which is no number of a texture",
                                path.text(), excerpt(key, 40)));
    const Texture& texture = *scene.textures[number];
    const Path at(path, key.c_str());
    if (!texture.generated)
      throw Refusal(at.text() + " is there, but the request gives this texture's levels");
    const TextureLevel& image = texture.levels.front();
    chains[number] =
        read_levels(levels, at, holds_floats(texture.format) ? read_generated_float32 : read_code,
                    {image.width, image.height});
  }
  return chains;
}

}  // namespace edgecase::wire
