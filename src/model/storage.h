// SPDX-License-Identifier: MIT
//
// How what many hold, or much, is kept in little memory: texts, pictures and what samples hold.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/rendering.h"
#include "model/sampling.h"

namespace edgecase {

// Shared: a value that many hold and none changes. Of a sweep's thousands of cases each has its
// file's text, and of a case's renderers nearly each draws what exact draws.
template <class Value>
class Shared {
 public:
  Shared() = default;
  template <std::convertible_to<Value> From>
  Shared(From&& value)  // NOLINT: a value is one
      : value_(std::make_shared<const Value>(std::forward<From>(value))) {}

  const Value& operator*() const {
    static const Value none{};
    return value_ ? *value_ : none;
  }
  const Value* operator->() const { return &**this; }

  // Both are one in memory from here on, if they are equal.
  void share_with(const Shared& other) {
    if (*this == other) value_ = other.value_;
  }

  // Are they one in memory? Quickly told, and false says nothing.
  friend bool is_same_object(const Shared& a, const Shared& b) { return a.value_ == b.value_; }
  friend bool operator==(const Shared& a, const Shared& b) {
    return is_same_object(a, b) || *a == *b;
  }

 private:
  std::shared_ptr<const Value> value_;
};

using SharedText = Shared<std::string>;

// PackedWords: many words of 32 bits, such as the pixels of a picture. Runs of equal neighbours are
// kept as their length and one word, where that is less than all words.
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

// SampleImage: what the samples of a multisampled image hold, for those who show it.

// Whatever was not told is empty.
struct SampleImage {
  int samples = 1;            // of a pixel; 1: not multisampled, and all else is empty
  SamplePositions positions;  // `samples` of them
  // RGBA8 before it is resolved: a plane for each sample, row by row from the bottom.
  Shared<PackedWords> pixels;
  // Fragments that were written to each sample: planes as above.
  Shared<PackedWords> hits;
  // Per pixel: bit s set where some fragment covers sample s (Fragment::coverage).
  Shared<PackedWords> coverage;

  // What both tell alike is one in memory from here on.
  void share_with(const SampleImage& other) {
    pixels.share_with(other.pixels);
    hits.share_with(other.hits);
    coverage.share_with(other.coverage);
  }
  friend bool operator==(const SampleImage&, const SampleImage&) = default;
};

SampleImage sample_image(const Rendering& rendering);

}  // namespace edgecase
