// SPDX-License-Identifier: MIT
#include "reference/capture.h"

#include <algorithm>
#include <cstring>
#include <tuple>

#include "reference/programs.h"

namespace edgecase {

namespace {

// As the capture shader lays it out under std430: scalars only, so 4-byte alignment throughout.
struct Record {
  std::int32_t x;
  std::int32_t y;
  std::int32_t primitive;
  float depth;
  float color[4];
};
static_assert(sizeof(Record) == 32);

constexpr std::size_t kHeaderSize = 32;
constexpr std::uint32_t kFirstCapacity = 4096;
// 16.8 million fragments, a 4096 x 4096 target covered once: 512 MiB.
constexpr std::uint32_t kLargestCapacity = std::uint32_t{1} << 24;

// The order in which a driver's threads append is theirs. Sorting by every bit of a record makes
// the list the same each time.
bool comes_before(const Record& a, const Record& b) {
  const auto place = [](const Record& r) { return std::tie(r.y, r.x, r.primitive); };
  if (place(a) != place(b)) return place(a) < place(b);
  return std::memcmp(&a, &b, sizeof(Record)) < 0;
}

Fragment to_fragment(const Record& record) {
  Fragment fragment;
  fragment.x = record.x;
  fragment.y = record.y;
  fragment.primitive = record.primitive;
  // Targets are single-sampled: a fragment that exists covers the one sample.
  fragment.coverage = 1;
  fragment.depth = static_cast<double>(record.depth);
  std::copy(std::begin(record.color), std::end(record.color), fragment.color.begin());
  return fragment;
}

}  // namespace

Capture::Capture(const GladGLContext& gl) : gl_(gl), buffer_(make_buffer(gl)) {
  GLint block_size = 0;
  gl_.GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block_size);
  const std::size_t bytes = block_size > 0 ? static_cast<std::size_t>(block_size) : 0;
  if (bytes > kHeaderSize)
    limit_ = static_cast<std::uint32_t>(
        std::min<std::size_t>((bytes - kHeaderSize) / sizeof(Record), kLargestCapacity));
  grow(std::min(kFirstCapacity, limit_));
}

void Capture::grow(std::uint32_t count) {
  capacity_ = count;
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_.name());
  gl_.BufferData(GL_SHADER_STORAGE_BUFFER,
                 static_cast<GLsizeiptr>(kHeaderSize + capacity_ * sizeof(Record)), nullptr,
                 GL_DYNAMIC_READ);
}

void Capture::begin() {
  const std::uint32_t zero = 0;
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kCaptureBinding, buffer_.name());
  gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(zero), &zero);
}

std::uint32_t Capture::count() {
  std::uint32_t result = 0;
  gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_.name());
  gl_.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(result), &result);
  return result;
}

std::vector<Fragment> Capture::read(std::uint32_t count) {
  std::vector<Record> records(count);
  if (count > 0)
    gl_.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, kHeaderSize,
                         static_cast<GLsizeiptr>(count * sizeof(Record)), records.data());
  std::sort(records.begin(), records.end(), comes_before);
  std::vector<Fragment> fragments(count);
  std::transform(records.begin(), records.end(), fragments.begin(), to_fragment);
  return fragments;
}

}  // namespace edgecase
