// SPDX-License-Identifier: MIT
#include "results/packed_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "model/sampling.h"
#include "model/scene.h"

namespace edgecase {
namespace {

using Place = ValueAggregate::Place;

// Of the largest target, each pixel four times.
constexpr std::size_t kMostPlaces = std::size_t{1} << 26;

template <class Integer>
void append_number(Integer value, int base, std::string& text) {
  char digits[24];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value, base).ptr);
}

// Reads tokens one after the other.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

  bool is_at_end() const { return at_ == end_; }
  bool take(char sign) {
    const bool is_there = at_ != end_ && *at_ == sign;
    if (is_there) ++at_;
    return is_there;
  }
  // What stands between two tokens, and not at the end.
  void separate() {
    if (!is_at_end() && (!take(' ') || is_at_end())) refuse();
  }
  template <class Integer>
  Integer number(int base, Integer most) {
    Integer value{};
    const auto read = std::from_chars(at_, end_, value, base);
    if (read.ec != std::errc{} || *at_ == '-' || value > most) refuse();
    at_ = read.ptr;
    return value;
  }
  // How often, behind a sign; at least once.
  template <class Integer>
  Integer times(char sign, Integer most) {
    if (!take(sign)) return 1;
    const Integer count = number<Integer>(10, most);
    if (count == 0) refuse();
    return count;
  }
  [[noreturn]] void refuse() const {
    const auto left = static_cast<std::size_t>(end_ - at_);
    throw std::runtime_error(fmt::format("\"{}\" is no packed text of this place",
                                         std::string_view(at_, std::min<std::size_t>(left, 20))));
  }

 private:
  const char* at_;
  const char* end_;
};

// What the neighbours of the byte at `at` say of it; a row has `row` bytes.
std::uint8_t foretold(const std::vector<std::uint8_t>& pixels, std::size_t at, std::size_t row) {
  const bool has_left = at % row >= 4;
  const bool has_below = at >= row;
  int value = 0;
  if (has_left) value += pixels[at - 4];
  if (has_below) value += pixels[at - row];
  if (has_left && has_below) value -= pixels[at - row - 4];
  return static_cast<std::uint8_t>(value);
}

bool reads_before(const Place& a, const Place& b) {
  return std::tie(a.y, a.x) < std::tie(b.y, b.x);
}

bool is_same_pixel(const Place& a, const Place& b) {
  return a.x == b.x && a.y == b.y;
}

// Behind the places of the pixel at `at`.
std::size_t end_of_pixel(const std::vector<Place>& places, std::size_t at) {
  std::size_t end = at + 1;
  while (end < places.size() && is_same_pixel(places[at], places[end])) ++end;
  return end;
}

}  // namespace

std::string packed_words(const std::vector<std::uint32_t>& words) {
  std::string text;
  for (std::size_t at = 0; at < words.size();) {
    const auto same = [&](std::uint32_t word) { return word == words[at]; };
    const auto first = words.begin() + static_cast<std::ptrdiff_t>(at);
    const auto count = static_cast<std::size_t>(std::find_if_not(first, words.end(), same) - first);
    if (at > 0) text += ' ';
    append_number(words[at], 16, text);
    if (count > 1) append_number(count, 10, text += '*');
    at += count;
  }
  return text;
}

std::vector<std::uint32_t> to_words(std::string_view text, std::size_t size) {
  std::vector<std::uint32_t> words;
  for (Scanner scanner(text); !scanner.is_at_end(); scanner.separate()) {
    const auto word = scanner.number(16, std::numeric_limits<std::uint32_t>::max());
    words.insert(words.end(), scanner.times('*', size - words.size()), word);
  }
  if (words.size() != size)
    throw std::runtime_error(fmt::format("{} words stand where {} should", words.size(), size));
  return words;
}

std::vector<std::uint32_t> words_of(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint32_t> words(bytes.size() / 4);
  for (std::size_t i = 0; i < words.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) words[i] = words[i] << 8 | bytes[4 * i + k];
  return words;
}

std::vector<std::uint8_t> bytes_of(const std::vector<std::uint32_t>& words) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(4 * words.size());
  for (const std::uint32_t word : words)
    for (const int shift : {24, 16, 8, 0})
      bytes.push_back(static_cast<std::uint8_t>(word >> shift));
  return bytes;
}

std::string packed_picture(const std::vector<std::uint8_t>& pixels, int width) {
  const auto row = 4 * static_cast<std::size_t>(std::max(width, 1));
  std::vector<std::uint8_t> left(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    left[i] = static_cast<std::uint8_t>(pixels[i] - foretold(pixels, i, row));
  return packed_words(words_of(left));
}

std::vector<std::uint8_t> to_picture(std::string_view text, int width, int height) {
  if (width < 0 || height < 0 || width > kMaxTargetSize || height > kMaxTargetSize * kMaxSamples)
    throw std::runtime_error(fmt::format("no picture has {} by {} pixels", width, height));
  const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<std::uint8_t> pixels = bytes_of(to_words(text, size));
  const auto row = 4 * static_cast<std::size_t>(width);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = static_cast<std::uint8_t>(pixels[i] + foretold(pixels, i, row));
  return pixels;
}

std::string packed_places(std::vector<Place> places) {
  std::string text;
  std::stable_sort(places.begin(), places.end(), reads_before);
  int row = -1;
  int next = 0;
  for (std::size_t at = 0; at < places.size();) {
    const Place first = places[at];
    const std::size_t times = end_of_pixel(places, at) - at;
    int count = 0;
    while (at < places.size() && is_same_pixel(places[at], {first.x + count, first.y}) &&
           end_of_pixel(places, at) - at == times) {
      at += times;
      ++count;
    }
    if (!text.empty()) text += ' ';
    if (first.y != row) {
      append_number(row = first.y, 10, text += 'y');
      text += ' ';
      next = 0;
    }
    append_number(first.x - next, 10, text);
    if (count > 1) append_number(count, 10, text += '+');
    if (times > 1) append_number(times, 10, text += '*');
    next = first.x + count;
  }
  return text;
}

std::vector<Place> to_places(std::string_view text) {
  std::vector<Place> places;
  int row = -1;
  int next = 0;
  for (Scanner scanner(text); !scanner.is_at_end(); scanner.separate()) {
    if (scanner.take('y')) {
      const int begun = scanner.number<int>(10, kMaxTargetSize - 1);
      if (begun <= row) scanner.refuse();
      row = begun;
      next = 0;
      continue;
    }
    next += scanner.number<int>(10, kMaxTargetSize);
    const int count = scanner.times('+', kMaxTargetSize);
    const auto times = scanner.times('*', kMostPlaces);
    if (row < 0 || next + count > kMaxTargetSize ||
        times * static_cast<std::size_t>(count) > kMostPlaces - places.size())
      scanner.refuse();
    for (const int end = next + count; next < end; ++next)
      places.insert(places.end(), times, {next, row, -1});
  }
  places.shrink_to_fit();  // they are kept
  return places;
}

}  // namespace edgecase
