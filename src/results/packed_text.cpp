// SPDX-License-Identifier: MIT
#include "results/packed_text.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <istream>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "model/sampling.h"
#include "model/scene.h"

namespace edgecase {
namespace {

using Place = ValueAggregate::Place;

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

void read_word_runs(std::string_view text, std::size_t size,
                    const std::function<void(std::uint32_t, std::size_t)>& take) {
  std::size_t read = 0;
  for (Scanner scanner(text); !scanner.is_at_end(); scanner.separate()) {
    const auto word = scanner.number(16, std::numeric_limits<std::uint32_t>::max());
    const std::size_t left = read < size ? size - read : 0;
    const std::size_t count = scanner.times('*', left);
    if (count <= left) take(word, count);
    read += count;  // those that are too many are only counted
  }
  if (read != size)
    throw std::runtime_error(fmt::format("{} words stand where {} should", read, size));
}

std::vector<std::uint32_t> to_words(std::string_view text, std::size_t size) {
  std::vector<std::uint32_t> words;
  read_word_runs(text, size, [&](std::uint32_t word, std::size_t count) {
    words.insert(words.end(), count, word);
  });
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

std::string packed_places(std::vector<Place> places) {
  std::string text;
  // Most are in order already.
  if (!std::ranges::is_sorted(places, reads_before))
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

namespace {

// Calls `take` with the first place of each run, its length, and how often each place is named.
template <class Take>
void read_place_runs(std::string_view text, Take take) {
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
    if (row < 0 || next + count > kMaxTargetSize) scanner.refuse();
    take(Place{next, row, -1}, count, times);
    next += count;
  }
}

}  // namespace

std::vector<Place> to_places(std::string_view text, std::size_t most) {
  // Counted before there is memory for them.
  std::size_t size = 0;
  read_place_runs(text, [&](Place, int count, std::size_t times) {
    size += times * static_cast<std::size_t>(count);
    if (size > most)
      throw std::runtime_error(fmt::format("values differ at more than {} places", most));
  });
  std::vector<Place> places;
  places.reserve(size);
  read_place_runs(text, [&](Place place, int count, std::size_t times) {
    for (; count > 0; --count, ++place.x) places.insert(places.end(), times, place);
  });
  return places;
}

std::string packed_runs(const std::vector<PixelRun>& runs) {
  std::string text;
  int row = -1;
  int next = 0;
  for (const PixelRun& run : runs) {
    if (!text.empty()) text += ' ';
    if (run.y != row || run.begin < next) {
      append_number(row = run.y, 10, text += 'y');
      text += ' ';
      next = 0;
    }
    append_number(run.begin - next, 10, text);
    if (run.end > run.begin + 1) append_number(run.end - run.begin, 10, text += '+');
    next = run.end;
  }
  return text;
}

std::vector<PixelRun> to_runs(std::string_view text, int width, int height) {
  std::vector<PixelRun> runs;
  int row = -1;
  int next = 0;
  for (Scanner scanner(text); !scanner.is_at_end(); scanner.separate()) {
    if (scanner.take('y')) {
      row = scanner.number<int>(10, kMaxTargetSize - 1);
      next = 0;
      continue;
    }
    next += scanner.number<int>(10, kMaxTargetSize);
    const int end = next + scanner.times('+', kMaxTargetSize);
    if (row < 0 || row >= height || end > width) scanner.refuse();
    runs.push_back({row, next, end});
    next = end;
  }
  return runs;
}

namespace {

// A higher level makes results little smaller and takes much longer.
constexpr int kLevel = 9;
constexpr std::size_t kPiece = std::size_t{1} << 16;  // bytes that are read at once
constexpr std::string_view kMagic = "\x28\xb5\x2f\xfd";

std::size_t checked(std::size_t result, const char* what) {
  if (ZSTD_isError(result) != 0)
    throw std::runtime_error(fmt::format("{}: {}", what, ZSTD_getErrorName(result)));
  return result;
}

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

template <class Context>
std::unique_ptr<Context, FreeContext> made(Context* context) {
  if (context == nullptr) throw std::runtime_error("there is no memory to pack or unpack results");
  return std::unique_ptr<Context, FreeContext>(context);
}

}  // namespace

struct TextPacker::State {
  std::ostream& out;
  std::unique_ptr<ZSTD_CCtx, FreeContext> context = made(ZSTD_createCCtx());
  std::vector<char> buffer = std::vector<char>(ZSTD_CStreamOutSize());
};

TextPacker::TextPacker(std::ostream& out) : state_(new State{out}) {
  constexpr const char* kWhat = "results cannot be packed";
  ZSTD_CCtx* const context = state_->context.get();
  checked(ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, kLevel), kWhat);
  checked(ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1), kWhat);
}

TextPacker::~TextPacker() = default;

void TextPacker::add(std::string_view text) {
  pack(text, false);
}

void TextPacker::finish() {
  pack("", true);
}

void TextPacker::pack(std::string_view text, bool is_last) {
  ZSTD_inBuffer from{text.data(), text.size(), 0};
  for (std::size_t left = 1; left > 0 || from.pos < from.size;) {
    ZSTD_outBuffer to{state_->buffer.data(), state_->buffer.size(), 0};
    left = checked(ZSTD_compressStream2(state_->context.get(), &to, &from,
                                        is_last ? ZSTD_e_end : ZSTD_e_continue),
                   "results cannot be packed");
    state_->out.write(state_->buffer.data(), static_cast<std::streamsize>(to.pos));
    if (!is_last && from.pos == from.size) return;
  }
}

struct LineReader::State {
  std::istream& in;
  std::unique_ptr<ZSTD_DCtx, FreeContext> context = made(ZSTD_createDCtx());
  std::vector<char> read = std::vector<char>(kPiece);
  std::size_t size = 0;      // of `read`
  std::size_t used = 0;      // of `size`
  std::size_t packed = 0;    // bytes that are unpacked so far
  std::size_t unpacked = 0;  // what they were unpacked to
  bool is_begun = false;
  bool is_packed = false;
  bool is_whole = true;   // the frame is at its end
  bool has_more = false;  // unpacked, than there was room for
  std::string text = {};  // unpacked
  std::size_t at = 0;     // of `text`: where the next line begins
};

LineReader::LineReader(std::istream& in) : state_(new State{in}) {
  // A frame may ask for gigabytes before it has one byte; ours ask for eight megabytes.
  constexpr int kWindow = 25;
  checked(ZSTD_DCtx_setParameter(state_->context.get(), ZSTD_d_windowLogMax, kWindow),
          "results cannot be unpacked");
}

LineReader::~LineReader() = default;

bool LineReader::is_cut() const {
  return !state_->is_whole;
}

// Unpacks some more text; false at the end.
bool LineReader::fill() {
  State& s = *state_;
  s.text.erase(0, s.at);
  s.at = 0;
  const std::size_t before = s.text.size();
  while (s.text.size() == before) {
    if (s.used == s.size && !s.has_more) {
      s.in.read(s.read.data(), static_cast<std::streamsize>(s.read.size()));
      s.size = static_cast<std::size_t>(s.in.gcount());
      s.used = 0;
      if (s.size == 0) return false;
      if (!s.is_begun) s.is_packed = std::string_view(s.read.data(), s.size).starts_with(kMagic);
      s.is_begun = true;
    }
    if (!s.is_packed) {
      s.text.append(s.read.data() + s.used, s.size - s.used);
      s.used = s.size;
      continue;
    }
    std::array<char, kPiece> piece;
    ZSTD_inBuffer from{s.read.data(), s.size, s.used};
    ZSTD_outBuffer to{piece.data(), piece.size(), 0};
    s.is_whole =
        checked(ZSTD_decompressStream(s.context.get(), &to, &from), "the file is damaged") == 0;
    s.packed += from.pos - s.used;
    s.unpacked += to.pos;
    if (s.unpacked > kUnpacked + kLargestRatio * s.packed)
      throw std::runtime_error(
          fmt::format("{} bytes unpack to more than {}, which nobody's results do", s.packed,
                      kUnpacked + kLargestRatio * s.packed));
    s.used = from.pos;
    s.has_more = to.pos == to.size;
    s.text.append(piece.data(), to.pos);
  }
  return true;
}

bool LineReader::next(std::string& line) {
  State& s = *state_;
  std::size_t end = s.text.find('\n', s.at);
  while (end == std::string::npos) {
    const std::size_t pending = s.text.size() - s.at;
    if (pending > kLongestLine)
      throw std::runtime_error(fmt::format("a line is longer than {} bytes", kLongestLine));
    if (!fill()) {
      line.assign(s.text, s.at);
      s.at = s.text.size();
      return !line.empty();
    }
    end = s.text.find('\n', pending);
  }
  line.assign(s.text, s.at, end - s.at);
  s.at = end + 1;
  return true;
}

}  // namespace edgecase
