// SPDX-License-Identifier: MIT
#include "results/packed_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "model/sampling.h"
#include "model/scene.h"
#include "results/packed_text.h"

namespace edgecase {
namespace {

// The prediction of the byte at `at` from its neighbours; a row has `row` bytes.
std::uint8_t foretold(const std::vector<std::uint8_t>& pixels, std::size_t at, std::size_t row) {
  const bool has_left = at % row >= 4;
  const bool has_below = at >= row;
  int value = 0;
  if (has_left) value += pixels[at - 4];
  if (has_below) value += pixels[at - row];
  if (has_left && has_below) value -= pixels[at - row - 4];
  return static_cast<std::uint8_t>(value);
}

// The number RRGGBBAA as a word that has these bytes in memory.
std::uint32_t in_memory(std::uint32_t word) {
  static_assert(std::endian::native == std::endian::little);
  return word << 24 | (word & 0xff00U) << 8 | (word >> 8 & 0xff00U) | word >> 24;
}

// Of each of the four bytes, modulo 256: the highest bits are added apart, so that none carries.
constexpr std::uint32_t kHighest = 0x80808080U;
std::uint32_t sum_of_bytes(std::uint32_t a, std::uint32_t b) {
  return ((a & ~kHighest) + (b & ~kHighest)) ^ ((a ^ b) & kHighest);
}
std::uint32_t difference_of_bytes(std::uint32_t a, std::uint32_t b) {
  return ((a | kHighest) - (b & ~kHighest)) ^ ((a ^ ~b) & kHighest);
}

// Adds neighbours to differences, pixel by pixel; holds one row.
class PictureReader {
 public:
  PictureReader(std::size_t width, std::size_t height) : row_(width), packer_(width * height) {}

  void add(std::uint32_t difference) {
    const std::uint32_t below = row_[x_];
    const std::uint32_t foretold = difference_of_bytes(sum_of_bytes(left_, below), below_left_);
    left_ = row_[x_] = sum_of_bytes(difference, foretold);
    below_left_ = below;
    packer_.add(left_, 1);
    if (++x_ < row_.size()) return;
    x_ = 0;
    left_ = below_left_ = 0;
  }
  PackedWords finish() { return packer_.finish(); }

 private:
  std::vector<std::uint32_t> row_;  // from x_ on that below, before it the present one
  std::size_t x_ = 0;
  std::uint32_t left_ = 0;
  std::uint32_t below_left_ = 0;
  WordPacker packer_;
};

}  // namespace

std::string packed_picture(const std::vector<std::uint8_t>& pixels, int width) {
  const auto row = 4 * static_cast<std::size_t>(std::max(width, 1));
  std::vector<std::uint8_t> left(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    left[i] = static_cast<std::uint8_t>(pixels[i] - foretold(pixels, i, row));
  return packed_words(words_of(left));
}

PackedWords to_picture(std::string_view text, int width, int height) {
  if (width < 0 || height < 0 || width > kMaxTargetSize || height > kMaxTargetSize * kMaxSamples)
    throw std::runtime_error(fmt::format("no picture has {} by {} pixels", width, height));
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  PictureReader reader(columns, rows);
  read_word_runs(text, columns * rows, [&](std::uint32_t word, std::size_t count) {
    const std::uint32_t difference = in_memory(word);
    for (; count > 0; --count) reader.add(difference);
  });
  return reader.finish();
}

PackedWords to_packed_words(std::string_view text, std::size_t size) {
  WordPacker packer(size);
  read_word_runs(text, size,
                 [&](std::uint32_t word, std::size_t count) { packer.add(word, count); });
  return packer.finish();
}

PackedWords to_difference(std::string_view text, std::size_t size, const PackedWords& others,
                          WordsAre kind) {
  WordPacker packer(size);
  WordRuns other(others);
  const bool has_others = others.size() == size;
  read_word_runs(text, size, [&](std::uint32_t word, std::size_t count) {
    const std::uint32_t own = kind == WordsAre::pixels ? in_memory(word) : word;
    if (!has_others) return packer.add(own, count);
    while (count > 0) {
      const std::size_t alike = std::min(count, other.left());
      packer.add(own ^ other.word(), alike);
      other.skip(alike);
      count -= alike;
    }
  });
  return packer.finish();
}

}  // namespace edgecase
