// SPDX-License-Identifier: MIT
#include "results/packed_stream.h"

#include <fmt/format.h>
#include <zstd.h>

#include <array>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <vector>

namespace edgecase {
namespace {

// More shrinks results little and takes much longer.
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
  std::size_t size = 0;  // of `read`
  std::size_t used = 0;  // of `size`
  bool is_begun = false;
  bool is_packed = false;
  bool is_whole = true;   // the frame is at its end
  bool has_more = false;  // unpacked, than there was room for
  std::string text = {};  // unpacked
  std::size_t at = 0;     // of `text`: where the next line begins
};

LineReader::LineReader(std::istream& in) : state_(new State{in}) {}

LineReader::~LineReader() = default;

bool LineReader::is_cut() const {
  return !state_->is_whole;
}

// Unpacks some more text; false where there is none.
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
