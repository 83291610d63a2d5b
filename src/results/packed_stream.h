// SPDX-License-Identifier: MIT
//
// The bytes of a results file: lines of text in one frame of Zstandard (RFC 8878), with a checksum
// at its end. `zstdcat` shows them.
//
// A window of megabytes is what makes results small: cases of a sweep stand close to each other and
// are nearly alike, and so are the answers of two renderers to one case. One level and one thread,
// so that the same lines give the same bytes.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

namespace edgecase {

// Packs text into a stream, piece by piece.
class TextPacker {
 public:
  // `out` must live as long; the caller checks its state afterwards. Throws std::runtime_error
  // where there is no memory.
  explicit TextPacker(std::ostream& out);
  ~TextPacker();

  void add(std::string_view text);
  // To be called once, behind the last piece.
  void finish();

 private:
  void pack(std::string_view text, bool is_last);

  struct State;
  std::unique_ptr<State> state_;
};

// Reads lines, packed or not, one after the other.
class LineReader {
 public:
  // `in` must live as long.
  explicit LineReader(std::istream& in);
  ~LineReader();

  // The next line, without its end; false behind the last one. What follows the last line break, if
  // anything, counts as a line. Throws std::runtime_error for bytes that are damaged, and for a
  // line longer than `kLongestLine`.
  bool next(std::string& line);

  // Behind the last line: did the packed bytes end before their end? Lines that are plain cannot
  // tell.
  bool is_cut() const;

  // The longest line of ours is a small part of it. A file of some megabytes could otherwise ask
  // for all memory.
  static constexpr std::size_t kLongestLine = std::size_t{1} << 28;

 private:
  bool fill();

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace edgecase
