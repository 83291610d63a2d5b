// SPDX-License-Identifier: MIT
#include "wire/json_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace edgecase::wire {

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

Fixed read_told_number(const json& value, const Path& path) {
  const double number = read_finite(value, path);
  if (!(number >= 0 && number < 1))
    throw Refusal(fmt::format("{} is {}, but it must be 0 to below 1", path.text(), value.dump()));
  const std::int64_t nearest = std::llround(number * kOne);
  return Fixed::from_raw(std::min(nearest, Fixed::kOne - 1));
}

Fixed read_exact_number(const json& value, const Path& path) {
  const Fixed number = read_told_number(value, path);
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

SamplePositions read_told_positions(const json& value, const Path& path, int samples) {
  return read_pairs(value, path, samples, read_told_number);
}

}  // namespace edgecase::wire
