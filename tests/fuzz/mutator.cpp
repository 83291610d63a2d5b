// SPDX-License-Identifier: MIT
#include "tests/fuzz/mutator.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace edgecase {
namespace {

constexpr const char* kNumbers[] = {"0",
                                    "-0.0",
                                    "-1",
                                    "1e308",
                                    "1e9999",
                                    "-1e-46",
                                    "0.1",
                                    "\"~0.1\"",
                                    "\"1/3\"",
                                    "3.4e38",
                                    "8192",
                                    "16384",
                                    "65536",
                                    "4294967296",
                                    "1e20",
                                    "1e-7",
                                    "null",
                                    "true",
                                    "[]",
                                    "{}",
                                    "\"\"",
                                    "\"\\u0000\"",
                                    "9223372036854775808"};
constexpr const char* kOpenings[] = {"[", "{\"a\":", "[[", "{", "\"", "\xEF\xBB\xBF", "\xC3"};
constexpr const char* kDigits = "0123456789";

}  // namespace

Mutator::Mutator(std::vector<std::string> files, std::uint64_t seed)
    : files_(std::move(files)), random_(seed) {}

std::string Mutator::next() {
  std::string text = any_file().substr(0, kMostBytes);
  const std::size_t places = 1 + below(4);
  for (std::size_t i = 0; i < places; ++i) spoil(text);
  if (text.size() > kMostBytes) text.resize(kMostBytes);
  return text;
}

// 1 to `most` bytes of a text that is not empty.
std::string Mutator::piece_of(const std::string& text, std::size_t most) {
  return text.substr(below(text.size()), 1 + below(most));
}

void Mutator::spoil(std::string& text) {
  if (text.empty()) {
    text = piece_of(any_file(), 100);
    return;
  }
  switch (below(10)) {
    case 0:
      text.erase(below(text.size()), 1 + below(40));
      break;
    case 1:
    case 2:
      spoil_bytes(text);
      break;
    case 3:
      text.insert(below(text.size()), piece_of(text, 60));
      break;
    case 4:
      text.insert(below(text.size()), piece_of(any_file(), 200));
      break;
    case 5:
      repeat(text);
      break;
    case 6:
    case 7:
      exchange_string(text);
      break;
    default:
      change_number(text);
  }
}

// A bit of a byte, a whole byte, or 1 to 8 bytes that are all the same.
void Mutator::spoil_bytes(std::string& text) {
  const std::size_t at = below(text.size());
  const std::size_t way = below(3);
  if (way == 0) {
    text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
  } else if (way == 1) {
    text[at] = static_cast<char>(below(256));
  } else {
    const std::size_t count = std::min(text.size() - at, 1 + below(8));
    text.replace(at, count, count, below(2) == 0 ? '\0' : '\xFF');
  }
}

// The next number from some place on becomes another one, of this file or extreme.
void Mutator::change_number(std::string& text) {
  const std::size_t at = text.find_first_of(kDigits, below(text.size()));
  if (at == std::string::npos) return;
  const std::size_t end = std::min(text.find_first_not_of("0123456789.e+-", at), text.size());
  text.replace(at, end - at, kNumbers[below(std::size(kNumbers))]);
}

// A word in quotes becomes one of some file: keys and names meet where they do not belong.
void Mutator::exchange_string(std::string& text) {
  const auto word_from = [](const std::string& from, std::size_t start) {
    const std::size_t open = from.find('"', start);
    if (open == std::string::npos) return std::pair{std::string::npos, std::string::npos};
    return std::pair{open, from.find('"', open + 1)};
  };
  const std::string& other = any_file();
  const auto [from, to] = word_from(text, below(text.size()));
  const auto [begin, end] = word_from(other, below(other.size()));
  if (to == std::string::npos || end == std::string::npos) return;
  const std::string word = other.substr(begin, end + 1 - begin);
  text.replace(from, to + 1 - from, word);
}

// Up to 300 times an opening bracket, or a piece of the text itself.
void Mutator::repeat(std::string& text) {
  const std::string piece =
      below(2) == 0 ? kOpenings[below(std::size(kOpenings))] : piece_of(text, 30);
  const std::size_t count = 1 + below(300);
  std::string many;
  for (std::size_t i = 0; i < count; ++i) many += piece;
  text.insert(below(text.size()), many);
}

}  // namespace edgecase
