// SPDX-License-Identifier: MIT
//
// PackedWords: many words of 32 bits, such as the pixels of a picture. Runs of equal neighbours are
// kept as their length and one word, where that is less than all words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgecase {

class PackedWords {
 public:
  PackedWords() = default;
  PackedWords(const std::vector<std::uint32_t>& words);  // NOLINT: words are such
  // Four bytes for each word: RGBA8 pixels. A multiple of four, or std::invalid_argument.
  PackedWords(const std::vector<std::uint8_t>& bytes);  // NOLINT: as above

  std::vector<std::uint32_t> words() const;
  std::vector<std::uint8_t> bytes() const;
  std::size_t size() const { return size_; }  // in words
  bool empty() const { return size_ == 0; }
  // What it takes in memory, in words.
  std::size_t kept() const { return kept_.size(); }

  // One list of words is packed in one way.
  friend bool operator==(const PackedWords&, const PackedWords&) = default;

 private:
  void pack(const std::uint32_t* words, std::size_t size);
  void unpack(std::uint32_t* words) const;

  std::size_t size_ = 0;
  // As many as `size_`: the words. Fewer: the length of a run and its word, by turns.
  std::vector<std::uint32_t> kept_;
};

}  // namespace edgecase
