// SPDX-License-Identifier: MIT
#include "reference/capture.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <numeric>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "model/rendering.h"
#include "reference/programs.h"
#include "reference/read_back.h"

namespace edgecase {

namespace {

// The capture shader's layout under std430: only scalars, so the alignment is 4 bytes throughout.
struct Record {
  std::int32_t x;
  std::int32_t y;
  std::int32_t primitive;
  float depth;
  float color[4];
};
static_assert(sizeof(Record) == 32);

// Four floats for a vec4, which std430 aligns to 16 bytes.
struct DetailedRecord : Record {
  float coordinates[4];
  float derivatives[kDerivatives][4];
};
static_assert(sizeof(DetailedRecord) == 144);

// Two floats for a vec2, which std430 aligns to 8 bytes.
struct TexturedRecord : DetailedRecord {
  float texture_coordinates[2];
  float level_of_detail[2];
};
static_assert(sizeof(TexturedRecord) == 160);

constexpr std::size_t kBytesOfWord = sizeof(std::uint32_t);
constexpr std::size_t kHeaderSize = 32;
constexpr std::uint32_t kFirstCapacity = 4096;
// 16.8 million fragments of 32 bytes: a 4096 x 4096 target covered once.
constexpr std::size_t kLargestSize = std::size_t{1} << 29;

// The driver's threads append in any order. Sorting by every bit of a record gives the same list
// each time.
template <class AnyRecord>
bool comes_before(const AnyRecord& a, const AnyRecord& b) {
  const auto place = [](const Record& r) { return std::tie(r.y, r.x, r.primitive); };
  if (place(a) != place(b)) return place(a) < place(b);
  return std::memcmp(&a, &b, sizeof(AnyRecord)) < 0;
}

// The sorted indices of the records; indices are smaller to sort. If there are enough records, and
// all lie within the target, they are first counted by pixel, so that only the few of each pixel
// have to be compared.
template <class AnyRecord>
std::vector<std::uint32_t> sorted(std::span<const AnyRecord> records, const Rendering& target) {
  std::vector<std::uint32_t> order(records.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    return comes_before(records[a], records[b]);
  };
  const std::size_t pixels = target.pixel_index(0, target.height);
  const auto column = [&](const Record& r) { return target.samples > 1 ? r.x & 0xffff : r.x; };
  const bool are_at_pixels = std::ranges::all_of(records, [&](const Record& r) {
    return column(r) >= 0 && column(r) < target.width && r.y >= 0 && r.y < target.height;
  });
  if (!are_at_pixels || pixels > 16 * records.size()) {
    std::sort(order.begin(), order.end(), before);
    return order;
  }
  const auto pixel = [&](std::uint32_t i) {
    return target.pixel_index(column(records[i]), records[i].y);
  };
  distribute(order, pixels, pixel);
  for (auto first = order.begin(); first != order.end();) {
    auto end = first + 1;
    while (end != order.end() && pixel(*end) == pixel(*first)) ++end;
    if (end - first > 1) std::sort(first, end, before);
    first = end;
  }
  return order;
}

// Fills a new fragment in its final place, since copying a freshly assembled one is slow.
void fill(const Record& record, bool multisampled, Fragment& fragment) {
  fragment.x = record.x;
  fragment.y = record.y;
  fragment.primitive = record.primitive;
  // Without multisampling, every fragment covers the single sample.
  if (multisampled) {
    fragment.x = record.x & 0xffff;
    fragment.coverage = static_cast<std::uint32_t>(record.x) >> 16;
  }
  fragment.depth = static_cast<double>(record.depth);
  for (std::size_t i = 0; i < fragment.color.size(); ++i)
    fragment.color[i] = static_cast<double>(record.color[i]);
}

template <std::size_t N>
std::array<double, N> to_doubles(const float (&numbers)[N]) {
  std::array<double, N> result;
  std::copy(std::begin(numbers), std::end(numbers), result.begin());
  return result;
}

FragmentDetail to_detail(const DetailedRecord& record, Details asked) {
  FragmentDetail detail;
  detail.coordinates = to_doubles(record.coordinates);
  for (std::size_t i = 0; i < kDerivatives && asked.derivatives; ++i)
    detail.derivatives[i] = to_doubles(record.derivatives[i]);
  return detail;
}

FragmentDetail to_detail(const TexturedRecord& record, Details asked) {
  FragmentDetail detail = to_detail(static_cast<const DetailedRecord&>(record), asked);
  detail.texture_coordinates = to_doubles(record.texture_coordinates);
  detail.level_of_detail = to_doubles(record.level_of_detail);
  return detail;
}

template <class AnyRecord>
void append(const AnyRecord& record, Details asked, Rendering& rendering) {
  Fragment& fragment = rendering.fragments.emplace_back();
  fill(record, rendering.samples > 1, fragment);
  if constexpr (!std::is_same_v<AnyRecord, Record>) {
    fragment.detail = static_cast<int>(rendering.details.size());
    rendering.details.push_back(to_detail(record, asked));
  }
}

template <class AnyRecord>
void append_words(std::span<const std::uint32_t> words, Details asked, Rendering& rendering) {
  AnyRecord record{};
  std::memcpy(&record, words.data(), std::min(words.size_bytes(), sizeof(record)));
  append(record, asked, rendering);
}

std::size_t size_of(Capture::Form form) {
  switch (form) {
    case Capture::Form::plain:
      return sizeof(Record);
    case Capture::Form::detailed:
      return sizeof(DetailedRecord);
    case Capture::Form::textured:
      return sizeof(TexturedRecord);
  }
  return sizeof(Record);
}

}  // namespace

std::size_t words_of(Capture::Form form) {
  return size_of(form) / kBytesOfWord;
}

std::vector<WordRange> detail_words(Capture::Form form, Details asked) {
  std::vector<WordRange> ranges;
  std::size_t first = words_of(Capture::Form::plain);
  const auto pass = [&](std::size_t bytes, bool is_asked) {
    const std::size_t end = first + bytes / kBytesOfWord;
    if (is_asked) ranges.push_back({first, end});
    first = end;
  };
  if (form == Capture::Form::plain) return ranges;
  pass(sizeof(DetailedRecord::coordinates), asked.coordinates);
  pass(sizeof(DetailedRecord::derivatives), asked.derivatives);
  if (form == Capture::Form::textured) pass(sizeof(TexturedRecord) - sizeof(DetailedRecord), true);
  return ranges;
}

void append_record(Capture::Form form, std::span<const std::uint32_t> words, Details asked,
                   Rendering& rendering) {
  switch (form) {
    case Capture::Form::plain:
      return append_words<Record>(words, asked, rendering);
    case Capture::Form::detailed:
      return append_words<DetailedRecord>(words, asked, rendering);
    case Capture::Form::textured:
      return append_words<TexturedRecord>(words, asked, rendering);
  }
}

Capture::Capture(const GladGLContext& gl, Form form)
    : gl_(gl), form_(form), buffer_(make_buffer(gl)) {
  // Some drivers report 2^32 - 1, which does not fit a GLint.
  GLint64 block_size = 0;
  gl_.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block_size);
  const std::size_t bytes = block_size > 0 ? static_cast<std::size_t>(block_size) : 0;
  if (bytes > kHeaderSize)
    limit_ =
        static_cast<std::uint32_t>(std::min(bytes - kHeaderSize, kLargestSize) / size_of(form_));
  grow(std::min(kFirstCapacity, limit_));
}

