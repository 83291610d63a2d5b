// SPDX-License-Identifier: MIT
#include "wire/sample_values.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace edgecase::wire {

using nlohmann::json;

namespace {

constexpr double kOne = static_cast<double>(Fixed::kOne);

std::uint32_t all_samples(int samples) {
  return (1U << samples) - 1;
}

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

}  // namespace

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

void write_multisampling(Output out, const Multisampling& multisampling, int samples) {
  fmt::format_to(out, R"({{"enabled":{},"location":"{}")", multisampling.enabled,
                 name_of(multisampling.location));
  if (multisampling.min_sample_shading) {
    fmt::format_to(out, R"(,"min_sample_shading":)");
    write_number(out, static_cast<double>(*multisampling.min_sample_shading));
  }
  fmt::format_to(out, R"(,"mask":{},"alpha_to_coverage":{}}})",
                 multisampling.mask & all_samples(samples), multisampling.alpha_to_coverage);
}

Multisampling read_multisampling(const json& value, const Path& path, int samples) {
  require_object(value, path,
                 {"enabled", "location", "min_sample_shading", "mask", "alpha_to_coverage"});
  Multisampling result;
  result.enabled = read_bool(member(value, path, "enabled"), {path, "enabled"});
  result.location = read_name<AttributeLocation>(value, path, "location");
  if (const json* share = optional_member(value, "min_sample_shading"))
    result.min_sample_shading =
        read_float32(*share, {path, "min_sample_shading"}, {0, 1, "a float32 value of 0 to 1"});
  const std::uint32_t all = all_samples(samples);
  const auto mask =
      static_cast<std::uint32_t>(read_integer(member(value, path, "mask"), {path, "mask"}, 0, all));
  if (mask != all) result.mask = mask;
  result.alpha_to_coverage =
      read_bool(member(value, path, "alpha_to_coverage"), {path, "alpha_to_coverage"});
  return result;
}

}  // namespace edgecase::wire
