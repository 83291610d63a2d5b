// SPDX-License-Identifier: MIT
#include "results/samples_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "results/packed_text.h"
#include "results/shallow_json.h"
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
Fixed to_fixed(const ReadJson& json) {
  const double value = json.get<double>();
  if (!(value >= 0 && value <= 1))
    throw std::runtime_error(
        fmt::format("{} is no place within a pixel", std::string(json.dump())));
  return Fixed::from_raw(static_cast<std::int64_t>(value * Fixed::kOne));
}

void write_head(JsonWriter& json, const SampleImage& image) {
  json.member("count", image.samples);
  if (!image.positions.empty()) json.key("positions").list(image.positions, write_position);
}

SampleImage to_head(const ReadJson& json) {
  SampleImage image;
  image.samples = WholeNumber(json.at("count"));
  if (image.samples <= 1 || image.samples > kMaxSamples)
    throw std::runtime_error(fmt::format("{} is no number of samples", image.samples));
  for (const ReadJson& at : json.value("positions", ReadJson::array()))
    image.positions.push_back({to_fixed(at.at(0)), to_fixed(at.at(1))});
  check_size("positions", image.positions.size(), static_cast<std::size_t>(image.samples));
  return image;
}

// The packed words of a member; none where there is no such member.
std::vector<std::uint32_t> to_member(const ReadJson& json, const char* member, std::size_t size) {
  if (!json.contains(member)) return {};
  return to_words(to_text(json.at(member)), size);
}

std::size_t area_of(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

std::vector<std::uint32_t> difference_of(std::vector<std::uint32_t> words,
                                         const std::vector<std::uint32_t>& others) {
  if (words.size() != others.size()) return words;
  for (std::size_t i = 0; i < words.size(); ++i) words[i] ^= others[i];
  return words;
}

void write_samples(JsonWriter& json, const SampleImage& image, int width) {
  json.object([&] {
    write_head(json, image);
    if (!image.pixels->empty()) json.member("pixels", packed_picture(image.pixels->bytes(), width));
    if (!image.hits->empty()) json.member("hits", packed_words(image.hits->words()));
    if (!image.coverage->empty()) json.member("coverage", packed_words(image.coverage->words()));
  });
}

void write_samples(JsonWriter& json, const SampleImage& image, const SampleImage& exact) {
  const auto write = [&](const char* name, const std::vector<std::uint32_t>& own,
                         const std::vector<std::uint32_t>& other) {
    if (!own.empty()) json.member(name, packed_words(difference_of(own, other)));
  };
  json.object([&] {
    write_head(json, image);
    write("pixels", words_of(image.pixels->bytes()), words_of(exact.pixels->bytes()));
    write("hits", image.hits->words(), exact.hits->words());
    write("coverage", image.coverage->words(), exact.coverage->words());
  });
}

SampleImage to_samples(const ReadJson& json, int width, int height) {
  SampleImage image = to_head(json);
  const auto samples = static_cast<std::size_t>(image.samples);
  if (json.contains("pixels"))
    image.pixels = to_picture(to_text(json.at("pixels")), width, height * image.samples);
  image.hits = to_member(json, "hits", samples * area_of(width, height));
  image.coverage = to_member(json, "coverage", area_of(width, height));
  return image;
}

SampleImage to_samples(const ReadJson& json, int width, int height, const SampleImage& exact) {
  SampleImage image = to_head(json);
  const auto samples = static_cast<std::size_t>(image.samples);
  const std::size_t area = area_of(width, height);
  const auto read = [&](const char* member, std::size_t size,
                        const std::vector<std::uint32_t>& other) {
    return difference_of(to_member(json, member, size), other);
  };
  image.pixels = bytes_of(read("pixels", samples * area, words_of(exact.pixels->bytes())));
  image.hits = read("hits", samples * area, exact.hits->words());
  image.coverage = read("coverage", area, exact.coverage->words());
  image.share_with(exact);
  return image;
}

}  // namespace edgecase
