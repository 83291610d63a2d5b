// SPDX-License-Identifier: MIT
#include "results/samples_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "results/hex.h"
#include "results/whole_number.h"

namespace edgecase {
namespace {

void write_position(JsonWriter& json, const Point& at) {
  json.array(at.x.to_double(), at.y.to_double());
}

void check_size(const char* what, std::size_t found, std::size_t wanted) {
  if (found != 0 && found != wanted)
    throw std::runtime_error(
        fmt::format("\"{}\" of samples has {} items instead of {}", what, found, wanted));
}

// Of a place within a pixel.
Fixed to_fixed(const nlohmann::json& json) {
  const double value = json.get<double>();
  if (!(value >= 0 && value <= 1))
    throw std::runtime_error(fmt::format("{} is no place within a pixel", json.dump()));
  return Fixed::from_raw(static_cast<std::int64_t>(value * Fixed::kOne));
}

// Numbers of samples or of fragments, or masks; none where there is no such member.
std::vector<std::uint32_t> to_counts(const nlohmann::json& json, const char* member) {
  std::vector<std::uint32_t> counts;
  if (!json.contains(member)) return counts;
  for (const nlohmann::json& item : json.at(member)) counts.push_back(WholeNumber(item));
  return counts;
}

}  // namespace

void write_samples(JsonWriter& json, const SampleImage& image) {
  json.object([&] {
    json.member("count", image.samples);
    if (!image.positions.empty()) json.key("positions").list(image.positions, write_position);
    if (!image.pixels->empty()) json.key("pixels").hex(image.pixels->bytes());
    if (!image.hits->empty()) json.member("hits", image.hits->words());
    if (!image.coverage->empty()) json.member("coverage", image.coverage->words());
  });
}

SampleImage to_samples(const nlohmann::json& json, int width, int height) {
  SampleImage image;
  image.samples = WholeNumber(json.at("count"));
  if (image.samples <= 1 || image.samples > kMaxSamples)
    throw std::runtime_error(fmt::format("{} is no number of samples", image.samples));
  for (const nlohmann::json& at : json.value("positions", nlohmann::json::array()))
    image.positions.push_back({to_fixed(at.at(0)), to_fixed(at.at(1))});
  const std::vector<std::uint8_t> pixels = from_hex(json.value("pixels", ""));
  image.hits = to_counts(json, "hits");
  image.coverage = to_counts(json, "coverage");
  const auto samples = static_cast<std::size_t>(image.samples);
  const std::size_t area = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  check_size("positions", image.positions.size(), samples);
  check_size("pixels", pixels.size(), 4 * samples * area);
  image.pixels = pixels;
  check_size("hits", image.hits->size(), samples * area);
  check_size("coverage", image.coverage->size(), area);
  return image;
}

}  // namespace edgecase
