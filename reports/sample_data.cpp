// SPDX-License-Identifier: MIT
#include "reports/sample_data.h"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "reports/base64.h"
#include "reports/pixels.h"

namespace edgecase {
namespace {

constexpr std::size_t kItem = 4;  // bytes

// Converts planes of items to a list that is ordered by pixel, then by sample.
Bytes by_pixel(const Bytes& planes, std::size_t samples) {
  Bytes out;
  out.reserve(planes.size());
  const std::size_t plane = planes.size() / samples;
  for (std::size_t at = 0; at < plane; at += kItem)
    for (std::size_t s = 0; s < samples; ++s) {
      const auto item = planes.begin() + static_cast<std::ptrdiff_t>(s * plane + at);
      out.insert(out.end(), item, item + kItem);
    }
  return out;
}

Bytes bytes_of(const std::vector<std::uint32_t>& numbers) {
  Bytes out;
  out.reserve(kItem * numbers.size());
  for (const std::uint32_t number : numbers)
    for (unsigned shift = 0; shift < 32; shift += 8)
      out.push_back(static_cast<std::uint8_t>(number >> shift));
  return out;
}

struct Part {
  const char* name;
  Bytes bytes;  // empty: not reported
};

std::vector<Part> parts_of(const SampleImage& image) {
  const auto samples = static_cast<std::size_t>(std::max(1, image.samples));
  return {{"pixels", by_pixel(image.pixels->bytes(), samples)},
          {"hits", by_pixel(bytes_of(image.hits->words()), samples)},
          {"coverage", bytes_of(image.coverage->words())}};
}

nlohmann::ordered_json head_of(const SampleImage& image) {
  nlohmann::ordered_json json = {{"count", image.samples}};
  for (const Point& at : image.positions)
    for (const Fixed value : {at.x, at.y}) json["positions"].push_back(value.to_double());
  return json;
}

}  // namespace

nlohmann::ordered_json sample_data(const SampleImage& image) {
  nlohmann::ordered_json json = head_of(image);
  for (const Part& part : parts_of(image))
    if (!part.bytes.empty()) json[part.name] = to_base64(pack_pixels(part.bytes));
  return json;
}

nlohmann::ordered_json sample_difference(const SampleImage& image, const SampleImage& from) {
  nlohmann::ordered_json json = head_of(image);
  const std::vector<Part> own = parts_of(image);
  const std::vector<Part> others = parts_of(from);
  for (std::size_t i = 0; i < own.size(); ++i)
    if (!own[i].bytes.empty() && own[i].bytes.size() == others[i].bytes.size())
      json[own[i].name] = to_base64(pack_pixels(difference_of(own[i].bytes, others[i].bytes)));
  return json;
}

}  // namespace edgecase
