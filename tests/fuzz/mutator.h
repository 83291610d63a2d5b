// SPDX-License-Identifier: MIT
//
// Spoils files in the ways that readers meet: bytes changed, left out, doubled and exchanged
// between files, numbers made extreme, brackets nested. The same seed gives the same inputs on
// every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace edgecase {

class Mutator {
 public:
  // `files`: at least one, none of them empty.
  Mutator(std::vector<std::string> files, std::uint64_t seed);

  // One of the files, spoilt in 1 to 4 places; at most kMostBytes.
  std::string next();

  static constexpr std::size_t kMostBytes = std::size_t{1} << 16;

 private:
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  const std::string& any_file() { return files_[below(files_.size())]; }
  std::string piece_of(const std::string& text, std::size_t most);
  void spoil(std::string& text);
  void spoil_bytes(std::string& text);
  void change_number(std::string& text);
  void exchange_string(std::string& text);
  void repeat(std::string& text);

  std::vector<std::string> files_;
  std::mt19937_64 random_;
};

}  // namespace edgecase
