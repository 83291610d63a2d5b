// SPDX-License-Identifier: MIT
//
// Packed text: how a results file keeps pictures, numbers per pixel and places.
//
// Words are 32 bits each, in hexadecimal digits without leading zeros, with a space between them. A
// word that stands N times in a row is "WORD*N". The word of a pixel is RRGGBBAA.
//
// Pictures are words, too: results/packed_picture.h.
//
// Places are pixels, each as often as something is found there, in the order in which they are
// read: by row from the bottom, then by column. "yN" begins row N. "S+N*T" skips S pixels of the
// row, from the last one named or the row's begin; then N neighbours are named, each T times. "+1"
// and "*1" are left out.
//
// Runs of pixels are the same, without "*T", by row and column; a run that begins before the end of
// the one before follows a further "yN".
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "model/verdict.h"

namespace edgecase {

// The samples of the largest target. They take 200 MB in memory, and their text may be very short.
constexpr std::size_t kMostPlaces = std::size_t{1} << 24;

std::string packed_words(const std::vector<std::uint32_t>& words);
// The inverse, for `size` words. Throws std::runtime_error for anything else.
std::vector<std::uint32_t> to_words(std::string_view text, std::size_t size);

// The same without their memory: calls `take` with each word and how often it stands in a row.
void read_word_runs(std::string_view text, std::size_t size,
                    const std::function<void(std::uint32_t word, std::size_t count)>& take);

// Bytes as words, four at a time, and the inverse.
std::vector<std::uint32_t> words_of(const std::vector<std::uint8_t>& bytes);
std::vector<std::uint8_t> bytes_of(const std::vector<std::uint32_t>& words);

// Primitives of places are not stored: they read back as -1.
std::string packed_places(std::vector<ValueAggregate::Place> places);
// The inverse, of at most `most` places. Throws std::runtime_error for anything else, and for
// places beyond the largest target.
std::vector<ValueAggregate::Place> to_places(std::string_view text, std::size_t most = kMostPlaces);

// `runs` in their order.
std::string packed_runs(const std::vector<PixelRun>& runs);
// The inverse, within a target of `width` by `height` pixels. Throws std::runtime_error for
// anything else.
std::vector<PixelRun> to_runs(std::string_view text, int width, int height);

// The bytes of a results file: lines of text in one frame of Zstandard (RFC 8878), with a checksum
// at its end. `zstdcat` shows them.
//
// A window of megabytes makes results small: neighbouring cases of a sweep are nearly alike, and so
// are the answers of two renderers to one case. With a fixed level and one thread, the same lines
// give the same bytes.

// Packs text into a stream, piece by piece.
class TextPacker {
 public:
  // `out` must live as long; the caller checks its state afterwards. Throws std::runtime_error
  // where there is no memory.
  explicit TextPacker(std::ostream& out);
  ~TextPacker();

  void add(std::string_view text);
  // Call once, after the last piece.
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
  // anything, counts as a line. Throws std::runtime_error for bytes that are damaged, for a line
  // longer than kLongestLine, and where the packed bytes so far unpack to more than kUnpacked and
  // kLargestRatio times as many.
  bool next(std::string& line);

  // After the last line: true if the packed bytes were cut off. Always false for plain lines.
  bool is_cut() const;

  // Much longer than any line of ours. Without a limit a file of some megabytes could take all
  // memory.
  static constexpr std::size_t kLongestLine = std::size_t{1} << 28;

  // The results of the suite are packed to a twentieth. A line takes up to forty times its bytes
  // while it is read.
  static constexpr std::size_t kUnpacked = std::size_t{1} << 22;
  static constexpr std::size_t kLargestRatio = 250;

 private:
  bool fill();

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace edgecase
