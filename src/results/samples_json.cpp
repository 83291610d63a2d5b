// SPDX-License-Identifier: MIT
#include "results/samples_json.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string_view>

#include "model/rendering.h"
#include "model/scene.h"
#include "results/findings_json.h"
#include "results/packed_picture.h"
#include "results/packed_text.h"
#include "results/shallow_json.h"

namespace edgecase {
namespace {

std::size_t area_of(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

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

SampleImage to_head(const ReadJson& json, int width, int height) {
  constexpr std::size_t kMost = std::size_t{1} << 24;  // as a case may have
  SampleImage image;
  image.samples = WholeNumber(json.at("count"));
  if (image.samples <= 1 || image.samples > kMaxSamples)
    throw std::runtime_error(fmt::format("{} is no number of samples", image.samples));
  if (static_cast<std::size_t>(image.samples) * area_of(width, height) > kMost)
    throw std::runtime_error(fmt::format("there is no target of {} by {} pixels with {} samples",
                                         width, height, image.samples));
  for (const ReadJson& at : json.value("positions", ReadJson::array()))
    image.positions.push_back({to_fixed(at.at(0)), to_fixed(at.at(1))});
  check_size("positions", image.positions.size(), static_cast<std::size_t>(image.samples));
  return image;
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
  SampleImage image = to_head(json, width, height);
  const std::size_t area = area_of(width, height);
  if (json.contains("pixels"))
    image.pixels = to_picture(to_text(json.at("pixels")), width, height * image.samples);
  if (json.contains("hits"))
    image.hits =
        to_packed_words(to_text(json.at("hits")), static_cast<std::size_t>(image.samples) * area);
  if (json.contains("coverage"))
    image.coverage = to_packed_words(to_text(json.at("coverage")), area);
  return image;
}

SampleImage to_samples(const ReadJson& json, int width, int height, const SampleImage& exact) {
  SampleImage image = to_head(json, width, height);
  const std::size_t area = area_of(width, height);
  const auto samples = static_cast<std::size_t>(image.samples);
  const auto read = [&](const char* member, std::size_t size, const PackedWords& other,
                        WordsAre kind) {
    return json.contains(member) ? to_difference(to_text(json.at(member)), size, other, kind)
                                 : PackedWords();
  };
  image.pixels = read("pixels", samples * area, *exact.pixels, WordsAre::pixels);
  image.hits = read("hits", samples * area, *exact.hits, WordsAre::numbers);
  image.coverage = read("coverage", area, *exact.coverage, WordsAre::numbers);
  image.share_with(exact);
  return image;
}

namespace {

using Reported = Result::ReportedFragment;

// The number with the fewest digits that identify a float.
double shortest(float value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  double read = 0;
  std::from_chars(digits, end, read);
  return read;
}

bool is_finite_float(double value) {
  return std::isfinite(value) && std::abs(value) < 3e38;
}

void write_value(JsonWriter& json, double value) {
  if (!is_finite_float(value)) return json.value(value);
  const auto narrow = static_cast<float>(value);
  if (bit_pattern(narrow) == bit_pattern(value)) return json.value(shortest(narrow));
  if (shortest(narrow) != value) return json.value(value);
  json.value(fmt::format("{}", value));
}

double to_value(const ReadJson& json) {
  if (json.is_number()) {
    const double value = json.get<double>();
    const bool is_float = is_finite_float(value) && shortest(static_cast<float>(value)) == value;
    return is_float ? static_cast<float>(value) : value;
  }
  const std::string_view text = to_text(json);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  const bool is_finite = read.ec == std::errc{} && read.ptr == end && std::isfinite(value);
  return is_finite ? value : to_number(json);
}

bool are_alike(const Reported& a, const Reported& b) {
  const Fragment& f = a.fragment;
  const Fragment& g = b.fragment;
  return a.pass == b.pass && f.y == g.y && f.primitive == g.primitive && f.coverage == g.coverage &&
         f.has_depth == g.has_depth && f.has_color == g.has_color && have_equal_values(f, g);
}

// The number of equal neighbours in a row, from the first one on.
std::size_t length_of_run(std::span<const Reported> fragments) {
  std::size_t count = 1;
  while (count < fragments.size() && count < kMaxTargetSize &&
         are_alike(fragments[0], fragments[count]) &&
         fragments[count].fragment.x == fragments[0].fragment.x + static_cast<int>(count))
    ++count;
  return count;
}

void write_run(JsonWriter& json, const Reported& reported, std::size_t count) {
  const Fragment& f = reported.fragment;
  json.list([&] {
    count > 1 ? json.array(f.x, count) : json.value(f.x);
    json.value(f.y);
    json.value(f.primitive);
    json.value(f.coverage);
    f.has_depth ? write_value(json, f.depth) : json.value(nullptr);
    f.has_color ? json.list(f.color, write_value) : json.value(nullptr);
    if (reported.pass >= 0) json.value(reported.pass);
  });
}

Reported to_reported(const ReadJson& json) {
  Reported reported;
  Fragment& f = reported.fragment;
  f.x = WholeNumber(json.at(0).is_array() ? json.at(0).at(0) : json.at(0));
  f.y = WholeNumber(json.at(1));
  f.primitive = WholeNumber(json.at(2));
  f.coverage = WholeNumber(json.at(3));
  f.has_depth = !json.at(4).is_null();
  f.has_color = !json.at(5).is_null();
  if (f.has_depth) f.depth = to_value(json.at(4));
  for (std::size_t i = 0; f.has_color && i < f.color.size(); ++i)
    f.color[i] = to_value(json.at(5).at(i));
  if (json.size() > 6) reported.pass = WholeNumber(json.at(6));
  return reported;
}

int count_of(const ReadJson& json) {
  if (!json.at(0).is_array()) return 1;
  const int count = WholeNumber(json.at(0).at(1));
  if (count < 1 || count > kMaxTargetSize)
    throw std::runtime_error(fmt::format("no row has {} fragments that are alike", count));
  return count;
}

}  // namespace

void write_fragments(JsonWriter& json, const std::vector<Reported>& fragments) {
  json.list([&] {
    for (std::span<const Reported> rest = fragments; !rest.empty();) {
      const std::size_t count = length_of_run(rest);
      write_run(json, rest[0], count);
      rest = rest.subspan(count);
    }
  });
}

std::vector<Reported> to_fragments(const ReadJson& json, std::size_t most) {
  if (!json.is_array()) throw std::runtime_error("a list is missing");
  std::vector<Reported> fragments;
  for (const ReadJson& item : json) {
    Reported reported = to_reported(item);
    for (int left = count_of(item); left > 0; --left) {
      if (fragments.size() == most || reported.fragment.x > kMaxTargetSize)
        throw std::runtime_error("there are more fragments than are kept of a case");
      fragments.push_back(reported);
      ++reported.fragment.x;
    }
  }
  fragments.shrink_to_fit();  // they are kept
  return fragments;
}

}  // namespace edgecase
