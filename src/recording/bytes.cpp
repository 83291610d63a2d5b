// SPDX-License-Identifier: MIT
#include "recording/bytes.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace edgecase::recording {

namespace {

constexpr unsigned kBits = 7;
// Deflate makes at most 1032 bytes of one: a stretch of some megabytes could ask for all memory.
constexpr std::uint64_t kLargestRatio = 1040;

const Bytef* data_of(std::string_view bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

}  // namespace

void write_size(std::uint64_t size, std::string& out) {
  for (; size >= (1u << kBits); size >>= kBits) out += static_cast<char>((size & 0x7f) | 0x80);
  out += static_cast<char>(size);
}

std::uint64_t read_size(std::string_view& bytes) {
  std::uint64_t size = 0;
  for (unsigned shift = 0; shift < 64 && !bytes.empty(); shift += kBits) {
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    size |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) return size;
  }
  throw std::runtime_error("a size does not end");
}

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, data_of(bytes), bytes.size(),
                Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("there is no memory to deflate");
  out.resize(size);
  return out;
}

void write_stretch(std::size_t size, std::string_view deflated, std::string& out) {
  write_size(size, out);
  write_size(deflated.size(), out);
  out += deflated;
}

void write_deflated(std::string_view bytes, std::string& out) {
  write_stretch(bytes.size(), deflated(bytes), out);
}

std::string read_deflated(std::string_view& bytes) {
  const std::uint64_t size = read_size(bytes);
  const std::uint64_t taken = read_size(bytes);
  if (taken > bytes.size() || size / kLargestRatio > taken)
    throw std::runtime_error("a stretch is longer than what there is");
  if (size > kLongestStretch)
    throw std::runtime_error(fmt::format("a stretch of {} bytes is longer than any may be", size));
  std::string out(size, '\0');
  uLongf written = out.size();
  if (uncompress(reinterpret_cast<Bytef*>(out.data()), &written, data_of(bytes), taken) != Z_OK ||
      written != size)
    throw std::runtime_error("a stretch cannot be inflated");
  bytes.remove_prefix(taken);
  return out;
}

std::uint32_t checksum(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(crc32_z(before, data_of(bytes), bytes.size()));
}

}  // namespace edgecase::recording
