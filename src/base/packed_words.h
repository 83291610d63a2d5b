// SPDX-License-Identifier: MIT
//
// PackedWords: a list of 32-bit words, such as the pixels of a picture. Runs of equal neighbours
// are stored as length and word if that is shorter than all words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace edgecase {

class PackedWords {
 public:
  PackedWords() = default;
  PackedWords(const std::vector<std::uint32_t>& words);  // NOLINT: words are such
  // Four bytes for each word, as RGBA8. Throws std::invalid_argument if a word is incomplete.
  PackedWords(const std::vector<std::uint8_t>& bytes);  // NOLINT: as above

  std::vector<std::uint32_t> words() const;
  std::vector<std::uint8_t> bytes() const;
  std::size_t size() const { return size_; }  // in words
  bool empty() const { return size_ == 0; }
  // The size in memory, in words.
  std::size_t kept() const { return kept_.size(); }

  // Reads or writes it as it is kept (wire/binary.h).
  template <class Io>
  friend void carry(Io& io, PackedWords& words) {
    carry_all(io, words.size_, words.kept_);
  }
  template <class Io>
  friend void carry(Io& io, const PackedWords& words) {
    carry_all(io, words.size_, words.kept_);
  }

  // Equal lists are packed in the same way.
  friend bool operator==(const PackedWords&, const PackedWords&) = default;

 private:
  friend class WordPacker;
  friend class WordRuns;

  void pack(const std::uint32_t* words, std::size_t size);
  void unpack(std::uint32_t* words) const;

  std::size_t size_ = 0;
  // `size_` entries: the words. Fewer: alternately the length of a run and its word.
  std::vector<std::uint32_t> kept_;
};

// Packs words that come run by run, in no more memory than they are kept in.
class WordPacker {
 public:
  // `size`: of the list, in words.
  explicit WordPacker(std::size_t size) { packed_.size_ = size; }
  void add(std::uint32_t word, std::size_t count);
  // Call once, when `size` words were added.
  PackedWords finish() { return std::move(packed_); }

 private:
  PackedWords packed_;
  bool has_runs_ = true;  // otherwise words
};

// Walks through a list run by run. `words` must live as long.
class WordRuns {
 public:
  explicit WordRuns(const PackedWords& words) : words_(words) { read(); }
  std::uint32_t word() const { return word_; }
  // Of the present run; 0: the end.
  std::size_t left() const { return left_; }
  // `count`: at most left().
  void skip(std::size_t count) {
    left_ -= count;
    if (left_ == 0) read();
  }

 private:
  void read();

  const PackedWords& words_;
  std::size_t at_ = 0;
  std::uint32_t word_ = 0;
  std::size_t left_ = 0;
};

}  // namespace edgecase