void Capture::grow(std::uint32_t count) {
  capacity_ = count;
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_.name());
  gl_.BufferData(GL_SHADER_STORAGE_BUFFER,
                 static_cast<GLsizeiptr>(kHeaderSize + capacity_ * size_of(form_)), nullptr,
                 GL_DYNAMIC_READ);
}

void Capture::begin() {
  lost_ = false;
  const std::uint32_t zero = 0;
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kCaptureBinding, buffer_.name());
  gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(zero), &zero);
}

std::uint32_t Capture::count() {
  std::uint32_t result = 0;
  gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_.name());
  if (!read_storage(gl_, 0, sizeof(result), &result)) lost_ = true;
  return result;
}

template <class AnyRecord>
void Capture::read_records(std::uint32_t count, Details asked, Rendering& rendering) {
  // Zeros, since a GL that raises an error leaves them unwritten.
  std::vector<AnyRecord> records(count);
  if (count > 0 && !read_storage(gl_, kHeaderSize, count * sizeof(AnyRecord), records.data())) {
    lost_ = true;
    return;
  }
  constexpr bool kDetailed = !std::is_same_v<AnyRecord, Record>;
  rendering.fragments.reserve(count);
  rendering.details.reserve(kDetailed ? count : 0);
  for (const std::uint32_t i : sorted<AnyRecord>(records, rendering))
    append(records[i], asked, rendering);
}

void Capture::read(std::uint32_t count, Details asked, Rendering& rendering) {
  switch (form_) {
    case Form::plain:
      read_records<Record>(count, asked, rendering);
      break;
    case Form::detailed:
      read_records<DetailedRecord>(count, asked, rendering);
      break;
    case Form::textured:
      read_records<TexturedRecord>(count, asked, rendering);
      break;
  }
  // Records were sorted with the coverage as a part of x.
  if (rendering.samples > 1) sort_fragments(rendering);
}

}  // namespace edgecase
