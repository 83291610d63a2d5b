// SPDX-License-Identifier: MIT
#include "base/packed_words.h"

#include <algorithm>
#include <stdexcept>

namespace edgecase {

PackedWords::PackedWords(const std::vector<std::uint32_t>& words) {
  pack(words.data(), words.size());
}

PackedWords::PackedWords(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() % sizeof(std::uint32_t) != 0)
    throw std::invalid_argument("bytes that are no words");
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<std::uint8_t*>(words.data()));
  pack(words.data(), words.size());
}

std::vector<std::uint32_t> PackedWords::words() const {
  std::vector<std::uint32_t> words(size_);
  unpack(words.data());
  return words;
}

std::vector<std::uint8_t> PackedWords::bytes() const {
  const std::vector<std::uint32_t> unpacked = words();
  const auto* const first = reinterpret_cast<const std::uint8_t*>(unpacked.data());
  return {first, first + unpacked.size() * sizeof(std::uint32_t)};
}

void PackedWords::pack(const std::uint32_t* words, std::size_t size) {
  size_ = size;
  std::vector<std::uint32_t> runs;
  for (std::size_t at = 0; at < size && runs.size() + 2 < size;) {
    std::size_t end = at + 1;
    while (end < size && words[end] == words[at]) ++end;
    runs.push_back(static_cast<std::uint32_t>(end - at));
    runs.push_back(words[at]);
    at = end;
    if (at == size) {
      kept_.assign(runs.begin(), runs.end());
      return;
    }
  }
  kept_.assign(words, words + size);
}

void PackedWords::unpack(std::uint32_t* words) const {
  if (kept_.size() == size_) {
    std::copy(kept_.begin(), kept_.end(), words);
    return;
  }
  for (std::size_t i = 0; i < kept_.size(); i += 2)
    words = std::fill_n(words, kept_[i], kept_[i + 1]);
}

void WordPacker::add(std::uint32_t word, std::size_t count) {
  if (count == 0) return;
  std::vector<std::uint32_t>& kept = packed_.kept_;
  if (has_runs_ && !kept.empty() && kept.back() == word) {
    kept[kept.size() - 2] += static_cast<std::uint32_t>(count);
    return;
  }
  if (has_runs_ && kept.size() + 2 < packed_.size_) {
    kept.push_back(static_cast<std::uint32_t>(count));
    kept.push_back(word);
    return;
  }
  if (has_runs_) {  // which are no shorter than the words
    std::vector<std::uint32_t> words;
    words.reserve(packed_.size_);
    for (std::size_t i = 0; i < kept.size(); i += 2)
      words.insert(words.end(), kept[i], kept[i + 1]);
    kept = std::move(words);
    has_runs_ = false;
  }
  kept.insert(kept.end(), count, word);
}

void WordRuns::read() {
  const std::vector<std::uint32_t>& kept = words_.kept_;
  if (at_ == kept.size()) return;
  const bool has_runs = kept.size() != words_.size_;
  left_ = has_runs ? kept[at_++] : 1;
  word_ = kept[at_++];
}

}  // namespace edgecase
